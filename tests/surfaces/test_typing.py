"""What mypy and help() tell whoever calls the plotter."""

import inspect
from pathlib import Path

import pytest

import surfaces
from tests.judgement import misjudged

CALLS = Path(__file__).with_name("calls_to_check.py")
FUNCTIONS = [name for name in surfaces.__all__ if inspect.isroutine(getattr(surfaces, name))]


def test_mypy_refuses_wrong_calls_and_no_others() -> None:
    assert not misjudged(CALLS)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_signature_in_help_is_made_of_names(name: str) -> None:
    text = str(inspect.signature(getattr(surfaces, name)))
    assert "numpy" not in text and "typing" not in text
