"""What a teacher makes of the lessons: notebooks, and moving pictures for slides."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from bgi import current
from tests.pictures import read_indices
from tools import notebooks, pictures, slides

PAGE = pictures.DOCS / "course" / "05-filling.md"


def test_a_notebook_draws_the_pictures_of_its_page():
    codes = ["".join(cell["source"]) for cell in cells(PAGE, "code")]
    names: dict[str, Any] = {}
    exec(codes[0], names)
    for code, (_, picture) in zip(codes[1:], pictures.blocks(PAGE), strict=True):
        *_, last = code.splitlines()
        exec(code, names)
        assert eval(last, names) is current.screen
        if picture:
            expected = read_indices(pictures.PICTURES / picture)
            height, width = expected.shape
            assert np.array_equal(current.screen.page.array[:height, :width], expected)


def test_its_text_leads_to_nothing_that_is_not_there():
    text = "\n".join("".join(cell["source"]) for cell in cells(PAGE, "markdown"))
    assert "## Exercises" in text
    assert "](" not in text


def test_every_lesson_becomes_one(tmp_path: Path):
    notebooks.main(tmp_path)
    pages = sorted((pictures.DOCS / "course").glob("[0-9][0-9]-*.md"))
    written = sorted(tmp_path.glob("*.ipynb"))
    assert [file.stem for file in written] == [page.stem for page in pages]
    assert all(json.loads(file.read_text("utf-8"))["nbformat"] == 4 for file in written)
    assert (tmp_path / "squares.py").is_file()


def test_a_program_is_recorded_from_its_first_picture_to_its_last(tmp_path: Path):
    image = pytest.importorskip("PIL.Image", reason="needs Pillow")
    (program,) = [file for file in pictures.LESSONS if file.stem == "03_circles"]
    pressed = pictures.LESSON_KEYS[program.stem].split()
    with image.open(slides.record(program, tmp_path)) as moving:
        assert moving.n_frames == len(pressed)  # the last key ends it, after one for the beginning
        moving.seek(moving.n_frames - 1)
        last = np.asarray(moving.convert("RGB"))
    with image.open(pictures.LESSONS_PICTURES / f"{program.stem}.png") as shot:
        assert np.array_equal(np.asarray(shot.convert("RGB")), last)


def test_keys_are_pressed_slowly_and_held_as_long_as_they_are_held():
    assert slides.keys(Path("07_none.py")) == "Wait2s x"
    held = slides.keys(pictures.COURSE / "03_circles.py")
    assert held == "Wait700ms Up Wait700ms Up Wait700ms Space Wait2s Esc"


def cells(page: Path, kind: str) -> list[dict[str, Any]]:
    """The cells of one kind."""
    return [cell for cell in notebooks.notebook(page)["cells"] if cell["cell_type"] == kind]
