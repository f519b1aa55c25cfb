"""Every argument of every call, given what does not belong there.

It is either taken for what it plainly means, or refused by its name before anything is done.
"""

import inspect
import re
import sys
from collections.abc import Callable
from datetime import date
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bgi
from bgi import dos
from bgi.errors import brief
from bgi.kernel.state import KERNEL
from tests.program import CALLS, state

pytestmark = pytest.mark.filterwarnings("ignore::bgi.BGIWarning")

BILLION = 10**9
HUGE = 10**5000  # of more digits than Python writes
ENDLESS: list[Any] = []
ENDLESS.append(ENDLESS)
DEEP: list[Any] = []
for _ in range(3000):
    DEEP = [DEEP]

NO_NUMBER = [
    *("7", "red", "", "x" * 10**6, b"7", bytearray(b"7"), None, {}, {1}, object(), len, int, ...),
    *(float("nan"), float("-inf"), np.float16("inf"), 1j, Decimal("nan"), date(2020, 1, 2)),
    *(Path("7"), iter([1]), np.str_("7"), np.complex128(7), np.datetime64("2020"), ENDLESS, DEEP),
    *(np.timedelta64(7, "s"), np.array("7"), np.array(np.nan), np.array("2020", "datetime64[Y]")),
    *(np.zeros((), [("a", "i4")]), np.ma.masked, bgi.Image(np.ones((9, 9), "u1"))),
]
NO_ARRAY = [
    *(["7"], [None], [float("nan")], [[1], [2, 3]], np.array([1, np.inf]), np.array([1j, 2])),
    *(
        np.array(["2020-01-02"], "datetime64[D]"),
        np.array([7], "timedelta64[s]"),
        np.zeros(2, "V4"),
    ),
    *(np.array([object()]), np.array([np.datetime64("2020")], object), np.array(["7"])),
    *(np.zeros(2, [("a", "i4"), ("b", "f8")]), np.ma.array([1, 2], mask=[0, 1]), range(BILLION)),
    *(np.broadcast_to(np.int16(5), BILLION), np.broadcast_to(True, (10**5, 10**4))),
]
ARRAYS = [[1, 2], (7,), range(3), np.zeros((2, 3)), np.zeros(0), np.ones(2, bool)]
"""Which some calls take."""

NO_TEXT = [*(value for value in NO_NUMBER if not isinstance(value, str)), 7, True, *ARRAYS]
NO_BYTES = [
    *("7", None, 7, {}, object(), ENDLESS, np.array("2020", "datetime64[Y]"), np.zeros(9)),
    *(np.array([object()] * 9), np.array(["2020-01-02"], "datetime64[D]"), np.zeros((9, 9), "u1")),
    *(np.broadcast_to(np.int16(5), BILLION), np.zeros(9, [("a", "i4")]), np.uint8(7)),
]
# Windows has names that are half a character.
NO_NAME = [
    "",
    "a\0b",
    b"a\0b",
    *["\ud800"] * (sys.platform != "win32"),
    *(value for value in NO_TEXT if type(value) is not bytes),
]
NO_NAME = [value for value in NO_NAME if not isinstance(value, Path)]

OTHERS: dict[str, list[Any]] = {
    "text": [value for value in NO_TEXT if type(value) is not bytes],
    "title": NO_TEXT,
    "name": NO_TEXT,
    "key": [*NO_TEXT, "", "nothing", "x" * 10**6],
    "path": [
        value for value in NO_TEXT if not isinstance(value, (Path, bytes)) and value is not None
    ],
    "filename": NO_NAME,
    "driver": [value for value in NO_TEXT if type(value) is not bytes],
    "font": [value for value in NO_TEXT if not isinstance(value, (bytes, bytearray))],
    "image": NO_BYTES,
    "buffer": [bytes(9), bytearray(3), *(value for value in NO_BYTES if value is not None)],
    "block": NO_BYTES,
    "source": NO_BYTES,
    "masks": ["12345678", 7, None, {}, [1] * 31, range(BILLION), ["a"] * 32, [None] * 32],
    **dict.fromkeys(("inregs", "segregs", "preg"), NO_TEXT),
    "outregs": [value for value in NO_TEXT if value is not None],
    "pattern": ["12345678", 7, None, {}, [1] * 7, range(BILLION), ["a"] * 8, [None] * 8],
    "palette": ["123", 7, None, {}, range(BILLION), ["a"], [None], [float("nan")]],
    "points": ["1 2", 7, None, {}, [1, 2, 3], [(1, 2), (3,)], ENDLESS, DEEP, *NO_ARRAY],
    "flat": ["1 2", 7, {}, ENDLESS],
    "follow": [*NO_TEXT, "", "nothing", "x" * 10**6],
    "handler": [7, "f", {}, np.zeros(2)],
    "detect": [7, "f", {}, np.zeros(2)],
}
"""What is wrong for arguments that are no numbers, by their names."""

UNTRIED = {"format", "args", "prompt", "s", "c", "datep", "timep"}
"""Texts of conio.h, which have tests of their own; and what setdate() and settime() never take."""

