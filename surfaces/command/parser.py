"""What may be typed after `python -m surfaces`, and what makes no sense together."""

import argparse
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from textwrap import fill
from typing import Any

from surfaces import checks
from surfaces.explorer import EXAMPLES, Options
from surfaces.explorer.screen import Size
from surfaces.formulas import FUNCTIONS, NAMES, OPERATORS, FormulaError, formula
from surfaces.modes import MODES
from surfaces.shape.fields import FIELDS
from surfaces.space.projections import PROJECTIONS
from surfaces.systems.colors import RAMPS

WINDOW = ""
"""What stands for a window among the endings of files."""
FILES = (".png", ".gif", ".svg", ".txt")
LARGEST = 4096
"""Pixels that a picture may be wide or high."""

INDENT = " " * 13
FUNCTION_NAMES = fill(" ".join(FUNCTIONS), 78, initial_indent=INDENT, subsequent_indent=INDENT)
EPILOG = f"""\
examples:
  python -m surfaces
  python -m surfaces "sin(x*y)/2" --axes --turn 30
  python -m surfaces "1/(x^2 + y^2)" --z 0 4 --axes -o pole.png
  python -m surfaces "sinc(r)" --x -12 12 --y -12 12 --mode mesh -o hat.svg
  python -m surfaces "cos(x)*cos(y)" --tilt 20 --frames 60 -o turning.gif

In the window F1 shows all the keys.

what a formula is made of:
  names      {", ".join(NAMES)}
  operators  {OPERATORS}
  functions  {FUNCTION_NAMES.lstrip()}

  A comparison is 1 where it holds, else 0; where(x > 0, a, b) is a or b;
  sinc(t) is sin(t)/t. Numbers after an option may be formulas, too: --x -pi 2*pi.
"""

USELESS: Mapping[str, tuple[tuple[str, ...], str]] = {
    "frames": ((WINDOW, ".png", ".svg", ".txt"), "only a .gif has several pictures"),
    "monitor": (FILES, "a file is written without one"),
    "dither": ((".svg", ".txt"), "only a screen has dots to mix"),
    "ramp": ((".txt",), "characters have no colours"),
}
"""Options that change nothing in some kinds of pictures, and why."""
USUAL: Mapping[str, Mapping[str, Any]] = {
    ".svg": {"n": 60},  # each cell is a shape: 200 by 200 would make a file of five megabytes
    ".txt": {"color": "light"},  # few characters tell light from shade better than heights
}
"""What is usual for some kinds of pictures, where the command line says nothing."""


@dataclass(frozen=True)
class Order:
    """What a command line asks for."""

    formula: str
    options: Options
    kind: str = WINDOW
    """The ending of the file in small letters, or WINDOW."""
    output: Path | None = None
    """The file to write; None: a window."""
    size: Size | None = None
    """Width and height in pixels, or of a text in characters; None: what is usual."""
    frames: int = 72
    """Pictures of a turn."""
    monitor: str | None = None
    """Where to: "window" or "none"; None: a window, if there is a display."""


def parse(arguments: Sequence[str]) -> Order:
    """Understand a command line; SystemExit, with a line that says why, if it is none."""
    parser = _parser()
    found = vars(parser.parse_args([_guarded(argument) for argument in arguments]))
    given: dict[str, Any] = {
        name: tuple(value) if isinstance(value, list) else value for name, value in found.items()
    }
    names = [field.name for field in fields(Order)]
    order = {name: given.pop(name) for name in names if name in given}
    kind = order["output"].suffix.lower() if "output" in order else WINDOW
    if problem := _useless({**order, **given}, kind):
        parser.error(problem)
    return Order(**order, kind=kind, options=Options(**{**USUAL.get(kind, {}), **given}))


def _useless(given: Mapping[str, Any], kind: str) -> str:
    """What is wrong if an option changes nothing in the picture; "" if all of them do."""
    for name, (kinds, reason) in USELESS.items():
        if name in given and kind in kinds:
            return f"--{name} has no use here: {reason}"
    if given.get("view", "paper") != "paper":
        for name in sorted({"theta", "rho_z"} & given.keys()):
            return f"--{name.replace('_', '-')} has no use here: only the paper's view has it"
    return ""


