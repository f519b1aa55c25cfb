"""The plotters that surfaces are measured with: each draws 640x480 pixels from the function on."""

import ctypes
import ctypes.util
import functools
import os
import shutil
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from bench.processes import cpu_seconds
from bench.timing import Task

GNUPLOTS = 2  # plots in one script


def timed(draw: Callable[[int], object]) -> Task:
    """Processor time of all threads, since numpy has its own."""

    def task(number: int) -> float:
        start = time.process_time()
        draw(number)
        return time.process_time() - start

    return task


class Matplotlib:
    """matplotlib, drawn by Agg, every cell of the grid."""

    name = "matplotlib"

    def __init__(self) -> None:
        os.environ.setdefault("MPLBACKEND", "Agg")
        import matplotlib.pyplot

        self.figure: Any = matplotlib.pyplot.figure(figsize=(6.4, 4.8), dpi=100)
        self.axes: Any = self.figure.add_subplot(projection="3d")

    def task(self, parts: Callable[[int], list[tuple[Any, Any, Any]]], n: int, kind: str) -> Task:
        """Draw points by the method `plot_surface` or `plot_wireframe`."""
        style = {"cmap": "jet"} if kind == "plot_surface" else {}

        def draw(_: int) -> None:
            self.axes.clear()
            for x, y, z in parts(n):
                plot = getattr(self.axes, kind)
                plot(x, y, z, rcount=n + 1, ccount=n + 1, linewidth=0.5, **style)
            self.figure.canvas.draw()

        return timed(draw)


class Gnuplot:
    """gnuplot into PNG. Its start is left out: one plot is subtracted from several."""

    name = "gnuplot"

    def __init__(self) -> None:
        program = shutil.which(self.name)
        if program is None:
            raise ImportError("no gnuplot")
        self.program = program

    def task(self, n: int, style: str, setting: str) -> Task:
        """Draw the ripples with lines or in colours."""

        def run(plots: int) -> float:
            with tempfile.TemporaryDirectory() as folder:
                script = Path(folder) / "script"
                picture = f"set output '{folder}/a.png'; splot sin(x**2+y**2) with {style}"
                script.write_text(
                    f"set terminal png size 640,480\nset samples {n + 1}\n{setting}\n"
                    f"set isosamples {n + 1}\nset xrange [-2.5:2.5]\nset yrange [-2.5:2.5]\n"
                    + f"{picture}; set output\n"
                    * plots,
                    encoding="utf-8",
                )
                return cpu_seconds([self.program, str(script)])

        return lambda _: (run(1 + GNUPLOTS) - run(1)) / GNUPLOTS


class Plplot:
    """PLplot's library, into memory by Cairo."""

    name = "PLplot"
    MAGNITUDE_COLOR, BOTH_DIRECTIONS = 4, 3

    def __init__(self) -> None:
        found = ctypes.util.find_library("plplot")
        if found is None:
            raise ImportError("no PLplot")
        self.library = ctypes.CDLL(found)
        self.pixels = (ctypes.c_ubyte * (640 * 480 * 4))()
        self.library.c_plsmema(640, 480, self.pixels)
        self.library.c_plsdev(b"memcairo")
        self.library.c_plinit()
        self.library.c_pladv(0)  # the only page: a second one crashes this driver

    def task(self, f: Callable[[Any, Any], Any], n: int, kind: str) -> Task:
        """Draw the ripples by `plsurf3d` or `plmesh`."""
        library, double = self.library, ctypes.c_double
        box = [double(v) for v in (1, 1, 0.5, -2.5, 2.5, -2.5, 2.5, -1, 1, 35, 45)]

        def draw(_: int) -> None:
            ticks = np.linspace(-2.5, 2.5, n + 1)
            z = np.ascontiguousarray(f(ticks[:, None], ticks))
            axis = ticks.ctypes.data_as(ctypes.c_void_p)
            lines = (z.ctypes.data + np.arange(n + 1, dtype=np.uintp) * z.strides[0]).astype(
                np.uintp
            )
            matrix = lines.ctypes.data_as(ctypes.c_void_p)
            library.c_plclear()
            library.c_plvpor(double(0), double(1), double(0), double(1))
            library.c_plwind(double(-1), double(1), double(-0.6), double(1))
            library.c_plw3d(*box)
            if kind == "plsurf3d":
                library.c_plsurf3d(axis, axis, matrix, n + 1, n + 1, self.MAGNITUDE_COLOR, None, 0)
            else:
                library.c_plmesh(axis, axis, matrix, n + 1, n + 1, self.BOTH_DIRECTIONS)

        return timed(draw)


@functools.cache
def plotters() -> dict[str, Any]:
    """The peers by name; None: not installed."""
    found: dict[str, Any] = {}
    for plotter in (Matplotlib, Gnuplot, Plplot):
        try:
            found[plotter.name] = plotter()
        except ImportError:
            found[plotter.name] = None
    return found
