"""The options that `surface`, `parametric` and `sheet` share are defined once, in `Look`."""

import inspect
from collections.abc import Callable
from dataclasses import fields
from typing import Any

import numpy as np
import pytest

import bgi
from surfaces import MODES, parametric, sheet, surface
from surfaces.look import Look
from surfaces.visible import painter

LOOK = [field.name for field in fields(Look)]
OF_HEIGHTS = {"z", "contours", "floor"}
"""Options that only a height field has."""


def options(function: Callable[..., Any]) -> dict[str, inspect.Parameter]:
    """The options that are given by name only."""
    parameters = inspect.signature(function).parameters
    return {name: p for name, p in parameters.items() if p.kind is p.KEYWORD_ONLY}


@pytest.mark.parametrize("function", [surface, parametric, sheet])
def test_all_have_the_options_of_a_look_in_its_order(function: Callable[..., Any]) -> None:
    shared = [name for name in options(function) if name not in OF_HEIGHTS | {"color"}]
    assert shared == LOOK


def test_height_fields_have_only_these_more() -> None:
    assert set(options(surface)) - set(options(parametric)) == OF_HEIGHTS


@pytest.mark.parametrize("name", LOOK)
def test_defaults_differ_only_where_a_body_wants_another(name: str) -> None:
    defaults = options(surface)[name].default, options(parametric)[name].default
    different = {"zfrac": (0.3, None), "under": ("dusk", None)}
    assert defaults == different.get(name, (defaults[0], defaults[0]))


@pytest.mark.parametrize("function", [surface, parametric, sheet])
def test_every_option_is_documented(function: Callable[..., Any]) -> None:
    text = inspect.getdoc(function) or ""
    described = [
        line.split(":")[0].strip()
        for line in text.split("Args:")[1].split("Returns:")[0].splitlines()
        if line.startswith("    ") and not line.startswith("     ")
    ]
    assert described == list(inspect.signature(function).parameters)


@pytest.mark.parametrize("function", [surface, parametric, sheet])
def test_every_option_arrives_under_its_own_name(
    function: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    given: dict[str, Any] = {name: object() for name in LOOK}

    def remember(**arrived: Any) -> None:
        assert arrived == given
        raise InterruptedError

    monkeypatch.setattr(f"{function.__module__}.Look", remember)
    with pytest.raises(InterruptedError):
        function(None, (0, 1), (0, 1), **given)


def test_modes_of_sheets_are_modes_of_height_fields() -> None:
    assert set(MODES) - set(painter.MODES) == {"waterfall"}
    assert all(MODES[mode] is drawn for mode, drawn in painter.MODES.items())


@pytest.mark.parametrize(
    "axes, names",
    [
        (True, ("x", "y", "z")),
        (False, ()),
        (["time", "Hz", "dB"], ("time", "Hz", "dB")),
        ("xyz", ("x", "y", "z")),
    ],
)
def test_axes_are_three_names_or_none(axes: Any, names: tuple[str, ...]) -> None:
    given = {name: options(surface)[name].default for name in LOOK}
    assert Look(**given | {"axes": axes}).names == names


@pytest.mark.parametrize("wrong", [{"every": 0}, {"axes": ("x", "y")}, {"axes": ""}])
def test_a_look_out_of_range_is_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=next(iter(wrong))):
        surface(np.eye(3), **wrong)


def test_nothing_is_drawn_behind_a_surface_that_cannot_be() -> None:
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    wrong: list[dict[str, Any]] = [
        {"color": "none"},
        {"ramp": "none"},
        {"transform": np.zeros((4, 4))},
    ]
    for one in wrong:
        with pytest.raises(ValueError):
            surface(np.eye(3), box=True, axes=True, title="nothing", **one)
    assert not np.any(bgi.getpixel(*np.meshgrid(np.arange(640), np.arange(480))))
    bgi.closegraph()
