"""Write the A-Z page of the documentation, and the last line of every page, which leads to it.

    python -m tools.a_to_z

What a name is, its docstring says; the page that shows it has a row for it in a table. Constants
come in groups: what they are stands in the source, below each or above the group, and GROUPS says
which page shows them. tests/test_docs.py holds the pages to it.
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
from bgi import conio, dos, mouse

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
FILE = DOCS / "a-z.md"

BACK = f"[All pages](README.md) · [A–Z]({FILE.name})"
"""What every page ends with."""

MODULES = {"": bgi, "conio.": conio, "dos.": dos, "mouse.": mouse}
"""The modules whose names are listed, by what a program writes before a name."""

GROUPS = {
    "A driver, for initgraph.": "screen",
    "A mode of a driver, for initgraph.": "screen",
    "What graphresult() may return.": "errors",
    "A colour: its index in the palette.": "colours",
    "Added to a colour, makes text blink: in text modes only.": "colours",
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
    "What clock() counts in a second: the PC's timer ticks.": "time",
    "The largest number that rand() returns.": "time",
}
"""The page of each group of constants, by the words above the group."""

SOURCES = {
    "": ["bgi/constants.py"],
    "conio.": ["bgi/conio.py"],
    "dos.": ["bgi/dos.py"],
    "mouse.": ["bgi/monitor/pointer.py"],
}
"""The files that define the constants of each module."""

STARRED = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)

HEAD = """# A–Z

Every public name: functions, structures and constants, with the page that shows it.
Names without a dot come with `from bgi import *`; `conio`, `dos` and `mouse` are modules of it:
`from bgi import dos`. `help(circle)` says more.
"""


class Entry(NamedTuple):
    """A line of the page."""

    name: str
    written: str
    """How a program writes it: `circle(x, y, radius, color=None)`, `RED = 4`."""
    what: str
    """What it is or does, in one sentence."""
    page: str
    """The page that shows it, without its ending."""

    @property
    def key(self) -> str:
        """What the line is sorted by: the name without its module."""
        return self.name.rpartition(".")[2].lstrip("_").lower()

    def __str__(self) -> str:
        return f"| `{self.written}` | {self.what} | [{self.page}]({self.page}.md) |"


# The pages


def index() -> list[Path]:
    """The pages in the order in which to read them: that of docs/README.md."""
    names = re.findall(r"\]\(([\w-]+\.md)\)", (DOCS / "README.md").read_text("utf-8"))
    return [DOCS / name for name in names if name != FILE.name]


def title(page: Path) -> str:
    """The heading of a page."""
    return page.read_text("utf-8").partition("\n")[0].removeprefix("# ")


def last_lines() -> dict[Path, str]:
    """The last line of every page: on to the next one, and back."""
    pages = index()
    onward = {page: f"Next: [{title(after)}]({after.name}) · " for page, after in pairwise(pages)}
    return {page: f"{onward.get(page, '')}{BACK}" for page in pages}


def shown() -> dict[str, str]:
    """The page that shows a function or an option, by how its row in a table there begins."""
    return {
        row.partition("` |")[0].removeprefix("| `"): page.stem
        for page in index()
        for row in page.read_text("utf-8").splitlines()
        if row.startswith("| `")
    }


# The names


def documented() -> dict[str, Any]:
    """What is described by a docstring: functions, structures, exceptions; by how it is written."""
    found: dict[str, Any] = {}
    for prefix, module in MODULES.items():
        for name in module.__all__:
            value = getattr(module, name)
            if callable(value) and value not in found.values():
                found[written(prefix + name, value)] = value
    return found


def written(name: str, value: Any) -> str:
    """A call of a function or a structure as a program writes it; many options are three dots."""
    if isinstance(value, type) and issubclass(value, Exception):
        return name
    parameters = list(inspect.signature(value).parameters.values())
    if isinstance(value, type) and all(p.kind in STARRED for p in parameters):
        return name  # not to be called, only to be derived from
    options = [p for p in parameters if p.kind == p.KEYWORD_ONLY]
    inside = [with_default(p) for p in parameters if len(options) <= 4 or p not in options]
    return f"{name}({', '.join(inside)}{', ...' if len(options) > 4 else ''})"


def with_default(parameter: inspect.Parameter) -> str:
    """A parameter as it is written: `fill=None`."""
    if parameter.kind in STARRED:
        return f"*{parameter.name}"
    if parameter.default is parameter.empty:
        return parameter.name
    default = "pi / 4" if parameter.default == math.pi / 4 else repr(parameter.default)
    return f"{parameter.name}={default}"


def sentence(value: Any) -> str:
    """The first sentence of a docstring."""
    first = " ".join((inspect.getdoc(value) or "").split("\n\n")[0].split())
    return first.partition(" Source: ")[0]


def row(name: str, value: Any) -> str:
    """The line of a function or a structure in the table of its page."""
    return f"| `{name}` | {sentence(value)} |"


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


def entries() -> Iterator[Entry]:
    """A line for every name."""
    pages = shown()
    for name, value in documented().items():
        yield Entry(name, name, sentence(value), pages[name])
    for prefix, module in MODULES.items():
        said = {k: v for file in SOURCES[prefix] for k, v in said_of_constants(ROOT / file).items()}
        for name in module.__all__:
            value = getattr(module, name)
            if isinstance(value, (int, float, str)):
                yield Entry(name, f"{prefix}{name} = {value!r}", said[name], GROUPS[said[name]])
            elif not callable(value):
                yield Entry(name, prefix + name, said[name], pages[prefix + name])


def text() -> str:
    """The A-Z page."""
    lines = [HEAD]
    found = sorted(entries(), key=lambda entry: (entry.key, entry.written))
    for letter, group in groupby(found, key=lambda entry: entry.key[0].upper()):
        lines += [f"## {letter}\n", "| name | what it is | page |", "|---|---|---|"]
        lines += [*map(str, group), ""]
    return "\n".join(lines)


def main() -> None:
    """Write the page, and the last lines of the others."""
    FILE.write_text(text(), "utf-8")
    for page, line in last_lines().items():
        above = page.read_text("utf-8").rstrip().split("\n")
        if BACK in above[-1]:
            del above[-2:]
        page.write_text("\n".join([*above, "", line, ""]), "utf-8")


if __name__ == "__main__":
    main()
