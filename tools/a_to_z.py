"""Write the A-Z page of the documentation, and what on the other pages follows from elsewhere.

    python -m tools.a_to_z

What a name is, its docstring says. Functions, structures and the options of `surface` each have a
row in a table of one page; write `| `circle` |` there, and this fills it in. Constants come in
groups: what they are stands in the source, and GROUPS says which page shows them. The last line of
each page leads to the next one and back. tests/test_docs.py holds the pages to all this.
"""

import ast
import inspect
import math
import re
from collections.abc import Iterator
from itertools import groupby, pairwise
from pathlib import Path
from typing import Any, NamedTuple

import bgi
import surfaces
from bgi import bios, conio, dos, keyboard, mouse, stdio, stdlib

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
FILE = DOCS / "a-z.md"

BACK = f"[All pages](README.md) · [A–Z]({FILE.name})"
"""What every page ends with."""

MODULES = {
    "": bgi,
    "bios.": bios,
    "conio.": conio,
    "dos.": dos,
    "keyboard.": keyboard,
    "mouse.": mouse,
    "stdio.": stdio,
    "stdlib.": stdlib,
    "surfaces.": surfaces,
}
"""The modules whose names are listed, by what a program writes before a name."""

GROUPS = {
    "A driver, for initgraph.": "screen",
    "A mode of a driver, for initgraph.": "screen",
    "What graphresult() may return.": "errors",
    "A colour: its index in the palette.": "colours",
    "Added to a colour, makes text blink: in text modes only.": "colours",
    "A text mode.": "textscreen",
    "A shape of the text cursor, for _setcursortype.": "textscreen",
    "A colour in one of the CGA's four palettes.": "colours",
    "A hardware colour of the EGA and VGA, for setpalette.": "colours",
    "A style or width of lines, for setlinestyle.": "lines",
    "A fill pattern, for setfillstyle.": "fills",
    "How putimage meets what is there; setwritemode takes the first two.": "images",
    "A font, direction, size or justification of text.": "text",
    "A linked-in driver or font, for registerbgidriver and registerbgifont.": "screen",
    "A window by number, for closewindow.": "windows",
    "A kind of event of the mouse: WinBGIm's, which are Windows' messages.": "mouse",
    "A button of the mouse.": "mouse",
    "What ungetch() returns when it cannot.": "keys",
    "What C returns when the input has ended before anything was read.": "stdio",
    "What clock() counts in a second: the PC's timer ticks.": "time",
    "The largest number that rand() returns.": "time",
}
"""The page of each group of constants, by the words above the group."""

SOURCES = {
    "": ["bgi/constants.py"],
    "bios.": [],
    "conio.": ["bgi/constants.py", "bgi/conio/__init__.py", "bgi/conio/keys.py"],
    "dos.": ["bgi/dos.py"],
    "keyboard.": [],
    "mouse.": ["bgi/monitor/pointer.py"],
    "stdio.": ["bgi/clib/scanf.py"],
    "stdlib.": ["bgi/stdlib.py"],
    "surfaces.": [],
}
"""The files that define the constants of each module."""

STAR_LACKS = {
    "dos.": ["CLK_TCK", "CLOCKS_PER_SEC", "Sleep", "clock", "time"],
    "stdlib.": ["random"],
}
"""Public names that `from bgi.dos import *` and its like do not bring."""

STARS = {inspect.Parameter.VAR_POSITIONAL: "*", inspect.Parameter.VAR_KEYWORD: "**"}

HEAD = """# A–Z

Every public name: functions, structures, constants, and the options of `surface()`; with the page
that shows it. Names without a dot come with `from bgi import *`; `bios`, `conio`, `dos`,
`keyboard`, `mouse`, `stdio` and `stdlib` are modules of it: `from bgi import dos`. `surfaces` is a
package of its own. `help(circle)` says more.
"""


ROW = re.compile(r"^\| `(?P<name>[\w.]+(?:=|(?=[(`])))[^`]*` \|(?P<what>[^|\n]*)\|$", re.MULTILINE)
"""A line of a table of two columns: a name, or that of an option with its =, and what it is."""


class Described(NamedTuple):
    """What a docstring says of a name."""

    written: str
    """How a program writes it: `circle(x, y, radius, color=None)`."""
    what: str
    """What it is or does, in one sentence."""

    def __str__(self) -> str:
        return f"| `{self.written}` | {self.what} |"


def names(prefix: str) -> list[str]:
    """The public names of a module."""
    return [*MODULES[prefix].__all__, *STAR_LACKS.get(prefix, [])]


# What is said of the names


def described() -> dict[str, Described]:
    """What docstrings say: of functions, structures, exceptions, and the options of surface()."""
    found: dict[str, Described] = {}
    known: list[Any] = []
    for prefix, module in MODULES.items():
        for name in names(prefix):
            value = getattr(module, name)
            if callable(value) and value not in known:  # getch is in bgi and in bgi.conio
                known.append(value)
                found[prefix + name] = Described(written(prefix + name, value), sentence(value))
    return found | options(surfaces.surface)


def written(name: str, value: Any) -> str:
    """A call of a function or a structure as a program writes it; many options are three dots."""
    if isinstance(value, type) and issubclass(value, Exception):
        return name
    parameters = list(inspect.signature(value).parameters.values())
    if isinstance(value, type) and all(p.kind in STARS for p in parameters):
        return name  # not to be called, only to be derived from
    keywords = [p for p in parameters if p.kind == p.KEYWORD_ONLY]
    inside = [with_default(p) for p in parameters if len(keywords) <= 4 or p not in keywords]
    return f"{name}({', '.join(inside)}{', ...' if len(keywords) > 4 else ''})"


