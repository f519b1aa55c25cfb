"""The pages of docs/: their code runs, their pictures are what it draws, their tables are true."""

import re
from pathlib import Path

import pytest

from bgi.memory.sdl import pygame
from gallery.catalogue import NAMES
from tools import a_to_z, pictures

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
PAGES = pictures.pages()
TEXTS = [page.read_text("utf-8") for page in sorted(DOCS.glob("*.md")) if page != a_to_z.FILE]
BLOCKS = [block for page in PAGES for block in pictures.blocks(page)]

DOCUMENTED = a_to_z.documented()
# The calls whose effect can be seen.
SHOWN = """
    putpixel getpixel line lineto linerel rectangle drawpoly setlinestyle setwritemode
    circle arc ellipse pieslice sector fillellipse getarccoords setaspectratio
    setfillstyle setfillpattern bar bar3d fillpoly floodfill
    outtext outtextxy settextstyle settextjustify setusercharsize textwidth textheight
    getimage putimage setcolor setbkcolor setallpalette setrgbpalette
    setviewport clearviewport swapbuffers initwindow COLOR
"""


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


@pytest.mark.parametrize("name", DOCUMENTED)
def test_every_call_stands_in_the_table_of_one_page(name):
    rows = [line for text in TEXTS for line in text.splitlines() if line.startswith(f"| `{name}`")]
    assert rows == [a_to_z.row(name, DOCUMENTED[name])]


@pytest.mark.parametrize("name", SHOWN.split())
def test_every_call_that_can_be_seen_is_seen(name):
    assert any(picture and re.search(rf"\b{name}\(", code) for code, picture in BLOCKS)


@pytest.mark.parametrize("file", [ROOT / "README.md", *sorted(DOCS.glob("*.md"))], ids=str)
def test_every_link_leads_to_a_file(file):
    text = file.read_text("utf-8")
    links = re.findall(r"\]\(([^)#\s]+)", text) + re.findall(r'src="([^"]+)"', text)
    missing = [n for n in links if "://" not in n and not (file.parent / n).exists()]
    assert not missing


class TestIndex:
    def test_names_every_page(self):
        pages = sorted(DOCS.glob("*.md"))
        assert sorted([*a_to_z.index(), a_to_z.FILE, DOCS / "README.md"]) == pages
        assert f"]({a_to_z.FILE.name})" in (DOCS / "README.md").read_text("utf-8")

    def test_calls_pages_by_their_headings(self):
        index = (DOCS / "README.md").read_text("utf-8")
        for page in a_to_z.index():
            assert f"[{a_to_z.title(page)}]({page.name})" in index

    def test_every_page_leads_on_and_back(self):
        for page, line in a_to_z.last_lines().items():
            assert page.read_text("utf-8").endswith(f"\n\n{line}\n"), "run: python -m tools.a_to_z"


class TestAToZ:
    TEXT = a_to_z.FILE.read_text("utf-8")

    def test_is_what_the_docstrings_say(self):
        assert a_to_z.text() == self.TEXT, "run: python -m tools.a_to_z"

    def test_its_rows_have_three_cells(self):
        rows = [line for line in self.TEXT.splitlines() if line.startswith("|")]
        assert all(row.count("|") == 4 for row in rows)

    @pytest.mark.parametrize("prefix", a_to_z.MODULES)
    def test_has_every_name(self, prefix):
        listed = {re.split(r"[ (`]", line[3:])[0] for line in self.TEXT.splitlines()}
        for name in a_to_z.MODULES[prefix].__all__:
            assert {prefix + name, name} & listed, name
