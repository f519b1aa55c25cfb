"""Strict mode: whatever is refused or swallowed is an exception, and changes nothing."""

import contextlib
import pickle
from collections.abc import Callable, Iterator

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import bgi
from bgi import current
from bgi.graphics.strict import Strict

SQUARE = [(10, 10), (50, 10), (50, 50)]

# Calls that graphresult() would report, their codes, and what is said.
REPORTED: dict[str, tuple[int, str]] = {
    "setfillstyle(99, bgi.RED)": (-11, "setfillstyle(pattern=99, color=4): Graphics error (-11)"),
    "setlinestyle(0, 0, 5)": (-11, "setlinestyle(style=0, pattern=0, width=5): Graphics error"),
    "setlinestyle(7, 0, 1)": (-11, "setlinestyle(style=7, pattern=0, width=1): Graphics error"),
    "setfillpattern(bytes(8), 16)": (-11, "setfillpattern(pattern=b'"),
    "settextstyle(99, 0, 1)": (-14, "settextstyle(font=99, direction=0, charsize=1): Invalid font"),
    "settextjustify(5, 5)": (-11, "settextjustify(horiz=5, vert=5): Graphics error (-11)"),
    "setusercharsize(1, 0, 1, 1)": (-11, "setusercharsize(multx=1, divx=0, multy=1, divy=1): "),
    "setviewport(0, 0, 640, 9, 1)": (-11, "setviewport(left=0, top=0, right=640, bottom=9, clip=1"),
    "imagesize(0, 0, 639, 479)": (-11, "imagesize(left=0, top=0, right=639, bottom=479): Graphics"),
    "setgraphmode(7)": (-10, "setgraphmode(mode=7): Invalid graphics mode for selected driver"),
    "initgraph(640, 480)": (-3, "driver 640 does not exist; for a window of that size"),
    "registerbgidriver('NONE')": (-4, "registerbgidriver(driver='NONE'): Invalid device driver"),
    "registerbgifont(b'no font')": (-13, "registerbgifont(font=b'no font'): Invalid font file"),
}

# Calls that Borland's functions, and ours, take in silence; what is said behind "(-11): ".
SWALLOWED = {
    "setcolor(16)": "there is no color 16, only 0 to 15",
    "setcolor(-1)": "there is no color -1, only 0 to 15",
    "setbkcolor(16)": "there is no color 16, only 0 to 15",
    "setfillstyle(1, 16)": "there is no color 16, only 0 to 15",
    "putpixel(1, 1, 255)": "there is no color 255, only 0 to 15",
    "putpixel(range(30_000), 1, [3] * 29_999 + [77])": "there is no color 77, only 0 to 15",
    "line(0, 0, 9, 9, 99)": "there is no color 99, only 0 to 15",
    "circle(9, 9, [3, 4], [2, 20])": "there is no color 20, only 0 to 15",
    "bar(0, 0, 9, 9, fill=16)": "there is no fill 16, only 0 to 15",
    "fillpoly(SQUARE, fill=1, color=16)": "there is no color 16, only 0 to 15",
    "fillpoly(SQUARE, fill=17)": "there is no fill 17, only 0 to 15",
    "floodfill(99, 99, 31)": "there is no border 31, only 0 to 15",
    "floodfill(99, 99, 5)": "the area around 99, 99 reaches all sides of the viewport: "
    "no outline in color 5 is closed",
}


def call(text: str) -> object:
    return eval(f"bgi.{text}")


def state() -> bytes:
    """Everything that a call may change: pixels, palette, settings."""
    screen = current.loaded()
    assert screen is not None
    kept = [bytes(page.array.tobytes()) for page in screen.pages]
    kept.append(screen.card.palette.tobytes())
    own = {name: value for name, value in vars(screen).items() if name.startswith("_")}
    plain = {name: repr(value) for name, value in sorted(own.items())}
    return pickle.dumps((kept, repr(screen.settings), screen.mode, plain, bgi.getpalette()))


@pytest.fixture(autouse=True)
def screen() -> Iterator[None]:
    """A screen with something on it."""
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    bgi.setfillstyle(bgi.HATCH_FILL, bgi.GREEN)
    bgi.bar(200, 200, 300, 300)
    yield
    bgi.strict(False)


