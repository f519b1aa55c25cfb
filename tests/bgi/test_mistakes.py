"""Beginners' mistakes: each is answered in words, where it is made."""

import copy
import json
import os
import pickle
import re
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

import bgi
from bgi import conio
from bgi.kernel.hints import for_argument
from tests.processes import PATIENCE

HOME = Path(__file__).resolve().parents[2]
PAGE = (HOME / "docs" / "mistakes.md").read_text("utf-8")
SHOWN = re.findall(r"```py\n(.*?)```\n\n```text\n(.*?)```", PAGE, re.DOTALL)


def run(folder: Path, name: str = "program.py", *options: str, **variables: str) -> str:
    """Run a program without a window; what it writes to its standard error."""
    done = subprocess.run(
        [sys.executable, *options, name],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(HOME), "BGI_MONITOR": "none"} | variables,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    return done.stderr


@pytest.mark.parametrize(("program", "words"), SHOWN, ids=[code for code, _ in SHOWN])
def test_the_page_shows_what_one_sees(tmp_path: Path, program: str, words: str) -> None:
    (tmp_path / "program.py").write_text(f"from bgi import *\n{program}")
    said = run(tmp_path, BGI_KEYS="q" if "!=" in program else "")
    for line in words.splitlines():
        assert line in said
    place = str(tmp_path / "program.py")  # where it went wrong; in one line it need not be told
    assert place in said or said.startswith("bgi: ")


def test_the_page_shows_them_all() -> None:
    assert len(SHOWN) == 9


# A size in place of a driver


def test_a_program_that_asks_for_the_result_goes_on() -> None:
    with pytest.warns(bgi.BGIWarning, match=r"^driver 640 does not exist; .*\(640, 480\)$"):
        bgi.initgraph(640, 480)
    assert bgi.graphresult() == bgi.grFileNotFound
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    assert bgi.graphresult() == bgi.grOk
    bgi.closegraph()
    with pytest.raises(bgi.BGIError, match=r"^BGI Error: .* \(use 'initgraph'\)$"):
        bgi.getmaxx()  # nothing of the driver any more


@pytest.mark.parametrize(
    ("gd", "gm", "words"),
    [
        (12, 0, "driver 12 does not exist"),
        (640, 0, "driver 640 does not exist"),
        (bgi.VGA, 3, "driver 9 (EGAVGA) has no mode 3, only 0 to 2"),
        (bgi.HERCMONO, 1, "driver 7 (HERC) has no mode 1, only 0 to 0"),
    ],
)
def test_a_driver_or_mode_that_does_not_exist(gd: int, gm: int, words: str) -> None:
    with pytest.warns(bgi.BGIWarning, match=f"^{re.escape(words)}$") as caught:
        bgi.initgraph(gd, gm)
    assert caught[0].filename == __file__


# A name in quotes


@pytest.mark.parametrize(
    ("value", "hint"),
    [
        ("red", "; did you mean RED, without quotes?"),
        ("light blue", "; did you mean LIGHTBLUE, without quotes?"),
        ("Light-Gray", "; did you mean LIGHTGRAY, without quotes?"),
        ("yelow", "; did you mean YELLOW, without quotes?"),
        ("SOLID_FILL", "; did you mean SOLID_FILL, without quotes?"),
        ("purple", "; a colour is a number, such as RED"),
        ("", "; a colour is a number, such as RED"),
        ((255, 0, 9), "; in a window of initwindow() a mixture is COLOR(255, 0, 9)"),
        ((255, 0), ""),
        (None, ""),
    ],
)
def test_hints_for_a_color(value: object, hint: str) -> None:
    assert for_argument("color", value) == hint
    bgi.initgraph()
    for setter in (bgi.setcolor, lambda color: bgi.circle(9, 9, 5, color)):
        if isinstance(value, tuple) and setter is not bgi.setcolor:
            continue  # an array of colours
        if value is not None:
            with pytest.raises(TypeError, match=f"^color must be a number.*{re.escape(hint)}$"):
                setter(value)


def test_there_is_no_hint_where_there_is_nothing_to_say() -> None:
    assert for_argument("x", "240") == for_argument("x", None) == for_argument("x", (1, 2, 3)) == ""


# A wrong number of arguments