def _guarded(argument: str) -> str:
    """What begins with a minus and is no option, such as -x*y: argparse knows it by a space."""
    is_option = argument in ("-h", "-o", "-n") or argument.startswith("--")
    return f" {argument}" if argument.startswith("-") and not is_option else argument


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m surfaces",
        usage="python -m surfaces [FORMULA] [options]",
        description="Walk round a surface z = f(x, y) in a window, or draw it into a file.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        argument_default=argparse.SUPPRESS,  # what is not given is not there
        allow_abbrev=False,
    )
    for add_group in (_add_surface, _add_view, _add_look, _add_around, _add_output):
        add_group(parser)
    return parser


def _add_surface(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("the surface").add_argument
    pair: dict[str, Any] = {"nargs": 2, "type": _number()}
    add(
        "formula",
        nargs="?",
        default=EXAMPLES[0],
        metavar="FORMULA",
        help=f'z by x and y, in quotation marks ("{EXAMPLES[0]}")',
    )
    add("--x", **pair, metavar=("A", "B"), help="x from A to B (-3 to 3)")
    add("--y", **pair, metavar=("C", "D"), help="y from C to D (-3 to 3)")
    add("--z", **pair, metavar=("LOW", "HIGH"), help="cut heights off there: for poles")
    add("--log", type=_axes, metavar="AXES", help="logarithmic axes, such as x or xz")
    add("-n", "--n", type=_whole(1, 1000), help="cells in each direction (200; SVG 60)")


def _add_view(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("where one looks at it from").add_argument
    names = ", ".join(PROJECTIONS)
    add("--view", choices=PROJECTIONS, metavar="NAME", help=names)
    add("--turn", type=_number(), metavar="DEGREES", help="turn it about z")
    add("--tilt", type=_number(), metavar="DEGREES", help="then tilt it toward you")
    add(
        "--theta",
        type=_number(1, 89),
        metavar="DEGREES",
        help="how far x leans from straight down, in the paper's view (45)",
    )
    add("--rho-z", type=_number(0.01, 1), metavar="RHO", help="heights times RHO, there (1)")
    # The name that this option had first, and that surface() has for it.
    add("--projection", dest="view", choices=PROJECTIONS, help=argparse.SUPPRESS)


def _add_look(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("how it is drawn").add_argument
    add("--mode", choices=MODES, metavar="NAME", help=f"{', '.join(MODES)} (fill)")
    fields_named = f"colours tell {', '.join(FIELDS)} (z; text: light)"
    add("--color", choices=FIELDS, metavar="NAME", help=fields_named)
    add("--ramp", choices=RAMPS, metavar="NAME", help=f"{', '.join(RAMPS)} (rainbow)")
    add("--dither", action="store_true", help="in 16 colours, mixed dot by dot")
    add("--contours", type=_whole(0, 50), metavar="N", help="about N contour lines on the surface")
    add("--floor", type=_whole(0, 50), metavar="N", help="about N contour lines below it")


def _add_around(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("what stands around it").add_argument
    add("--box", action="store_true", help="a box")
    add("--axes", action="store_true", help="axes with numbers")
    add("--colorbar", action="store_true", help="what the colours stand for")
    add("--title", metavar="TEXT", help="a line above it, instead of the formula")


def _add_output(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("where to").add_argument
    file_help = f"a file {', '.join(FILES)}, instead of a window; .gif: a full turn"
    add("-o", dest="output", type=_file, metavar="FILE", help=file_help)
    add(
        "--size",
        nargs=2,
        type=_whole(1, LARGEST),
        metavar=("W", "H"),
        help="pixels (640 480); of a text, characters (78 40)",
    )
    add("--frames", type=_whole(2, 1000), metavar="N", help="pictures of a .gif (72)")
    add(
        "--monitor",
        choices=("window", "none"),
        metavar="WHERE",
        help="window, or none: then BGI_KEYS holds the keys",
    )


def _number(low: float = -math.inf, high: float = math.inf) -> Callable[[str], float]:
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


def _axes(letters: str) -> str:
    try:
        return checks.log("--log", letters.strip())
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _file(name: str) -> Path:
    if Path(name).suffix.lower() not in FILES:
        raise argparse.ArgumentTypeError(f"{name} must be a file {', '.join(FILES)}")
    return Path(name)