FITTING = {
    "format": "%d",
    "prompt": "?",
    "s": "12",
    "c": 65,
    "source": bytes(8),
    "intno": 0x33,
    "masks": range(32),
    "points": [(1, 2), (30, 4), (5, 6)],
    "text": "ab",
    "pattern": b"12345678",
    "palette": [1, 2, 3],
    "image": bgi.Image(np.ones((3, 3), "u1")),
    "kind": bgi.WM_MOUSEMOVE,
    "name": "MINE",
    "filename": "picture.png",
    "driver": "EGAVGA_driver",
    "block": bytearray(3),
    "key": "a",
    **dict.fromkeys(["handler", "flat", "buffer", "detect"]),
}
MADE = {"inregs": dos.REGS, "outregs": dos.REGS, "segregs": dos.SREGS, "preg": dos.REGPACK}
FITTING_HERE: dict[str, dict[str, Any]] = {
    "setfillstyle": {"pattern": 1},
    "setlinestyle": {"pattern": 5},
    "biostime": {"cmd": 0},
    "bioskey": {"cmd": 2},
    "getmoderange": {"driver": 9},
    "registerbgifont": {"font": "MINE"},
    "registerfarbgifont": {"font": "MINE"},
}
ARGUMENTS = [
    pytest.param(call, parameter, id=f"{call.__name__}-{parameter.name}")
    for call in CALLS
    for parameter in inspect.signature(call).parameters.values()
    if parameter.name not in UNTRIED
]
NUMBERS = [
    one
    for one in ARGUMENTS
    if one.values[1].annotation.startswith(("Number", "bool"))
    and one.values[1].name not in ("points", "flat")
]


def fitting(call: Callable[..., object], parameter: inspect.Parameter) -> dict[str, Any]:
    """Arguments that a call takes, where one of them is to be tried."""
    if parameter.name == "flat":
        return {"points": 1}
    fits = FITTING | FITTING_HERE.get(call.__name__, {})
    return {
        name: MADE[name]() if name in MADE else fits.get(name, 1)
        for name, one in inspect.signature(call).parameters.items()
        if one.default is one.empty and one.kind is not one.VAR_POSITIONAL
    }


def wrong(call: Callable[..., object], parameter: inspect.Parameter) -> list[Any]:
    """What a call must refuse in this place."""
    annotation = parameter.annotation
    if not annotation.startswith(("Number", "bool")) or parameter.name in ("points", "flat"):
        return OTHERS[parameter.name]
    left_out = parameter.default is None
    values = [value for value in NO_NUMBER if value is not None or not left_out]
    if annotation.startswith("Numbers"):  # memory of numbers is a sequence of them
        return [*NO_ARRAY, *(value for value in values if type(value) is not bytearray)]
    return [*NO_ARRAY, *ARRAYS, *values]


def left() -> object:
    """What a call has left; it may have led to a text mode."""
    try:
        return state()
    except bgi.BGIError as error:
        return str(error)


@pytest.fixture
def begin(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Callable[[], None]:
    """Begin anew, in a small window and an empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("BGI_KEYS", "a Enter")

    def anew() -> None:
        bgi.closegraph()
        KERNEL.reset()
        bgi.initwindow(24, 16)

    anew()
    bgi.writeimagefile("picture.png")
    return anew


@pytest.mark.parametrize(("call", "parameter"), ARGUMENTS)
def test_what_is_wrong_is_refused_by_name(
    call: Callable[..., object], parameter: inspect.Parameter, begin: Callable[[], None]
) -> None:
    before = state()
    fits = fitting(call, parameter)
    for value in wrong(call, parameter):
        with pytest.raises((TypeError, ValueError)) as caught:
            call(**fits | {parameter.name: value})
            pytest.fail(f"{brief(value)} was taken")
        message = str(caught.value)
        assert re.search(rf"\b{parameter.name}\b", message), brief(value)
        assert len(message) < 250
        assert state() == before
    assert [*Path().iterdir()] == [Path("picture.png")]


@pytest.mark.parametrize(("call", "parameter"), NUMBERS)
def test_numbers_of_any_size(
    call: Callable[..., object], parameter: inspect.Parameter, begin: Callable[[], None]
) -> None:
    for value in (HUGE, -HUGE, np.array(HUGE, object), 1e300):
        begin()
        before = state()
        try:
            call(**fitting(call, parameter) | {parameter.name: value})
        except (TypeError, ValueError) as error:
            assert re.search(rf"\b{parameter.name}\b", str(error))
            assert len(str(error)) < 250
            assert state() == before


@pytest.mark.parametrize(("call", "parameter"), NUMBERS)
def test_what_means_a_number_is_taken_as_one(
    call: Callable[..., object], parameter: inspect.Parameter, begin: Callable[[], None]
) -> None:
    number = fitting(call, parameter).get(parameter.name, 1)
    same = [number, number + 0.75, np.int16(number), np.float32(number + 0.5)]
    same += [np.array(number), np.array(number + 0.5), *([True, np.True_] if number == 1 else [])]
    seen = []
    for value in same:
        begin()
        answer = call(**fitting(call, parameter) | {parameter.name: value})
        plain = isinstance(answer, (int, tuple, str, bytes))
        seen.append((answer if plain else type(answer), left()))
    assert [*map(seen[0].__eq__, seen)] == [True] * len(same)