@pytest.mark.parametrize("text", REPORTED)
def test_what_graphresult_reports_is_raised(text: str) -> None:
    code, words = REPORTED[text]
    before = state()
    with bgi.strict(), pytest.raises(bgi.GraphicsError) as caught:
        call(text)
    assert words in str(caught.value)
    assert str(caught.value).startswith(text.partition("(")[0])
    assert caught.value.code == code == bgi.graphresult()
    assert state() == before


@pytest.mark.parametrize("text", SWALLOWED)
def test_what_is_swallowed_is_raised(text: str) -> None:
    before = state()
    with bgi.strict(), pytest.raises(bgi.GraphicsError) as caught:
        call(text)
    assert str(caught.value).endswith(f": Graphics error (-11): {SWALLOWED[text]}")
    assert caught.value.function == text.partition("(")[0]
    assert state() == before
    assert bgi.graphresult() == bgi.grError
    call(text)  # and without it, there is no word
    assert bgi.graphresult() == bgi.grOk


def test_the_exception_holds_what_was_given() -> None:
    with bgi.strict(), pytest.raises(bgi.GraphicsError) as caught:
        bgi.line(0, 1, 2, 3, 99)
    given = {"x1": 0, "y1": 1, "x2": 2, "y2": 3, "color": 99}
    assert caught.value.arguments == given
    assert isinstance(caught.value, bgi.BGIError)


def test_what_is_right_is_done() -> None:
    """Strict mode draws and answers as ever."""

    def program() -> bytes:
        bgi.initgraph(bgi.VGA, bgi.VGAHI)
        bgi.setcolor(bgi.YELLOW)
        bgi.setbkcolor(bgi.BLUE)
        bgi.setpalette(3, 63)  # a hardware colour, and no colour of the screen
        bgi.circle(100, 100, [10, 20, 30], [1, 2, 3])
        bgi.rectangle(300, 300, 400, 400)
        bgi.setfillstyle(bgi.SLASH_FILL, bgi.RED)
        bgi.floodfill([350, 350], [350, 360], bgi.YELLOW)
        bgi.fillpoly(SQUARE, fill=5)
        bgi.putpixel([1, 2], 3, 4)
        bgi.outtextxy(9, 9, "strict")
        bgi.settextstyle(bgi.TRIPLEX_FONT, bgi.HORIZ_DIR, 4)
        bgi.outtext("strict")
        assert bgi.getmaxx() == 639
        return state()

    relaxed = program()
    with bgi.strict():
        assert program() == relaxed


def test_each_mode_has_its_colors() -> None:
    bgi.strict()
    for driver, mode, last in [
        (bgi.CGA, bgi.CGAC0, 3),
        (bgi.CGA, bgi.CGAHI, 1),
        (bgi.IBM8514, bgi.IBM8514LO, 255),
    ]:
        bgi.initgraph(driver, mode)
        bgi.setcolor(last)
        bgi.setbkcolor(15)  # of all the sixteen
        with pytest.raises(bgi.GraphicsError, match=f"no color {last + 1}, only 0 to {last}$"):
            bgi.setcolor(last + 1)


def test_a_window_has_mixtures() -> None:
    bgi.strict()
    bgi.initwindow(64, 48)
    for color in (0, 15, bgi.COLOR(1, 2, 3), bgi.COLOR(255, 128, 0)):
        bgi.setcolor(color)
        assert bgi.getcolor() == color
    for color in (16, 0x804020, -1, 0x7FFFFFFF):
        with pytest.raises(bgi.GraphicsError, match=r"0 to 15 and COLOR\(red, green, blue\)$"):
            bgi.setcolor(color)


def test_a_flood_within_a_viewport() -> None:
    bgi.strict()
    bgi.setviewport(100, 100, 150, 150, 1)
    with pytest.raises(bgi.GraphicsError, match="around 10, 10 reaches all sides"):
        bgi.floodfill(10, 10, bgi.RED)
    assert bgi.graphresult() == bgi.grError
    bgi.line(0, 0, 0, 50, bgi.RED)  # a wall along one side is enough
    bgi.floodfill(10, 10, bgi.RED)
    assert bgi.graphresult() == bgi.grOk


