"""The command `python -m surfaces "sin(x*y)/2"`: a formula becomes a picture.

In a window, or in a file: a PNG, a GIF that turns, an SVG drawing, a page of characters.
"""

import argparse
import math
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from textwrap import fill
from typing import Any

import numpy as np

from bgi import (
    IBM8514,
    IBM8514LO,
    YELLOW,
    BGIError,
    WindowClosed,
    cleardevice,
    closegraph,
    getch,
    initgraph,
    setactivepage,
    setcolor,
    swapbuffers,
    writeimagefile,
)
from bgi.machine import display_exists
from surfaces.animation import PillowMissing, progress, save_gif
from surfaces.formulas import FUNCTIONS, NAMES, OPERATORS, FormulaError, formula
from surfaces.modes import MODES
from surfaces.plot import surface
from surfaces.shape.fields import FIELDS
from surfaces.space.projections import PROJECTIONS
from surfaces.space.transforms import rotation
from surfaces.systems.characters import Text
from surfaces.systems.colors import RAMPS
from surfaces.systems.svg import Svg

MODE = (IBM8514, IBM8514LO)
LEFT, RIGHT = 75, 77
STEP = 5.0  # degrees that an arrow key turns
FRAME = 50  # milliseconds that a GIF shows each picture
TITLE = 78  # characters that fit above the picture

FILES = "file .png, .gif (a full turn), .svg or .txt"

Draw = Callable[..., None]
"""Draws the surface: what is given here goes before what the command line says."""

NO_DISPLAY = "no display to open a window on; try: -o picture.png (or .gif .svg .txt)"
EPILOG = f"""\
names      {", ".join(NAMES)}
operators  {OPERATORS}
functions  {fill(" ".join(FUNCTIONS), 76, subsequent_indent=" " * 11)}

A comparison is 1 where it holds, else 0; where(x > 0, a, b) is a or b; sinc(t) is sin(t)/t.
Ranges and angles may be formulas, too: --x -2*pi 2*pi.

  python -m surfaces "sin(x*y)/2"
  python -m surfaces "sinc(r)" --x -12 12 --y -12 12 --mode mesh -o hat.svg
  python -m surfaces "1/(x^2 + y^2)" --z 0 4 --axes -o pole.png
  python -m surfaces "cos(x)*cos(y)" --frames 60 -o turning.gif
"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the process's exit code: 0, 1 for trouble, 2 for a wrong use."""
    given = sys.argv[1:] if arguments is None else arguments
    options = _parser().parse_args([_guarded(argument) for argument in given])
    try:
        draw = _drawing(options)
        with np.errstate(all="ignore"):  # for heights that no float can hold
            WRITERS[options.output.suffix.lower() if options.output else ""](draw, options)
    except WindowClosed:
        pass  # the user has had enough
    except KeyboardInterrupt:
        return 130
    except ValueError as error:  # no formula, or one that cannot be drawn
        print(f"surfaces: {error}", file=sys.stderr)
        return 2
    except (BGIError, PillowMissing, OSError) as error:
        print(f"surfaces: {error}", file=sys.stderr)
        return 1
    finally:
        closegraph()
    return 0


def _guarded(argument: str) -> str:
    """What begins with a minus and is no option, such as -x*y: argparse knows it by a space."""
    is_option = argument in ("-h", "-o", "-n") or argument.startswith("--")
    return f" {argument}" if argument.startswith("-") and not is_option else argument


def _drawing(options: argparse.Namespace) -> Draw:
    """The surface that the command line describes; FormulaError if its formula is none."""
    f, text = formula(options.formula), " ".join(options.formula.split())
    settings: dict[str, Any] = {
        "x": tuple(options.x),
        "y": tuple(options.y),
        "z": tuple(options.z) if options.z else None,
        "n": options.n or 200,
        "mode": options.mode,
        "transform": rotation("z", math.radians(options.turn)) if options.turn else None,
        "projection": options.projection,
        "theta": math.radians(options.theta),
        "rho_z": options.rho_z,
        "color": options.color or "z",
        "ramp": options.ramp,
        "contours": options.contours,
        "axes": options.axes,
        "colorbar": options.colorbar,
        "title": f"z = {text}"[:TITLE],
    }

    def draw(**changes: Any) -> None:
        surface(f, **(settings | changes))

    return draw


def _page(draw: Draw, **changes: Any) -> None:
    """Draw on the page of the screen that is the current one."""
    cleardevice()
    setcolor(YELLOW)
    draw(**changes)


def _window(draw: Draw, options: argparse.Namespace) -> None:
    """Show it until a key comes; the arrows turn it."""
    if not os.environ.get("BGI_MONITOR") and not display_exists():
        raise BGIError(NO_DISPLAY)
    initgraph(*MODE)
    setactivepage(1)
    turn = options.turn
    while True:
        _page(draw, transform=rotation("z", math.radians(turn)))
        swapbuffers()
        if getch() != 0:
            return
        turn += {LEFT: -STEP, RIGHT: STEP}.get(getch(), 0.0)


