"""What a whole picture of a surface costs, beside other plotters where they are installed.

A frame is everything: the function evaluated, hidden parts found, 640x480 pixels drawn. The median
of some frames counts. matplotlib and gnuplot draw the same function on as many cells into a picture
of as many pixels; neither is needed for anything else. What gnuplot does once, to start and to open
its terminal, is left out: one plot is subtracted from several.
"""

import os
import shutil
import statistics
import subprocess
import tempfile
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from typing import Any

import bgi
from surfaces import FIGURES, rotation, surface

SIZES = (100, 200, 400)
FRAMES, OTHER_FRAMES = 15, 5
AXIS = (1.0, 2.0, 3.0)
RIPPLES = FIGURES[1]


def median(frame: Callable[[int], object], count: int) -> float:
    """Seconds for a frame; `frame` is given its number."""
    times = []
    for number in range(count + 1):
        start = time.perf_counter()
        frame(number)
        times.append(time.perf_counter() - start)
    return statistics.median(times[1:])  # the first one warms up


def ours(n: int, tumbling: bool = False, **how: Any) -> float:
    """Seconds for one of our frames."""

    def frame(number: int) -> None:
        turn = rotation(AXIS, 0.21 * number) if tumbling else None
        bgi.cleardevice()
        surface(
            RIPPLES.f,
            RIPPLES.x,
            RIPPLES.y,
            n,
            transform=turn,
            zfrac=RIPPLES.zfrac,
            **how,
        )

    return median(frame, FRAMES)


def memory(n: int, **how: Any) -> float:
    """The most bytes that one of our frames takes while it is drawn."""
    tracemalloc.start()
    surface(RIPPLES.f, RIPPLES.x, RIPPLES.y, n, **how)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return peak


def matplotlib_surface(n: int) -> float | None:
    """Seconds for plot_surface with every cell, drawn by Agg; None where there is no matplotlib."""
    try:
        os.environ.setdefault("MPLBACKEND", "Agg")
        import matplotlib.pyplot as plt
        import numpy as np
    except ImportError:
        return None
    figure = plt.figure(figsize=(6.4, 4.8), dpi=100)
    axes: Any = figure.add_subplot(projection="3d")

    def frame(number: int) -> None:
        axes.clear()
        x, y = np.meshgrid(np.linspace(*RIPPLES.x, n + 1), np.linspace(*RIPPLES.y, n + 1))
        z = RIPPLES.f(x, y)
        axes.plot_surface(x, y, z, rcount=n + 1, ccount=n + 1, cmap="jet", linewidth=0)
        figure.canvas.draw()

    seconds = median(frame, OTHER_FRAMES)
    plt.close(figure)
    return seconds


def gnuplot(n: int, style: str, setting: str) -> float | None:
    """Seconds for one of gnuplot's frames as PNG; None where there is no gnuplot."""
    program = shutil.which("gnuplot")
    if program is None:
        return None
    low, high = RIPPLES.x
    head = [
        f"set terminal png size 640,480; set isosamples {n + 1}; set samples {n + 1}; {setting}",
        f"set xrange [{low}:{high}]; set yrange [{low}:{high}]",
    ]
    with tempfile.TemporaryDirectory() as folder:

        def run(plots: int) -> float:
            one = f"set output '{folder}/a.png'; splot sin(x**2+y**2) with {style}; set output"
            script = Path(folder) / "script"
            script.write_text("\n".join([*head, *[one] * plots]), encoding="utf-8")
            start = time.perf_counter()
            subprocess.run([program, script], check=True, capture_output=True)
            return time.perf_counter() - start

        more = 2 if n > 200 else OTHER_FRAMES
        return (run(1 + more) - run(1)) / more


def report() -> None:
    """Print the table, and how many times as long the others take."""
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
    print(f"{'sin(x^2+y^2), 640x480, milliseconds':38}" + "".join(f"{n:>9}" for n in SIZES))
    rows: dict[str, dict[int, float | None]] = {}
    tasks: dict[str, Callable[[int], float | None]] = {
        "fill": lambda n: ours(n),
        "fill, tumbling": lambda n: ours(n, tumbling=True),
        "fill+mesh": lambda n: ours(n, mode="fill+mesh"),
        "mesh of 50 lines": lambda n: ours(n, mode="mesh"),
        "mesh of all lines": lambda n: ours(n, mode="mesh", every=1),
        "facets (array fillpoly)": lambda n: ours(n, mode="facets"),
        "matplotlib plot_surface": matplotlib_surface,
        "gnuplot hidden3d": lambda n: gnuplot(n, "lines", "set hidden3d") if n <= 200 else None,
        "gnuplot pm3d": lambda n: gnuplot(n, "pm3d", "set pm3d depthorder"),
    }
    for name, task in tasks.items():
        rows[name] = {n: task(n) for n in SIZES}
        shown = "".join(f"{'-' if s is None else f'{1e3 * s:.1f}':>9}" for s in rows[name].values())
        print(f"{name:38}{shown}")
    print(f"\n{'times as long':38}" + "".join(f"{n:>9}" for n in SIZES))
    pairs = [
        ("matplotlib plot_surface", "fill"),
        ("gnuplot pm3d", "fill"),
        ("gnuplot hidden3d", "mesh of all lines"),
    ]
    for other, own in pairs:
        ratios = [_ratio(rows[other][n], rows[own][n]) for n in SIZES]
        print(f"{f'{other} / {own}':38}" + "".join(f"{ratio:>9}" for ratio in ratios))
    print(f"\n{'memory of a frame, MiB':38}" + "".join(f"{n:>9}" for n in SIZES))
    for mode in ("fill", "fill+mesh", "mesh", "facets"):
        shown = "".join(f"{memory(n, mode=mode) / (1 << 20):>9.1f}" for n in SIZES)
        print(f"{mode:38}{shown}")
    bgi.closegraph()


def _ratio(other: float | None, own: float | None) -> str:
    return "-" if other is None or own is None else f"{other / own:.0f}"
