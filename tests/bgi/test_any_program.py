"""Programs that nobody would write: calls in any order, with any arguments, by a state machine.

A call that is refused leaves the picture and all that can be asked as they were; drawing stays
within the viewport while it clips. Calls that wait are answered by a script of keys, in time that
is counted; pictures are written to a folder of the program's own, and read from there.
"""

import inspect
import os
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, note, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, rule

import bgi
from bgi import current
from bgi.graphics import Graphics
from bgi.graphics.slow import Slow
from bgi.graphics.strict import Strict
from bgi.kernel.state import KERNEL
from tests.program import CALLS, state

pytestmark = pytest.mark.filterwarnings("ignore::bgi.BGIWarning")

FILES = ["a.png", "b.bmp", "c.jpg", "d.gif", "e", "f.xyz", "none/g.png", "", "h\0.png"]
KEYS = "1 2 Enter Left q Wait2s F1 a Backspace Enter Esc Wait1s 7 Enter " * 3

CLIPPED = {
    *("putpixel", "line", "lineto", "linerel", "rectangle", "drawpoly", "circle", "arc", "ellipse"),
    *("fillellipse", "pieslice", "sector", "bar", "bar3d", "fillpoly", "floodfill", "outtext"),
    *("outtextxy", "clearviewport"),
}

near = st.integers(-3, 20)
ints = st.one_of(
    near, near, st.integers(-90, 250), st.sampled_from([2**31, -(2**63), 10**40, -(10**5000)])
)
numbers = st.one_of(ints, ints, ints, ints.map(lambda n: float(n % 10**9)), st.booleans())
arrays = st.one_of(
    st.lists(ints, max_size=4),
    st.just(np.arange(6).reshape(2, 3)),
    st.just(np.array([1, 2.5, 9], np.float16)),
)
points = st.one_of(
    st.lists(st.tuples(ints, ints), max_size=6),
    st.lists(st.lists(st.tuples(near, near), min_size=3, max_size=3), max_size=3),
)
wrong = st.sampled_from(
    [
        *(None, "7", b"7", float("nan"), 1j, object(), {}, [[1], [2, 3]], (), range(10**9)),
        *(np.float16("inf"), np.array([1, np.nan]), np.zeros((1,) * 32), np.array(["a"])),
        np.broadcast_to(np.int8(5), 10**9),
    ]
)
fitting = {
    "points": points,
    "text": st.one_of(st.text(max_size=9), st.binary(max_size=9)),
    "pattern": st.one_of(numbers, st.binary(min_size=8, max_size=8)),
    "palette": st.lists(ints, max_size=20),
    "image": st.one_of(st.binary(max_size=60), st.just(bgi.Image(np.ones((9, 9), "u1")))),
    "kind": st.just(bgi.WM_MOUSEMOVE),
    "handler": st.none(),
    "filename": st.sampled_from(FILES),
    "format": st.sampled_from(["%d", "%s%f", "%d%*c%[a-z]", "12", "%q"]),
    "prompt": st.text(max_size=9),
    "name": st.sampled_from(["SVGA256", "MINE", "TRIP"]),
    "detect": st.sampled_from([None, lambda: 2, lambda: -1, lambda: None]),
    "gd": st.sampled_from([bgi.DETECT, bgi.CGA, bgi.EGA, bgi.VGA, 16, 99]),
    "gm": st.integers(-1, 3),
    "path": st.sampled_from(["", None, Path()]),
    **{side: st.integers(-1, 120) for side in ("width", "height")},
    "title": st.text(max_size=9),
    "step": st.just(False),
    "pixels_a_second": st.sampled_from([0, 10**9]),
    "flat": st.none(),
    "buffer": st.none(),
}


class AnyProgram(RuleBasedStateMachine):
    """A screen, and one call after another."""

    @initialize(
        mode=st.sampled_from([(bgi.VGA, 0), (bgi.EGA, 0), (bgi.CGA, 0), (bgi.CGA, 4), None])
    )
    def begin(self, mode: tuple[int, int] | None) -> None:
        """Open a screen of one of the kinds that draw differently."""
        self.before, self.folder = Path.cwd(), tempfile.TemporaryDirectory()
        os.chdir(self.folder.name)
        os.environ["BGI_KEYS"] = KEYS
        if mode is None:
            bgi.initwindow(120, 90)
        else:
            bgi.initgraph(*mode)
        bgi.writeimagefile("a.png", 0, 0, 9, 9)

    @rule(left=near, top=near, width=st.integers(1, 60), height=st.integers(1, 60))
    def look_through(self, left: int, top: int, width: int, height: int) -> None:
        """Set a viewport that most of the numbers meet."""
        bgi.setviewport(max(left, 0), max(top, 0), left + width + 3, top + height + 3, 1)

    @rule(call=st.sampled_from(CALLS), data=st.data(), fits=st.integers(0, 3))
    def any_call(self, call: Callable[..., object], data: st.DataObject, fits: int) -> None:
        """Make a call, three times of four with arguments that might fit."""
        given = [
            data.draw(
                st.one_of(fitting.get(parameter.name, st.one_of(numbers, numbers, arrays)))
                if fits
                else st.one_of(numbers, points, wrong)
            )
            for parameter in inspect.signature(call).parameters.values()
            if parameter.default is parameter.empty or not fits
        ]
        note(f"{call.__name__}")
        view, screen = bgi.getviewsettings(), current.screen
        before, picture = state(), screen.page.array.copy()
        try:
            call(*given)
        except bgi.BGIError as error:  # graphresult() may say more than before
            assert str(error)
            assert state()[:-1] == before[:-1]
        except (OSError, TypeError, ValueError) as error:
            assert str(error)
            assert state() == before
        if not isinstance(current.screen, (Graphics, Slow, Strict)):  # it went, or to a text mode
            bgi.initgraph(bgi.VGA, bgi.VGALO)
        elif view.clip and call.__name__ in CLIPPED:
            inside = slice(view.top, view.bottom + 1), slice(view.left, view.right + 1)
            picture[inside] = screen.page.array[inside]
            assert (picture == screen.page.array).all()

    def teardown(self) -> None:
        """Leave nothing to the next program."""
        bgi.closegraph()
        KERNEL.reset()
        del os.environ["BGI_KEYS"]
        os.chdir(self.before)
        self.folder.cleanup()


TestAnyProgram = AnyProgram.TestCase
TestAnyProgram.settings = settings(
    deadline=None,
    max_examples=40,
    stateful_step_count=25,
    suppress_health_check=list(HealthCheck),
)