def test_of_several_floods_all_are_made_or_none() -> None:
    bgi.setfillstyle(bgi.SOLID_FILL, bgi.WHITE)
    bgi.rectangle(10, 10, 20, 20, bgi.RED)
    before = bgi.getimage(0, 0, 639, 479)
    with bgi.strict(), pytest.raises(bgi.GraphicsError, match="around 30, 15 reaches all sides"):
        bgi.floodfill([15, 30], 15, bgi.RED)
    assert (bgi.getimage(0, 0, 639, 479).array == before.array).all()
    with bgi.strict():
        bgi.floodfill([15, 16], 15, bgi.RED)
    assert bgi.getpixel(15, 15) == bgi.WHITE


# On and off


def test_from_now_on_and_no_longer() -> None:
    assert not isinstance(current.screen, Strict)
    bgi.strict()
    with pytest.raises(bgi.GraphicsError):
        bgi.setcolor(16)
    bgi.closegraph()
    bgi.initgraph()
    bgi.setactivepage(1)
    with pytest.raises(bgi.GraphicsError):  # on every screen
        bgi.setcolor(16)
    bgi.strict(False)
    bgi.setcolor(16)
    assert not isinstance(current.screen, Strict)  # nothing of it is left


def test_blocks_within_blocks() -> None:
    def is_strict() -> bool:
        with contextlib.suppress(bgi.GraphicsError):
            bgi.setcolor(16)
            return False
        return True

    with bgi.strict():
        with bgi.strict(False):
            assert not is_strict()
        assert is_strict()
    assert not is_strict()
    with pytest.raises(ZeroDivisionError), bgi.strict():
        bgi.setcolor(1 // 0)
    assert not is_strict()


def test_before_a_screen_and_after_it() -> None:
    bgi.closegraph()
    with bgi.strict():
        with pytest.raises(bgi.BGIError, match="not initialized"):
            bgi.setcolor(16)
        bgi.initgraph(bgi.VGA, bgi.VGAHI)
        bgi.restorecrtmode()
        with pytest.raises(bgi.BGIError, match="Not in graphics mode"):
            bgi.setcolor(16)
        bgi.setgraphmode(bgi.VGAHI)
        with pytest.raises(bgi.GraphicsError):
            bgi.setcolor(16)
        bgi.initgraph(bgi.VGA, bgi.VGAMED)  # goes on in the same window
        assert bgi.getcurrentwindow() == 0


def test_screens_of_ones_own_are_strict_about_what_is_reported() -> None:
    with bgi.strict(), pytest.raises(bgi.GraphicsError, match=r"^setfillstyle\(pattern=99"):
        current.loaded().setfillstyle(99, 1)


def test_other_errors_are_as_ever() -> None:
    relaxed: list[str] = []
    for _ in range(2):
        for wrong in ("red", None, float("nan"), [1, 2]):
            with pytest.raises((TypeError, ValueError)) as caught:
                bgi.setcolor(wrong)
            relaxed.append(str(caught.value))
        bgi.strict()
    assert relaxed[:4] == relaxed[4:]


# Whatever the call

numbers = st.one_of(st.integers(-3, 20), st.integers(-700, 700))
CALLS: dict[str, int] = {
    "setcolor": 1,
    "setbkcolor": 1,
    "setfillstyle": 2,
    "setlinestyle": 3,
    "settextstyle": 3,
    "settextjustify": 2,
    "setusercharsize": 4,
    "setviewport": 5,
    "setpalette": 2,
    "setrgbpalette": 4,
    "setwritemode": 1,
    "putpixel": 3,
    "line": 5,
    "circle": 4,
    "bar": 5,
    "floodfill": 3,
    "setaspectratio": 2,
}


@settings(
    max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.sampled_from(sorted(CALLS)), st.lists(numbers, min_size=5, max_size=5))
def test_a_refused_call_changes_nothing_and_any_other_does_what_it_did(
    name: str, values: list[int]
) -> None:
    function: Callable[..., object] = getattr(bgi, name)
    arguments = values[: CALLS[name]]
    bgi.initgraph(bgi.VGA, bgi.VGALO)
    before = state()
    refused = False
    with bgi.strict():
        try:
            function(*arguments)
        except bgi.GraphicsError:
            refused = True
    code = bgi.graphresult()
    after = state()
    assert (code != bgi.grOk) == refused
    bgi.initgraph(bgi.VGA, bgi.VGALO)
    function(*arguments)
    if refused:
        assert after == before
        assert bgi.graphresult() in (code, bgi.grOk)  # swallowed, if not reported
    else:
        assert after == state()
        assert bgi.graphresult() == bgi.grOk
