"""The four functions of the paper's figures, each with a domain and a shape that show it well."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np

from surfaces.shape.sampling import Function, Interval


@dataclass(frozen=True)
class Figure:
    """One figure: `surface(fig.f, fig.x, fig.y, fig.n, zfrac=fig.zfrac)` draws it."""

    name: str
    f: Function
    x: Interval
    y: Interval
    n: int
    """Cells in each direction that make a good mesh."""
    zfrac: float
    """Its height, as a part of the screen's."""


def waves(x: Any, y: Any) -> Any:
    """sin(x+y): ridges along one diagonal."""
    return np.sin(x + y)


def ripples(x: Any, y: Any) -> Any:
    """sin(x^2+y^2): rings that crowd toward the corners."""
    return np.sin(x * x + y * y)


def ridge(x: Any, y: Any) -> Any:
    """sin(x+y)/(x+y), which is 1 where x+y = 0: numpy's sinc(t) is sin(pi t)/(pi t)."""
    return np.sinc((x + y) / pi)


def egg_crate(x: Any, y: Any, a: float = 2, b: float = 2) -> Any:
    """sin((x-y)/a) cos((x+y)/b); for a = b = 2 the same as (sin x - sin y)/2."""
    return np.sin((x - y) / a) * np.cos((x + y) / b)


FIGURES = (
    Figure("sin(x+y)", waves, (-pi, pi), (-pi, pi), 40, 0.30),
    # The corners reach x^2+y^2 = 12.5; fewer cells make the outer rings jagged.
    Figure("sin(x^2+y^2)", ripples, (-2.5, 2.5), (-2.5, 2.5), 60, 0.25),
    # Any higher, and the ridge hides all that is behind it.
    Figure("sin(x+y)/(x+y)", ridge, (-10, 10), (-10, 10), 50, 0.22),
    Figure("sin((x-y)/2)cos((x+y)/2)", egg_crate, (-2 * pi, 2 * pi), (-2 * pi, 2 * pi), 40, 0.28),
)
