"""The site's pages: the documentation, whose code runs, and the gallery."""

import html
import re
import shutil
from collections.abc import Iterable
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.token import Token

from gallery.catalogue import Demo
from tools import pictures, sheet

DOCS = pictures.DOCS
ROOT = pictures.ROOT
PAGE = Path(__file__).with_name("page")

_FIRST_PAGE = ROOT / "README.md", ROOT / "demos" / "README.md"
_LESSON = re.compile(r"\]\(../../(demos/course/\d\d_\w+\.py)\)(?:.+\n)*")
WHOLE = "python whole"
"""How a program is marked that follows nothing on its page."""


def write_docs(folder: Path) -> None:
    """Write each page of docs/ as HTML."""
    for page in pictures.texts():
        text = page.read_text("utf-8")
        title = text.partition("\n")[0].lstrip("# ")
        body = _html(page, _with_program(text))
        written = _filled("page.html", TITLE=html.escape(title), ROOT=_to_root(page), BODY=body)
        file = folder / "docs" / page.relative_to(DOCS).with_suffix(".html")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(written, encoding="utf-8")
    shutil.copy(sheet.FILE, folder / "docs")


def write_gallery(folder: Path, demos: Iterable[Demo]) -> None:
    """Write the first page, and beside it the programs that it shows."""
    (folder / "programs").mkdir()
    cards = []
    for demo in demos:
        shutil.copy(demo.file, folder / "programs")
        cards.append(
            f'<a href="#{demo.name}" data-demo="{demo.name}" data-file="{demo.file.name}">'
            f'<img src="pictures/{demo.name}.png" alt="" loading="lazy">'
            f"<b>{demo.name}</b><span>{html.escape(demo.summary)}</span></a>"
        )
    written = _filled("index.html", DEMOS="\n".join(cards))
    (folder / "index.html").write_text(written, encoding="utf-8")


def _filled(name: str, **parts: str) -> str:
    text = (PAGE / name).read_text("utf-8")
    for place, part in parts.items():
        text = text.replace(f"@{place}@", part)
    return text


def _to_root(page: Path) -> str:
    """How a page leads to the site's first one."""
    return "../" * len(page.relative_to(DOCS).parts)


def _with_program(text: str) -> str:
    """A lesson with its program below the lines that speak of it."""

    def shown(found: re.Match[str]) -> str:
        program = (ROOT / found[1]).read_text("utf-8")
        return f"{found[0]}\n```{WHOLE}\n{program}```\n"

    return _LESSON.sub(shown, text)


def _html(page: Path, text: str) -> str:
    """A page of Markdown as HTML; its programs are marked, so that the page can run them."""
    markdown = MarkdownIt("commonmark").enable("table")
    tokens = markdown.parse(text)
    before = _before(text)
    for token, following in zip(tokens, [*tokens[1:], None], strict=True):
        if token.type == "heading_open" and following is not None:
            token.attrSet("id", _anchor(following.content))
        if token.type == "fence" and token.info == WHOLE:
            token.type, token.content = "html_block", _program("", token.content)
        elif token.type == "fence" and token.info == "python":
            code = token.content
            token.type, token.content = "html_block", _program(before, code)
            if pictures.IN_ORDER in text:
                before += code
            elif pictures.NAMES_STAY.search(text):
                before += f"{code}initgraph(VGA, VGAHI)\n"
        elif token.type == "fence" and token.info == "c":
            token.type, token.content = "html_block", _program("", token.content, "PROGRAM.C")
        _lead(page, token.children or [])
    rendered: str = markdown.renderer.render(tokens, markdown.options, {})
    return rendered


def _program(before: str, code: str, name: str = "program.py") -> str:
    given = f'data-name="{name}" data-before="{html.escape(before)}"'
    return f'<pre class="runs" {given}>{html.escape(code)}</pre>\n'


def _before(text: str) -> str:
    """What the programs of a page follow, as the page says and `tools.pictures` runs them."""
    if header := pictures.ON_TEXT.search(text):
        return f"from bgi.{header[1]} import *\n"
    if pictures.ON_A_SCREEN in text:
        return "from bgi import *; initgraph(VGA, VGAHI)\n"
    return ""


def _anchor(heading: str) -> str:
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def _lead(page: Path, tokens: list[Token]) -> None:
    """Have links and pictures lead to where that is on the site, or nowhere."""
    tag = ""
    for token in tokens:
        if token.type == "image":
            token.attrSet("src", f"../{token.attrGet('src')}")
        elif token.type == "link_open":
            target = _target(page, str(token.attrGet("href")))
            token.attrs = {"href": target} if target else {}
            token.tag = tag = "a" if target else "span"
        elif token.type == "link_close":
            token.tag = tag


def _target(page: Path, link: str) -> str:
    """Where a link of the repository leads on the site; "" for what is not there."""
    if link.startswith(("https:", "#")):
        return link
    path, mark, place = link.partition("#")
    file = (page.parent / path).resolve()
    if file in _FIRST_PAGE:
        return f"{_to_root(page)}index.html"
    if file == sheet.FILE:
        return path
    if file in pictures.texts():
        return f"{path.removesuffix('.md')}.html{mark}{place}"
    demo = re.fullmatch(r"\d+_(\w+)\.py", file.name)
    if demo and file.parent == ROOT / "demos":
        return f"{_to_root(page)}index.html#{demo[1]}"
    return ""
