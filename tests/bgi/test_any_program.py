"""Programs that nobody would write: calls in any order, with any arguments, by a state machine.

A call that is refused leaves the picture and all that can be asked as they were; drawing stays
within the viewport while it clips.
"""

import inspect
from collections.abc import Callable

import numpy as np
from hypothesis import HealthCheck, note, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, rule

import bgi
from bgi import conio, current, dos, mouse
from bgi.kernel.state import KERNEL

# They wait, open, close, or meet files: other tests call them.
LEFT_OUT = {
    *("getch", "getche", "delay", "Sleep", "sleep", "bioskey", "strict", "swapbuffers"),
    *("initgraph", "initwindow", "setgraphmode", "restorecrtmode", "closegraph", "closewindow"),
    "textmode",
    *("readimagefile", "writeimagefile", "installuserfont", "installuserdriver"),
}
CALLS: list[Callable[..., object]] = [
    getattr(module, name)
    for module in (bgi, conio, dos, mouse)
    for name in module.__all__
    if inspect.isfunction(getattr(module, name)) and name not in LEFT_OUT
]
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
        np.broadcast_to(np.int64(5), 10**9),
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
    "flat": st.none(),
    "buffer": st.none(),
}


def state() -> tuple[object, ...]:
    """The pictures, and the answer of every call that asks for something."""
    screen = current.screen
    return (
        [page.array.tobytes() for page in screen.pages],
        screen.card.palette.tobytes(),
        *(bgi.getviewsettings(), bgi.getx(), bgi.gety(), bgi.getcolor(), bgi.getbkcolor()),
        *(bgi.getpalette(), bgi.getfillsettings(), bgi.getfillpattern(), bgi.getlinesettings()),
        *(bgi.gettextsettings(), bgi.textwidth("m"), bgi.textheight("m"), bgi.getarccoords()),
        *(bgi.getaspectratio(), bgi.getactivepage(), bgi.getvisualpage(), bgi.getgraphmode()),
        *(bgi.getcurrentwindow(), mouse.position(), mouse.buttons(), bgi.kbhit()),
        *(KERNEL.result._code, KERNEL.bufsize, KERNEL.seed, KERNEL.user_scale),
    )


class AnyProgram(RuleBasedStateMachine):
    """A screen, and one call after another."""

    @initialize(
        mode=st.sampled_from([(bgi.VGA, 0), (bgi.EGA, 0), (bgi.CGA, 0), (bgi.CGA, 4), None])
    )
    def begin(self, mode: tuple[int, int] | None) -> None:
        """Open a screen of one of the kinds that draw differently."""
        if mode is None:
            bgi.initwindow(120, 90)
        else:
            bgi.initgraph(*mode)

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
        except (bgi.BGIError, TypeError, ValueError) as error:
            assert str(error)
            assert state() == before
        if view.clip and call.__name__ in CLIPPED:
            inside = slice(view.top, view.bottom + 1), slice(view.left, view.right + 1)
            picture[inside] = screen.page.array[inside]
            assert (picture == screen.page.array).all()

    def teardown(self) -> None:
        """Leave nothing to the next program."""
        bgi.closegraph()
        KERNEL.reset()


TestAnyProgram = AnyProgram.TestCase
TestAnyProgram.settings = settings(
    deadline=None,
    max_examples=40,
    stateful_step_count=25,
    suppress_health_check=list(HealthCheck),
)