@pytest.mark.parametrize(
    ("call", "note"),
    [
        ("circle((9, 9), 5)", "circle(x, y, radius, color=None): Draw a circle"),
        ("putpixel((3, 4), RED)", "putpixel(x, y, color): Set a pixel to a colour; a point is"),
        ("bar(0, 0, 9)", "bar(left, top, right, bottom, fill=None): Fill a box"),
        ("getmaxx(1)", "getmaxx(): Return the largest x"),
        ("line(0, 0, 9, 9, colour=RED)", "line(x1, y1, x2, y2, color=None): Draw a line"),
    ],
)
@pytest.mark.parametrize("options", [[], ["-m", "bgi"]])
def test_a_call_is_shown_as_it_should_be(
    tmp_path: Path, call: str, note: str, options: list[str]
) -> None:
    (tmp_path / "program.py").write_text(f"from bgi import *\ninitgraph()\n{call}\n")
    assert f"\n{note}" in run(tmp_path, "program.py", *options)


def test_errors_of_other_functions_are_left_alone(tmp_path: Path) -> None:
    program = "from bgi import *\ninitgraph()\ndef line(a, b): pass\nline(1)\n"
    (tmp_path / "program.py").write_text(program)
    assert run(tmp_path).endswith("missing 1 required positional argument: 'b'\n")


# A key compared with a text


@pytest.fixture
def q(monkeypatch: pytest.MonkeyPatch) -> int:
    """What getch() returns for the key q."""
    monkeypatch.setenv("BGI_KEYS", "q")
    bgi.initgraph()
    return bgi.getch()


def test_a_key_is_a_number_in_every_way(q: int) -> None:
    assert isinstance(q, int)
    assert q == 113 == q
    assert (q != 113) is False
    assert q == 113.0 == np.int64(q)
    assert 100 < q < 120
    assert q in (1, 113) and q in {113} and {113: "yes"}[q] == "yes"
    assert hash(q) == hash(113)
    assert (repr(q), str(q), f"{q:04d}", f"{q}", f"{q:x}") == (
        "113",
        "113",
        "0113",
        "113",
        "71",
    )
    assert json.dumps([q]) == "[113]"
    assert chr(q) == "q" and bytes([q]) == b"q" and [*range(200)][q] == 113
    assert type(q + 0) is type(q & 255) is int
    assert np.array([q]).dtype == np.array([113]).dtype
    assert pickle.loads(pickle.dumps(q)) == copy.deepcopy(q) == 113
    assert conio.ungetch(q) == 113
    bgi.putpixel(q, q, bgi.RED)
    assert bgi.getpixel(113, 113) == bgi.RED
    match q:
        case 113:
            pass
        case _:
            pytest.fail("113 is not 113")


@pytest.mark.parametrize(
    "compare",
    [
        lambda key: key == "q",
        lambda key: "q" == key,  # noqa: SIM300
        lambda key: (key != "q") is False,
        lambda key: key in ("q",),
        lambda key: key in ["a", "q"][1:],
    ],
)
def test_a_text_is_never_equal_and_one_is_told(q: int, compare: object) -> None:
    words = r"^getch\(\) returns a number; compare with ord\('q'\)$"
    with pytest.warns(bgi.BGIWarning, match=words) as caught:
        assert compare(q) is False
    assert caught[0].filename == __file__


def test_a_longer_text(q: int) -> None:
    with pytest.warns(bgi.BGIWarning, match=r"compare with the number of one, such as ord\('q'\)"):
        assert q != "quit"


def test_one_is_told_once_for_each_line(q: int) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("default")
        for _ in range(3):
            assert q != "q"
    assert len(caught) == 1


# Files that hide the package


@pytest.mark.parametrize("name", ["bgi.py", "program.py"])
def test_a_program_called_bgi(tmp_path: Path, name: str) -> None:
    for file in ("bgi.py", "program.py"):
        (tmp_path / file).write_text("from surfaces import surface\nfrom bgi import *\n")
    line = (
        f"ImportError: {tmp_path / 'bgi.py'} hides the package bgi: give that file another name\n"
    )
    assert run(tmp_path, name).endswith(line)


@pytest.mark.parametrize("options", [[], ["-m", "bgi"]])
def test_a_program_called_surfaces(tmp_path: Path, options: list[str]) -> None:
    (tmp_path / "surfaces.py").write_text("")
    program = "from bgi import *\ninitgraph()\nfrom surfaces import surface\n"
    (tmp_path / "program.py").write_text(program)
    said = run(tmp_path, "program.py", *options)
    note = f"{tmp_path / 'surfaces.py'} hides the package surfaces: give that file another name\n"
    assert said.endswith(note)


def test_a_program_called_bgi_that_another_folder_runs(tmp_path: Path) -> None:
    folder = tmp_path / "sub"
    folder.mkdir()
    (folder / "bgi.py").write_text("from bgi import *\ninitgraph()\nputpixel(1, 2, RED)\n")
    assert run(tmp_path, str(Path("sub", "bgi.py")), "-m", "bgi") == ""
