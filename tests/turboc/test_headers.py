"""Every name of Turbo C++'s headers is there, or the reason why it cannot be is told."""

import re
from pathlib import Path

import pytest

from bgi.turboc.checker.headers import Headers
from bgi.turboc.faults import CErrors
from bgi.turboc.running import Runnable
from bgi.turboc.runtime import library
from bgi.turboc.runtime.headertexts import REFUSED
from bgi.turboc.runtime.session import Session

TABLE = Path(__file__).with_name("header_names.txt").read_text().splitlines()
NAMES = sorted({name for line in TABLE if line.startswith(" ") for name in line.split()})
HEADERS = Headers(library.FUNCTIONS, library.CONSTANTS, library.TYPES, REFUSED)
WRITTEN = set(re.findall(r"\b(\w+)(?=\(| {)|#define (\w+)", " ".join(library.HEADERS.values())))
DEFINED = {name for pair in WRITTEN for name in pair}


def is_there(name):
    known = name in DEFINED or name in library.MACROS
    return known or HEADERS.type(name) is not None or HEADERS.symbol(name) is not None


def test_every_name_of_the_headers_is_there_or_refused():
    assert [name for name in NAMES if not is_there(name) and name not in REFUSED] == []


def test_nothing_is_there_and_refused():
    assert [name for name in REFUSED if is_there(name)] == []


def test_every_declaration_has_its_function():
    assert set(library.FUNCTIONS) - set(library.names(Session(None, "A"))) == set()


def test_every_header_is_there():
    files = [line.strip() for line in TABLE if line.endswith(".h") and " " not in line.strip()]
    assert len(files) > 20
    assert [name for name in files if name not in library.HEADERS] == []


def errors(tmp_path, text):
    path = tmp_path / "T.C"
    path.write_text(text)
    with pytest.raises(CErrors) as found:
        Runnable(str(path), {})
    return [error.message for error in found.value.errors]


@pytest.mark.parametrize("name", sorted(REFUSED))
def test_a_name_that_cannot_be_is_told_with_its_reason(name, tmp_path):
    (message,) = errors(tmp_path, f"void main() {{ {name}(1); }}")
    assert message == f"{name} {REFUSED[name]}"


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        *[("circel", "circle"), ("initgraf", "initgraph"), ("outtextyx", "outtextxy")],
        *[("prinft", "printf"), ("setfilstyle", "setfillstyle"), ("getmaxX", "getmaxx")],
        *[("strcopy", "strcpy"), ("cleardevise", "cleardevice"), ("fopenn", "fopen")],
    ],
)
def test_a_misspelt_name_is_guessed(wrong, right, tmp_path):
    (message,) = errors(tmp_path, f"void main() {{ {wrong}(1); }}")
    assert message == f"there is no {wrong}: did you mean {right}?"


@pytest.mark.parametrize("name", sorted(library.TYPES))
def test_every_method_of_a_class_is_there(name):
    names = library.names(Session(None, "A"))
    classes = {"istream": names["cin"], "ostream": names["cout"], "ios": names["cout"]}
    made = classes.get(name) or names.get(f"struct_{name}") or names["struct_fstream"]
    found = HEADERS.type(name)
    methods = [one.python for same in found.methods.values() for one in same]
    assert [method for method in methods if not hasattr(made, method)] == []
