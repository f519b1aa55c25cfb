"""The pages of docs/: their code runs, their pictures are what it draws, their tables are true."""

import re
import tomllib
from pathlib import Path

import pytest

from bgi.memory.imagefile import load
from gallery.catalogue import C_NAMES, NAMES
from tools import a_to_z, pictures, sheet

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
PAGES = pictures.pages()
TEXTS = [page.read_text("utf-8") for page in sorted(DOCS.glob("*.md")) if page != a_to_z.FILE]
BLOCKS = [block for page in PAGES for block in pictures.blocks(page)]

DESCRIBED = a_to_z.described()
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
    colors = load(file).rgba[..., :3]
    return colors.shape, colors.tobytes()


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


@pytest.mark.parametrize("name", C_NAMES)
def test_the_picture_of_a_program_in_c_is_what_it_draws(tmp_path, name):
    assert_drawn(pictures.shoot_program(name, tmp_path), tmp_path)


def test_the_moving_picture_is_what_is_recorded(tmp_path):
    image = pytest.importorskip("PIL.Image", reason="needs Pillow")
    (name,) = pictures.record_demo(tmp_path)
    with image.open(tmp_path / name) as got, image.open(pictures.PICTURES / name) as expected:
        assert got.n_frames == expected.n_frames
        for number in range(got.n_frames):
            got.seek(number)
            expected.seek(number)
            assert got.info["duration"] == expected.info["duration"], number
            assert got.convert("RGB").tobytes() == expected.convert("RGB").tobytes(), number
    assert (pictures.PICTURES / name).stat().st_size < 500_000


def test_every_picture_has_its_code():
    drawn = [picture for _, picture in BLOCKS if picture] + [
        f"{name}.png" for name in NAMES + C_NAMES
    ]
    drawn.append(f"{pictures.MOVING}.gif")
    assert sorted(drawn) == sorted(file.name for file in pictures.PICTURES.iterdir())


def test_every_picture_of_a_page_belongs_to_code():
    for page in PAGES:
        shown = re.findall(r"!\[[^]]*\]\((?:\.\./)?pictures/(.*?)\)", page.read_text("utf-8"))
        assert shown == [picture for _, picture in pictures.blocks(page) if picture], page.name


@pytest.mark.parametrize("name", DESCRIBED)
def test_every_call_stands_in_the_table_of_one_page(name):
    rows = [row[0] for text in TEXTS for row in a_to_z.ROW.finditer(text) if row["name"] == name]
    assert rows == [str(DESCRIBED[name])], "run: python -m tools.a_to_z"


@pytest.mark.parametrize("name", SHOWN.split())
def test_every_call_that_can_be_seen_is_seen(name):
    assert any(picture and re.search(rf"\b{name}\(", code) for code, picture in BLOCKS)


@pytest.mark.parametrize("file", [ROOT / "README.md", *pictures.texts()], ids=str)
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
        for page in a_to_z.index():
            assert page.read_text("utf-8") == a_to_z.renewed(page), "run: python -m tools.a_to_z"
        assert page.read_text("utf-8").endswith(f"\n\n{a_to_z.BACK}\n")


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
        for name in a_to_z.names(prefix):
            assert {prefix + name, name} & listed, name


def test_the_sheet_of_all_calls_is_what_the_package_says():
    assert sheet.text() == sheet.FILE.read_text("utf-8"), "run: python -m tools.sheet"


class TestFrontDoor:
    README = (ROOT / "README.md").read_text("utf-8")

    @pytest.mark.parametrize("file", ["README.md", "ABOUT.md"])
    def test_its_programs_run(self, tmp_path, monkeypatch, file):
        monkeypatch.setenv("BGI_KEYS", pictures.KEYS)
        assert [*pictures.blocks(ROOT / file)]
        pictures.draw_page(ROOT / file, tmp_path)

    def test_ci_types_what_it_tells_a_newcomer_to_type(self):
        command = 'pip install -e ".[test]" && python -m pytest'
        assert command in self.README
        for file in (".ci/run", ".github/workflows/tests.yml"):
            lines = (ROOT / file).read_text("utf-8").splitlines()
            typed = [line.strip().removeprefix("- run: ") for line in lines]
            for part in command.split(" && "):
                assert part in typed

    def test_a_package_index_shows_nothing_that_lies_in_the_repository(self):
        """Its page has no folder to find pictures and other pages in."""
        project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
        shown = (ROOT / project["readme"]).read_text("utf-8")
        links = re.findall(r"\]\(([^)]+)|(?:src|href)=\"([^\"]+)", shown)
        assert all("://" in "".join(link) for link in links)


class TestContributing:
    TEXT = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    ANSWERS = re.findall(r"^\| .*\? \| (.*) \| `(.*)` \|$", TEXT, re.MULTILINE)

    def test_every_file_that_it_names_exists(self):
        named = re.findall(r"`([\w.-]+(?:/[\w.-]*)+)`", self.TEXT)
        assert len(named) > 40
        assert [name for name in named if not (ROOT / name).exists()] == []

    def test_its_picture_shows_every_folder(self):
        picture = self.TEXT.split("```")[1]
        for package in ("bgi", "surfaces"):
            inside = {file.parent.relative_to(ROOT) for file in (ROOT / package).glob("*/*.py")}
            shown = {Path(path) for path in re.findall(rf"{package}/[\w/]+(?=/[\s,])", picture)}
            assert shown == inside

    def test_there_is_a_command_for_each_habit(self):
        told = set(re.findall(r"`make (\w+)`", self.TEXT))
        targets = (ROOT / "Makefile").read_text("utf-8").partition(".PHONY: ")[2].partition("\n")[0]
        assert told == set(targets.split())

    @pytest.mark.parametrize(("files", "name"), ANSWERS, ids=[name for _, name in ANSWERS])
    def test_the_files_that_answer_a_question_do(self, files, name):
        texts = [(ROOT / file).read_text("utf-8") for file in re.findall("`(.*?)`", files)]
        assert any(name in text for text in texts)
