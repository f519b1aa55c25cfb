"""Calls for mypy to judge (test_typing.py): an error in each line marked wrong, and no other."""

from datetime import date, datetime

import numpy as np

from surfaces import (
    Grid,
    Plot,
    Svg,
    data,
    orthographic,
    parametric,
    rotation,
    sample,
    sheet,
    surface,
)


def hill(x: float, y: float) -> float:
    return 1 / (1 + x * x + y * y)


def shapes() -> None:
    surface(hill, (-1, 1), (-1, 1))
    surface("sin(x*y)")
    surface([[1, 2], [3, 4]])
    surface(np.arange(9).reshape(3, 3), [1, 2, 4])
    surface([hill, "x*y", sample(hill, (0, 1), (0, 1))], x=(-1, 1), y=(-1, 1))
    surface(3)  # wrong
    surface(hill, 1, 2)  # wrong
    surface(hill, (-1, 1), (-1, 1), "40")  # wrong
    surface(hill, (-1, 1), (-1, 1), (40, 50))
    grid: Grid = data([[1, 2], [3, 4]], x=(0, 1))
    data("[[1, 2], [3, 4]]", y=1)  # wrong
    surface(grid, color=grid.z)


def looks() -> None:
    surface("x", theta=0.5, rho_z=1, zfrac=None, dither=True, lines=(14, 13), every=2)
    surface("x", axes=("time", "Hz", "dB"), contours=[0.5], floor=5, title="x", on=Svg())
    surface("x", color=hill, ramp="heat", projection=orthographic(0.7, 0.5))
    surface("x", transform=rotation("z", 1.0))
    surface("x", (1, 10), log="xz")
    surface("y", (date(2026, 1, 1), datetime(2026, 1, 2)))
    surface([[1, 2], [3, 4]], np.arange("2026-01-01", "2026-01-03", dtype="datetime64[D]"))
    surface("x", log=True)  # wrong
    surface("x", colour="z")  # wrong
    surface("x", color=7)  # wrong
    surface("x", ramp=3)  # wrong
    surface("x", axes=3)  # wrong
    surface("x", title=None)  # wrong
    surface("x", contours="many")  # wrong
    surface("x", on="picture.svg")  # wrong
    surface("x", transform=2)  # wrong
    surface("x", (0, 1), (0, 1), 50, "fill", None, None, "paper")  # wrong


def bodies() -> None:
    plot: Plot = parametric(lambda u, v: (u, v, u * v), (0, 1), (0, 1), title="saddle")
    parametric(lambda u, v: (u, v, u * v), (0, 1), (0, 1), contours=5)  # wrong
    parametric(lambda u, v: (u, v, u * v), (0, 1))  # wrong
    sheet([[0, 1], [0, 1]], [[0, 0], [1, 1]], np.eye(2), color=np.eye(2), log="z")
    sheet(np.eye(2), np.eye(2))  # wrong
    sheet(np.eye(2), np.eye(2), 3)  # wrong
    point: tuple[float, float, float] = plot.pick(1, 2)  # wrong
    plot.project(point)
