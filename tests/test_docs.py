"""The pages of docs/: their code runs, their pictures are what it draws, their tables are true."""

import inspect
import re
import runpy
from pathlib import Path

import pytest

import bgi
from bgi.memory.sdl import pygame

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
MAKER = runpy.run_path(str(DOCS / "make_pictures.py"))
PAGES = MAKER["pages"]()
TEXTS = [page.read_text("utf-8") for page in sorted(DOCS.glob("*.md"))]
BLOCKS = [(page.stem, code, picture) for page in PAGES for code, picture in MAKER["blocks"](page)]

FUNCTIONS = sorted(name for name in bgi.__all__ if inspect.isfunction(getattr(bgi, name)))
# The calls whose effect can be seen.
SHOWN = """
    putpixel getpixel line lineto linerel rectangle drawpoly setlinestyle setwritemode
    circle arc ellipse pieslice sector fillellipse getarccoords setaspectratio
    setfillstyle setfillpattern bar bar3d fillpoly floodfill
    outtext outtextxy settextstyle settextjustify setusercharsize textwidth textheight
    getimage putimage setcolor setbkcolor setallpalette setrgbpalette
    setviewport clearviewport swapbuffers initwindow COLOR
"""


def row(name):
    """A call's line in a table: how it is written, and its docstring's first sentence."""
    function = getattr(bgi, name)
    parameters = inspect.signature(function).parameters.values()
    written = ", ".join(
        p.name if p.default is p.empty else f"{p.name}={p.default!r}" for p in parameters
    )
    summary = " ".join(inspect.getdoc(function).split("\n\n")[0].split())
    return f"| `{name}({written})` | {summary.partition(' Source: ')[0]} |"


def look(file):
    """A picture's size and colours."""
    surface = pygame.image.load(file)
    return surface.get_size(), pygame.image.tobytes(surface, "RGB")


def test_the_pictures_are_what_the_code_draws(tmp_path, monkeypatch):
    monkeypatch.setenv("BGI_KEYS", "")  # main() sets its own: restored afterwards
    names = MAKER["main"](tmp_path)
    assert len(names) == len(set(names)) > 40
    different = [n for n in names if look(tmp_path / n) != look(DOCS / "pictures" / n)]
    assert not different, "run: python docs/make_pictures.py"


@pytest.mark.parametrize(
    ("page", "code"), [(page, code) for page, code, picture in BLOCKS if picture is None]
)
def test_code_without_a_picture_runs(monkeypatch, page, code):
    monkeypatch.setenv("BGI_KEYS", "a Left Up Space")
    MAKER["run"](code)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_call_stands_in_the_table_of_one_page(name):
    rows = [line for text in TEXTS for line in text.splitlines() if line.startswith(f"| `{name}(")]
    assert rows == [row(name)]


@pytest.mark.parametrize("name", SHOWN.split())
def test_every_call_that_can_be_seen_is_seen(name):
    assert any(picture and re.search(rf"\b{name}\(", code) for _, code, picture in BLOCKS)


@pytest.mark.parametrize("file", [ROOT / "README.md", *sorted(DOCS.glob("*.md"))], ids=str)
def test_every_link_leads_to_a_file(file):
    text = file.read_text("utf-8")
    links = re.findall(r"\]\(([^)#\s]+)", text) + re.findall(r'src="([^"]+)"', text)
    missing = [n for n in links if "://" not in n and not (file.parent / n).exists()]
    assert not missing


def test_the_index_names_every_page():
    index = (DOCS / "README.md").read_text("utf-8")
    assert all(f"]({page.name})" in index for page in PAGES)