def _hidden_screen() -> None:
    os.environ["BGI_MONITOR"] = "none"
    initgraph(*MODE)


def _png(draw: Draw, options: argparse.Namespace) -> None:
    _hidden_screen()
    _page(draw)
    writeimagefile(options.output)


def _gif(draw: Draw, options: argparse.Namespace) -> None:
    """A full turn about z, in equal steps."""
    _hidden_screen()
    with TemporaryDirectory() as folder:
        save_gif(options.output, _turn(draw, options, Path(folder)), FRAME)


def _turn(draw: Draw, options: argparse.Namespace, folder: Path) -> Iterator[Path]:
    for number in progress(range(options.frames), "drawing"):
        angle = options.turn + 360 * number / options.frames
        _page(draw, transform=rotation("z", math.radians(angle)))
        picture = folder / f"{number}.png"
        writeimagefile(picture)
        yield picture


def _svg(draw: Draw, options: argparse.Namespace) -> None:
    picture = Svg()
    # Each cell is a shape of its own: 200 by 200 would make a file of five megabytes.
    draw(on=picture, n=options.n or 60, lines=None if "fill" in options.mode else YELLOW)
    picture.save(options.output)


def _txt(draw: Draw, options: argparse.Namespace) -> None:
    page = Text()
    # Few characters tell light from shade better than one height from another.
    draw(on=page, color=options.color or "light")
    options.output.write_text(f"{page}\n", encoding="utf-8")


WRITERS: dict[str, Callable[[Draw, argparse.Namespace], None]] = {
    "": _window,
    ".png": _png,
    ".gif": _gif,
    ".svg": _svg,
    ".txt": _txt,
}


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m surfaces",
        description='Draw a surface z = f(x, y) from its formula, such as "sin(x*y)/2".',
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    add, any_number = parser.add_argument, _number(-math.inf, math.inf)
    pair: dict[str, Any] = {"nargs": 2, "type": any_number}
    add("formula", metavar="FORMULA", help="z as a formula of x and y, in quotation marks")
    add("-o", dest="output", type=_file, metavar="FILE", help=f"{FILES}, instead of a window")
    add("--x", **pair, default=(-3, 3), metavar=("A", "B"), help="x from A to B (-3 to 3)")
    add("--y", **pair, default=(-3, 3), metavar=("C", "D"), help="y from C to D (-3 to 3)")
    add("--z", **pair, metavar=("LOW", "HIGH"), help="cut heights off there: for poles")
    add("-n", "--n", type=_whole(1, 1000), help="cells in each direction (200; SVG 60)")
    add("--mode", choices=MODES, default="fill", help=f"{', '.join(MODES)} (fill)", metavar="M")
    add("--turn", type=any_number, default=0.0, metavar="DEGREES", help="turn it about z")
    add("--projection", choices=PROJECTIONS, help=", ".join(PROJECTIONS), metavar="P")
    add(
        "--theta",
        type=_number(1, 89),
        default=45.0,
        metavar="DEGREES",
        help="how far x leans from straight down, in the paper's projection (45)",
    )
    add("--rho-z", type=_number(0.01, 1), default=1.0, metavar="RHO", help="heights times RHO (1)")
    add("--color", choices=FIELDS, help=f"by {', '.join(FIELDS)} (z; text: light)", metavar="C")
    add("--ramp", choices=RAMPS, default="rainbow", help=f"{', '.join(RAMPS)}", metavar="R")
    add("--contours", type=_whole(0, 50), default=0, metavar="N", help="draw about N contours")
    add("--axes", action="store_true", help="draw axes with numbers")
    add("--colorbar", action="store_true", help="tell what the colours stand for")
    add("--frames", type=_whole(2, 1000), default=72, metavar="N", help="pictures of a GIF (72)")
    return parser


def _number(low: float, high: float) -> Callable[[str], float]:
    """A reader of numbers within limits; they may be formulas, such as -2*pi."""

    def read(text: str) -> float:
        try:
            value = float(formula(text)(math.nan, math.nan))  # NaN wherever x or y is used
        except FormulaError as error:
            raise argparse.ArgumentTypeError(f"{text.strip()}: {error.problem}") from None
        if not (math.isfinite(value) and low <= value <= high):
            limits = "" if low == -math.inf else f" from {low:g} to {high:g}"
            raise argparse.ArgumentTypeError(f"{text.strip()} is no number{limits}")
        return value

    return read


def _whole(low: int, high: int) -> Callable[[str], int]:
    """A reader of whole numbers within limits."""

    def read(text: str) -> int:
        if not (text.strip().isdecimal() and low <= int(text) <= high):
            problem = f"{text.strip()} is no whole number from {low} to {high}"
            raise argparse.ArgumentTypeError(problem)
        return int(text)

    return read


def _file(name: str) -> Path:
    if Path(name).suffix.lower() not in WRITERS.keys() - {""}:
        raise argparse.ArgumentTypeError(f"{name} must be a {FILES}")
    return Path(name)


if __name__ == "__main__":
    sys.exit(main())
