"""Every call with arguments nobody should pass: an answer or a clear error, the picture safe."""

import inspect

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import bgi
from bgi import VGA, VGAHI
from bgi.graphics import Graphics
from bgi.kernel.modes import find

# Calls that may change pixels outside a clipping viewport, as in the original.
UNCLIPPED = {"cleardevice", "putimage", "readimagefile"}
NO_DRAWING = {"enter", "swapbuffers"}
NAMES = sorted(
    name
    for name in dir(Graphics)
    if not name.startswith("_")
    and callable(getattr(Graphics, name))
    and name not in NO_DRAWING | {"writeimagefile", "readimagefile", "setviewport"}
)

ints = st.one_of(
    st.integers(-3, 20),
    st.integers(-700, 700),
    st.sampled_from([6553, 20_000, 2**31, -(2**31), 2**63, -(10**40), 10**40]),
)
numbers = st.one_of(ints, ints, ints, ints.map(float), st.booleans())
wrong = st.sampled_from(
    [
        None,
        "7",
        b"7",
        float("nan"),
        float("-inf"),
        1j,
        object(),
        {},
        [],
        [[]],
        (),
        [1, 2, 3],
        np.array([]),
        np.array(5),
        np.float32(2.5),
        np.uint8(200),
        [[1, 2], [3, 4]],
        "é" * 50,
    ]
)
points = st.one_of(
    st.lists(st.tuples(ints, ints), max_size=6),
    st.lists(ints, max_size=7),
    st.just([(5, 5)] * 4),
    st.lists(st.lists(st.tuples(ints, ints), min_size=3, max_size=3), max_size=3),
)


def arguments(name):
    """Arguments for a call: mostly numbers, sometimes what does not belong there at all."""
    parameters = list(inspect.signature(getattr(Graphics, name)).parameters.values())[1:]
    given_always = [p for p in parameters if p.default is p.empty]
    kinds = {
        "points": points,
        "text": st.one_of(st.text(max_size=30), st.binary(max_size=9)),
        "pattern": st.one_of(st.binary(min_size=8, max_size=8), numbers),
        "palette": st.lists(ints, max_size=20),
        "image": st.one_of(st.binary(max_size=60), st.just(bgi.Image(np.ones((9, 9), "u1")))),
    }
    good = st.tuples(*[kinds.get(p.name, numbers) for p in given_always])
    bad = st.tuples(*[st.one_of(numbers, wrong, points) for _ in given_always])
    return st.one_of(good, good, bad)


@pytest.mark.parametrize("name", NAMES)
@settings(
    deadline=None, max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(data=st.data(), thick=st.booleans(), xor=st.booleans(), fill=st.integers(0, 11))
def test_any_arguments(name, data, thick, xor, fill):
    screen = Graphics(find(VGA, VGAHI))
    screen.page.flat[:] = 3
    screen.setviewport(100, 100, 299, 249, 1)
    screen.setlinestyle(0, 0, 3 if thick else 1)
    screen.setwritemode(xor)
    screen.setfillstyle(fill, 9)
    values = data.draw(arguments(name))
    try:
        getattr(screen, name)(*values)
    except (TypeError, ValueError) as error:
        assert str(error)
        assert (screen.pages[0].array == 3).all() or name in ("line", "circle", "arc")
    if name not in UNCLIPPED:
        screen.pages[0].array[100:250, 100:300] = 3
        assert (screen.pages[0].array == 3).all()
    screen.graphdefaults()
    screen.putpixel(1, 1, 5)
    assert screen.getpixel(1, 1) == 5
