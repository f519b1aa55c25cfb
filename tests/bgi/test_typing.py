"""What mypy and help() tell whoever calls the functions."""

import inspect
from pathlib import Path

import pytest

import bgi
from bgi import conio, dos, mouse
from tests.judgement import misjudged

CALLS = Path(__file__).with_name("calls_to_check.py")
MODULES = bgi, conio, dos, mouse
FUNCTIONS = {
    f"{module.__name__}.{name}": function
    for module in MODULES
    for name, function in vars(module).items()
    if inspect.isfunction(function) and not name.startswith("_")
}


def test_mypy_refuses_wrong_calls_and_no_others():
    assert not misjudged(CALLS)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_signature_in_help_is_made_of_names(name):
    text = str(inspect.signature(FUNCTIONS[name]))
    assert "numpy" not in text and "typing" not in text


def test_help_of_line():
    text = str(inspect.signature(bgi.line)).replace("'", "")
    assert text == (
        "(x1: Numbers, y1: Numbers, x2: Numbers, y2: Numbers, color: Numbers | None = None) -> None"
    )
