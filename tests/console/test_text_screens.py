"""The original's text screens, cell for cell: what conio.h and printf wrote there."""

import json

import pytest

from bgi import conio, current
from tests.cases import ORIGINAL
from tests.console.calls import call

CASES = {case["name"]: case for case in json.loads((ORIGINAL / "text.json").read_text("utf-8"))}


def play(case):
    """Make a case's calls in its text mode; returns what the calls answered."""
    conio.textmode(case["textmode"])
    answers = {}
    for number, (name, *arguments) in enumerate(case["calls"]):
        answers[str(number)] = call(name, *arguments)
    return answers


@pytest.fixture(autouse=True)
def _scrolling(monkeypatch):
    monkeypatch.setattr(conio, "_wscroll", 1)


@pytest.mark.parametrize("name", CASES)
def test_the_same_cells_and_answers(name):
    case = CASES[name]
    answers = play(case)
    cells = current.console().cells.array
    rows = [bytes(row & 0xFF).replace(b"\0", b" ").decode("cp437") for row in to_bytes(cells)]
    assert rows == case["chars"]
    assert [(row >> 8).astype("u1").tobytes().hex() for row in cells] == case["attributes"]
    assert {number: answers[number] for number in case["results"]} == case["results"]


def to_bytes(cells):
    """The characters of each row of cells."""
    return (cells & 0xFF).astype("u1")
