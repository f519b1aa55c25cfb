"""The README's section on speed: written from one kept run, so that it claims what was measured."""

from collections.abc import Iterable
from pathlib import Path

from bench.report import amount, growth, in_order, standing
from bench.saved import Run
from bench.timing import Result

README = Path(__file__).parents[1] / "README.md"
BEGIN, END = "<!-- written by python -m bench --readme -->", "<!-- until here -->"
WORST = 8
INTRODUCTION = """\
One run of `python -m bench` ({versions}),
on a machine shared with others: read the ratios rather than the times. A *unit* is an empty call of
three arguments in a loop inside a function, {unit:.0f} ns here. The last columns are the peer's
time through ours, measured in turn, in the same process: above 1, we are faster. SDL_bgi is a
library in C, here from Python in its fast mode, which draws without showing; pygame has no styles,
no viewport and no write modes. Of {common} rows that SDL_bgi has, too, we are faster in {ahead}.
The {worst} in which we are furthest behind are all in this table, marked with *."""
SURFACES = """\
Ratios of surfaces are those at 200x200. *Growth* is the exponent of the number of cells from
400x400 to 1,600x1,600: 1 is linear."""
CALLS = (
    "putpixel",
    "putpixel, floats",
    "getpixel",
    "line, 10 pixels",
    "line, random ends",
    "line, random ends, thick",
    "line, random ends, XOR",
    "rectangle 100x100",
    "circle, radius 50",
    "circle, radius 50, thick",
    "ellipse, any radii",
    "pieslice, radius 45",
    "bar 50x50",
    "bar 50x50, hatched",
    "fillpoly, triangle of 50",
    "floodfill 200x200",
    "outtextxy, 20 characters",
    "outtextxy, TRIPLEX",
    "putimage 100x100",
    "cleardevice",
    "array of 10,000 putpixel",
    "array of 2,000 quads of 5x5",
    "fern",
    "moire by XOR",
    "life",
    "bouncing ball",
)
PLOTS = (
    "fill",
    "fill, turning",
    "mesh of all lines",
    "wire of all lines",
    "facets",
    "holes",
    "two functions",
    "torus",
)


def write(run: Run) -> None:
    """Put a run's section into the README."""
    before, _, rest = README.read_text(encoding="utf-8").partition(BEGIN)
    _, _, after = rest.partition(END)
    README.write_text(f"{before}{BEGIN}\n{section(run)}\n{END}{after}", encoding="utf-8")


def section(run: Run) -> str:
    """The section: what was measured, calls, surfaces."""
    with_sdl = [result for result in run.results if "SDL_bgi" in result.ratios]
    ahead = sum(standing(result) > 1 for result in with_sdl)
    versions = ", ".join(f"{name} {number}" for name, number in run.versions.items())
    worst = [result.name for result in in_order(with_sdl)[:WORST]]
    intro = INTRODUCTION.format(
        versions=versions,
        unit=run.unit * 1e9,
        common=len(with_sdl),
        ahead=ahead,
        worst=len(worst),
    )
    return f"{intro}\n\n{calls(run, worst)}\n\n{plots(run)}"


def calls(run: Run, worst: Iterable[str]) -> str:
    """The table of calls: the chosen ones, and the worst of all."""
    shown = set(CALLS) | set(worst)
    lines = [
        "| call, 640x480 in 16 colours | units | ours | SDL_bgi | pygame |",
        "|---|--:|--:|--:|--:|",
    ]
    for r in in_order(result for result in run.results if result.name in shown):
        mark = " *" if r.name in worst else ""
        ratios = ratio(r, "SDL_bgi"), ratio(r, "pygame")
        lines.append(f"| {r.name}{mark} | {r.units:,.1f} | {amount(r)} | {' | '.join(ratios)} |")
    return "\n".join(lines)


def plots(run: Run) -> str:
    """The table of surfaces."""
    found = {result.name: result for result in run.results}
    lines = [
        "| surface, 640x480 in 256 colours | 200x200 | 400x400 | growth | matplotlib | gnuplot "
        "| PLplot |",
        "|---|--:|--:|--:|--:|--:|--:|",
    ]
    for name in PLOTS:
        small, large = found.get(f"{name}, 200"), found.get(f"{name}, 400")
        grown = found.get(f"{name}, 1600")
        if small and large and grown:
            ratios = [ratio(small, peer) for peer in ("matplotlib", "gnuplot", "PLplot")]
            cells = [amount(small), amount(large), f"{growth(grown):.2f}", *ratios]
            lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join([*lines, "", SURFACES])


def ratio(result: Result, peer: str) -> str:
    """A peer's time through ours."""
    if peer not in result.ratios:
        return ""
    times = result.ratios[peer]
    return f"{times:.2f}" if times < 10 else f"{times:,.0f}"
