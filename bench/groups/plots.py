"""Surfaces: a frame is everything, from the function evaluated to 640x480 pixels drawn."""

import tracemalloc
from collections.abc import Callable
from math import pi
from typing import Any, NamedTuple

import numpy as np

import bgi
from bench.libraries import open_mode
from bench.plotters import plotters, timed
from bench.timing import OURS, Row, Task
from surfaces import FIGURES, parametric, rotation, surface

SIZES = (200, 400)
LARGE = 1600
GROWN = "at 400"
RIPPLES = FIGURES[1]
HIDDEN3D_UP_TO = 200  # cells; beyond it takes gnuplot many seconds
Points = list[tuple[Any, Any, Any]]


class Plot(NamedTuple):
    """A kind of picture: how we draw it with n x n cells, and how the peers do."""

    name: str
    draw: Callable[[int, int], object]
    """Given n and the number of the frame."""
    points: Callable[[int], Points] | None = None
    """What matplotlib draws; None: it has nothing like it."""
    matplotlib: str = "plot_surface"
    gnuplot: tuple[str, str] | None = None
    """Style and setting."""
    plplot: str | None = None


def height_field(*functions: Callable[[Any, Any], Any]) -> Callable[[int], Points]:
    """What matplotlib draws for functions over the ripples' domain."""

    def points(n: int) -> Points:
        x, y = np.meshgrid(np.linspace(*RIPPLES.x, n + 1), np.linspace(*RIPPLES.y, n + 1))
        return [(x, y, f(x, y)) for f in functions]

    return points


def ours(*functions: Callable[[Any, Any], Any], **how: Any) -> Callable[[int, int], object]:
    """A frame of ours."""
    what: Any = functions[0] if len(functions) == 1 else list(functions)
    return lambda n, number: surface(what, RIPPLES.x, RIPPLES.y, n, **how)


def turning(n: int, number: int) -> None:
    """Another view each time."""
    turn = rotation((1.0, 2.0, 3.0), 0.21 * number)
    surface(RIPPLES.f, RIPPLES.x, RIPPLES.y, n, transform=turn)


def dome(x: Any, y: Any) -> Any:
    """Half an egg, which is not everywhere."""
    with np.errstate(invalid="ignore"):
        return np.sqrt(5 - x * x - y * y)


def pole(x: Any, y: Any) -> Any:
    """1/(xy)."""
    with np.errstate(divide="ignore"):
        return 1 / (x * y)


def valley(x: Any, y: Any) -> Any:
    """A second function, to cross the ripples with."""
    return (x * x - y * y) / 4


def ring(u: Any, v: Any) -> tuple[Any, Any, Any]:
    """A torus."""
    return (3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)


def ring_points(n: int) -> Points:
    """The same for matplotlib."""
    angles = np.linspace(0, 2 * pi, n + 1)
    return [tuple(np.broadcast_arrays(*ring(angles[:, None], angles)))]  # type: ignore[list-item]


def torus(mode: str) -> Callable[[int, int], object]:
    """A frame of it."""
    return lambda n, number: parametric(ring, (0, 2 * pi), (0, 2 * pi), n, mode)


f = RIPPLES.f
PLOTS = [
    Plot("fill", ours(f), height_field(f), "plot_surface", ("pm3d", "set pm3d depthorder"),
         "plsurf3d"),
    Plot("fill, turning", turning),
    Plot("fill+mesh", ours(f, mode="fill+mesh", every=1)),
    Plot("mesh of all lines", ours(f, mode="mesh", every=1), None, "", ("lines", "set hidden3d"),
         "plmesh"),
    Plot("waterfall", ours(f, mode="waterfall", every=1)),
    Plot("wire of all lines", ours(f, mode="wire", every=1), height_field(f), "plot_wireframe"),
    Plot("contours", ours(f, contours=10)),
    Plot("facets", ours(f, mode="facets")),
    Plot("holes", ours(dome), height_field(dome)),
    Plot("pole", ours(pole, z=(-5, 5))),
    Plot("two functions", ours(f, valley), height_field(f, valley)),
    Plot("torus", torus("fill"), ring_points),
    Plot("torus, mesh", torus("mesh")),
]  # fmt: skip


def task_of(plot: Plot, n: int) -> Task:
    """A frame of ours, on a clear screen of 256 colours."""
    drawn = timed(lambda number: plot.draw(n, number))

    def task(number: int) -> float:
        open_mode(bgi.IBM8514, bgi.IBM8514LO, 256)
        bgi.cleardevice()
        return drawn(number)

    return task


def peers(plot: Plot, n: int) -> dict[str, Task]:
    """The same by the plotters that are installed and can."""
    found: dict[str, Task] = {}
    matplotlib, gnuplot, plplot = plotters().values()
    if matplotlib and plot.points:
        found["matplotlib"] = matplotlib.task(plot.points, n, plot.matplotlib)
    if gnuplot and plot.gnuplot and (plot.gnuplot[0] == "pm3d" or n <= HIDDEN3D_UP_TO):
        found["gnuplot"] = gnuplot.task(n, *plot.gnuplot)
    if plplot and plot.plplot:
        found["PLplot"] = plplot.task(f, n, plot.plplot)
    return found


def rows() -> list[Row]:
    """Every kind of picture in two sizes."""
    return [
        Row("surfaces", f"{plot.name}, {n}", {OURS: task_of(plot, n), **peers(plot, n)})
        for plot in PLOTS
        for n in SIZES
    ]


def growth_rows() -> list[Row]:
    """The same with sixteen times as many cells as in the larger size, compared with that."""
    return [
        Row(
            "growth",
            f"{plot.name}, {LARGE}",
            {OURS: task_of(plot, LARGE), GROWN: task_of(plot, SIZES[-1])},
        )
        for plot in PLOTS
    ]


def memory_rows() -> list[Row]:
    """The most memory that a frame takes while it is drawn, in MiB instead of seconds."""

    def task(plot: Plot) -> Task:
        draw = task_of(plot, LARGE)

        def peak(number: int) -> float:
            tracemalloc.start()
            draw(number)
            most = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            return most / (1 << 20)

        return peak

    return [Row("memory", f"{plot.name}, {LARGE}, memory", {OURS: task(plot)}) for plot in PLOTS]