def with_default(parameter: inspect.Parameter) -> str:
    """A parameter as it is written: `fill=None`."""
    if parameter.kind in STARS:
        return STARS[parameter.kind] + parameter.name
    if parameter.default is parameter.empty:
        return parameter.name
    default = "pi / 4" if parameter.default == math.pi / 4 else repr(parameter.default)
    return f"{parameter.name}={default}"


def sentence(value: Any) -> str:
    """The first sentence of a docstring."""
    first = " ".join((inspect.getdoc(value) or "").split("\n\n")[0].split())
    return first.partition(" Source: ")[0]


def options(function: Any) -> dict[str, Described]:
    """The parameters of a function as `n=`, and what its docstring says of each."""
    arguments = (inspect.getdoc(function) or "").partition("Args:\n")[2].partition("\n\n")[0]
    said = dict(re.findall(r"^    (\w+): (.*(?:\n {8}.*)*)", arguments, re.MULTILINE))
    found = {}
    for name, parameter in inspect.signature(function).parameters.items():
        option = name if parameter.default is parameter.empty else f"{name}="
        found[option] = Described(with_default(parameter), " ".join(said[name].split()))
    return found


def said_of_constants(source: Path) -> dict[str, str]:
    """What a file says of its constants: below each, or above its group."""
    text = source.read_text("utf-8")
    said = {}
    body = ast.parse(text).body
    for statement, after in zip(body, [*body[1:], None], strict=True):
        if not isinstance(statement, (ast.Assign, ast.AnnAssign)):
            continue
        if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant):
            words = str(after.value.value)
        else:
            above = text.splitlines()[: statement.lineno - 1]
            words = next((line[2:] for line in reversed(above) if line.startswith("# ")), "")
            words = re.sub(r" \([\w, ]+\)$", "", words) + "."  # without C's name of the group
        targets = [statement.target] if isinstance(statement, ast.AnnAssign) else statement.targets
        names = [node for target in targets for node in ast.walk(target)]
        said.update({node.id: words for node in names if isinstance(node, ast.Name)})
    return said


# The pages


def index() -> list[Path]:
    """The pages in the order in which to read them: that of docs/README.md."""
    names = re.findall(r"\]\(([\w-]+\.md)\)", (DOCS / "README.md").read_text("utf-8"))
    return [DOCS / name for name in names if name != FILE.name]


def title(page: Path) -> str:
    """The heading of a page."""
    return page.read_text("utf-8").partition("\n")[0].removeprefix("# ")


def renewed(page: Path) -> str:
    """The text of a page with its rows as the docstrings have them, and its last line."""
    said = described()
    pages = index()
    after = dict(pairwise(pages)).get(page)
    onward = f"Next: [{title(after)}]({after.name}) · " if after else ""

    def row(found: re.Match[str]) -> str:
        return str(said.get(found["name"], found[0]))

    text = page.read_text("utf-8").rstrip("\n")
    above, _, last = text.rpartition("\n\n")
    return f"{ROW.sub(row, above if BACK in last else text)}\n\n{onward}{BACK}\n"


def shown() -> dict[str, tuple[str, str]]:
    """The page whose table has a name, and what stands there."""
    return {
        found["name"]: (page.stem, found["what"].strip())
        for page in index()
        for found in ROW.finditer(page.read_text("utf-8"))
    }


def lines() -> Iterator[tuple[str, str]]:
    """Every name and its line on the A-Z page."""
    pages = shown()
    for name, (written, what) in described().items():
        if "." not in name and not hasattr(bgi, name):
            what = f"Option of `surface()`: {what}"
        yield name, line(written, what, pages[name][0])
    for prefix, module in MODULES.items():
        said = {k: v for file in SOURCES[prefix] for k, v in said_of_constants(ROOT / file).items()}
        for name in names(prefix):
            value = getattr(module, name)
            if prefix and name in bgi.__all__:
                continue  # RED is that of bgi
            if isinstance(value, (int, float, str)):
                yield name, line(f"{prefix}{name} = {value!r}", said[name], GROUPS[said[name]])
            elif not callable(value):
                page, what = pages[prefix + name]  # a table: no docstring describes it
                yield name, line(prefix + name, what, page)


def line(written: str, what: str, page: str) -> str:
    """A line of the A-Z page."""
    return f"| `{written}` | {what} | [{page}]({page}.md) |"


def key(name: str) -> str:
    """What a name is sorted by: itself without its module."""
    return name.rpartition(".")[2].lstrip("_").lower()


def text() -> str:
    """The A-Z page."""
    page = [HEAD]
    found = sorted(lines(), key=lambda pair: (key(pair[0]), pair[1]))
    for letter, group in groupby(found, key=lambda pair: key(pair[0])[0].upper()):
        page += [f"## {letter}\n", "| name | what it is | page |", "|---|---|---|"]
        page += [*(line for _, line in group), ""]
    return "\n".join(page)


def main() -> None:
    """Renew the pages, and write the A-Z page."""
    for page in index():
        page.write_text(renewed(page), "utf-8", newline="\n")
    FILE.write_text(text(), "utf-8", newline="\n")


if __name__ == "__main__":
    main()
