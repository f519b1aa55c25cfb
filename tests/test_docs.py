"""The pages of docs/: their code runs, their pictures are what it draws, their tables are true."""

import inspect
import re
from pathlib import Path

import pytest

import bgi
from bgi.memory.sdl import pygame
from gallery.catalogue import NAMES
from tools import pictures

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
PAGES = pictures.pages()
TEXTS = [page.read_text("utf-8") for page in sorted(DOCS.glob("*.md"))]
BLOCKS = [block for page in PAGES for block in pictures.blocks(page)]

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


def assert_drawn(names, folder):
    """Fail unless pictures are those of the documentation, pixel for pixel."""
    different = [n for n in names if look(folder / n) != look(pictures.PICTURES / n)]
    assert not different, "run: python -m tools.pictures"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_code_of_a_page_runs_and_draws_its_pictures(tmp_path, monkeypatch, page):
    monkeypatch.setenv("BGI_KEYS", pictures.KEYS)
    assert_drawn(pictures.draw_page(page, tmp_path), tmp_path)


@pytest.mark.parametrize("name", NAMES)
def test_the_picture_of_a_demo_is_what_it_draws(tmp_path, name):
    assert_drawn(pictures.draw_demo(name, tmp_path), tmp_path)


def test_every_picture_has_its_code():
    drawn = [picture for _, picture in BLOCKS if picture] + [f"{name}.png" for name in NAMES]
    assert sorted(drawn) == sorted(file.name for file in pictures.PICTURES.iterdir())


def test_every_picture_of_a_page_belongs_to_code():
    for page in PAGES:
        shown = re.findall(r"!\[[^]]*\]\(pictures/(.*?)\)", page.read_text("utf-8"))
        assert shown == [picture for _, picture in pictures.blocks(page) if picture], page.name


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_call_stands_in_the_table_of_one_page(name):
    rows = [line for text in TEXTS for line in text.splitlines() if line.startswith(f"| `{name}(")]
    assert rows == [row(name)]


@pytest.mark.parametrize("name", SHOWN.split())
def test_every_call_that_can_be_seen_is_seen(name):
    assert any(picture and re.search(rf"\b{name}\(", code) for code, picture in BLOCKS)


@pytest.mark.parametrize("file", [ROOT / "README.md", *sorted(DOCS.glob("*.md"))], ids=str)
def test_every_link_leads_to_a_file(file):
    text = file.read_text("utf-8")
    links = re.findall(r"\]\(([^)#\s]+)", text) + re.findall(r'src="([^"]+)"', text)
    missing = [n for n in links if "://" not in n and not (file.parent / n).exists()]
    assert not missing


def test_the_index_names_every_page():
    index = (DOCS / "README.md").read_text("utf-8")
    assert all(f"]({page.name})" in index for page in PAGES)
