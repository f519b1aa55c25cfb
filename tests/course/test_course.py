"""The course: each lesson has all its parts, its program draws its picture, its solutions hold."""

import os
import re
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import pytest

from tests.pictures import assert_same, read_indices
from tools import pictures

PAGES = sorted((pictures.DOCS / "course").glob("[0-9][0-9]-*.md"))
INDEX = (pictures.DOCS / "course" / "README.md").read_text("utf-8")
TEACHERS = (pictures.DOCS / "course" / "teachers.md").read_text("utf-8")
CHECKED = re.compile(r"\w+: right(, all \d+ cases)?")
"""What bgi.lab says of a solution."""


@pytest.fixture(params=pictures.LESSONS, ids=lambda program: program.stem)
def program(request: pytest.FixtureRequest) -> Path:
    """The program of each lesson."""
    file: Path = request.param
    return file


@pytest.fixture(params=PAGES, ids=lambda page: page.stem)
def page(request: pytest.FixtureRequest) -> Path:
    """The page of each lesson."""
    file: Path = request.param
    return file


def title(page: Path) -> str:
    """The heading of a page."""
    return page.read_text("utf-8").partition("\n")[0].removeprefix("# ")


def names(files: list[Path]) -> list[str]:
    """What the lessons of some files are called: 01_screen."""
    return [file.stem.replace("-", "_") for file in files]


def test_a_lesson_has_a_page_a_program_a_picture_and_solutions():
    programs = names(pictures.LESSONS)
    assert names(PAGES) == programs
    assert names(sorted((pictures.COURSE / "solutions").glob("*.py"))) == programs
    assert names(sorted(pictures.LESSONS_PICTURES.iterdir())) == programs


class TestProgram:
    def test_draws_its_picture_and_says_nothing(self, program: Path, tmp_path: Path):
        assert pictures.shoot_lesson(program, tmp_path) == "", "run: python -m tools.pictures"
        drawn = read_indices(tmp_path / f"{program.stem}.png")
        expected = read_indices(pictures.LESSONS_PICTURES / f"{program.stem}.png")
        assert_same(drawn, expected, program.stem)

    def test_says_its_number_its_command_and_its_page(self, program: Path):
        text = program.read_text("utf-8")
        assert text.startswith(f'"""Lesson {int(program.stem[:2])}: ')
        assert f"\n    python demos/course/{program.name}\n" in text
        assert f"docs/course/{program.stem.replace('_', '-')}.md" in text


class TestSolutions:
    def test_run(self, program: Path, tmp_path: Path):
        own = {name: value for name, value in os.environ.items() if not name.startswith("BGI_")}
        plan = {"BGI_MONITOR": "none", "BGI_KEYS": "x x x", "PYTHONPATH": str(pictures.ROOT)}
        command = [sys.executable, str(pictures.COURSE / "solutions" / program.name)]
        ran = subprocess.run(command, cwd=tmp_path, env=own | plan, capture_output=True, text=True)
        assert (ran.returncode, ran.stderr) == (0, "")
        wrong = [line for line in ran.stdout.splitlines() if not CHECKED.fullmatch(line)]
        assert not wrong

    def test_solve_three_exercises(self, program: Path):
        text = (pictures.COURSE / "solutions" / program.name).read_text("utf-8")
        assert re.findall(r'"""Exercise (\d): ', text) == ["1", "2", "3"]


class TestPage:
    def test_has_all_parts(self, page: Path):
        text = page.read_text("utf-8")
        number = int(page.stem[:2])
        assert text.startswith(f"# {number} · ")
        assert text.split("\n\n")[1].startswith("**The idea:** ")
        parts = re.findall(r"^## (.*)", text, re.MULTILINE)
        assert parts[-3:] == ["The program", "Exercises", "What it is good for"]
        assert f"](../../demos/course/{page.stem.replace('-', '_')}.py)" in text
        exercises = text.partition("## Exercises\n")[2].partition("\n## ")[0]
        assert re.findall(r"^(\d)\. \*.+?\*", exercises, re.MULTILINE) == ["1", "2", "3"]

    def test_its_code_knows_what_stands_above(self, page: Path):
        text = page.read_text("utf-8")
        assert pictures.ON_A_SCREEN in text and pictures.NAMES_STAY.search(text)

    def test_has_pictures_of_its_own(self, page: Path):
        drawn = [picture for _, picture in pictures.blocks(page) if picture]
        assert drawn and all(picture.startswith("course-") for picture in drawn)

    def test_leads_on_and_back(self, page: Path):
        following = dict(pairwise(PAGES)).get(page)
        onward = f"Next: [{title(following)}]({following.name}) · " if following else ""
        assert page.read_text("utf-8").endswith(f"\n\n{onward}[The course](README.md)\n")


class TestIndex:
    ROWS = re.findall(r"^\| (\d+) \| \[(.+)\]\((.+)\) \| (.+) \| (\d+) \|$", INDEX, re.MULTILINE)

    def test_lists_every_lesson_once(self):
        listed = [(f"{number} · {name}", file) for number, name, file, _, _ in self.ROWS]
        assert listed == [(title(page), page.name) for page in PAGES]

    def test_teachers_find_each_lesson(self):
        for number, name, _, _, minutes in self.ROWS:
            part = TEACHERS.partition(f"\n## {number} · {name}\n")[2].partition("\n## ")[0]
            assert part.startswith(f"\n{minutes} minutes.\n\n**Aims.** ")
            assert "\n**Usual misunderstandings.**\n\n* " in part
            assert re.search(rf"\n\*\*Solutions\.\*\* \[{int(number):02}_\w+\.py\]\(", part)
