"""The command `python -m bgi`: run a graphics program somehow else, or say what this machine has.

    python -m bgi bounce.py --monitor none --after 2s --record bounce.gif

runs a program, any program, unchanged: without a window, in a time of its own, for two seconds. The
options may stand before the program's name or behind it; what follows a `--` is the program's.
"""

import argparse
import os
import platform
import runpy
import sys
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from bgi import current
from bgi.errors import BGIError, WindowClosed
from bgi.machine import display_exists
from bgi.memory.sdl import pygame, quietly
from bgi.monitor.keyboard import parse_script


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the process's exit code."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    rest = given.index("--") if "--" in given else len(given)
    parser = _parser()
    options, unknown = parser.parse_known_args(given[:rest])
    if options.info:
        _say_what_there_is()
        return 0
    if options.program is None:
        parser.error("which program? Give its file, or --info")
    if options.record and not _installed("pillow"):
        parser.error("recording needs Pillow; type: pip install pybgi[record]")
    for variable, value in {
        "BGI_MONITOR": options.monitor,
        "BGI_KEYS": options.keys,
        "BGI_SHOT": options.shot,
        "BGI_AFTER": options.after,
        "BGI_RECORD": options.record,
    }.items():
        if value is not None:
            os.environ[variable] = str(value)
    return _run(options.program, [*unknown, *given[rest + 1 :]])


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m bgi",
        usage="python -m bgi [options] PROGRAM.py [its arguments]\n       python -m bgi --info",
        description="Run a graphics program, with keys that press themselves and pictures taken.",
        allow_abbrev=False,
    )
    parser.add_argument("program", nargs="?", metavar="PROGRAM.py", help="the program's file")
    parser.add_argument(
        "--monitor", choices=("window", "none"), help="where to draw (default: where there is room)"
    )
    parser.add_argument(
        "--keys", type=_script, metavar='"1 Left Esc"', help="keys to press for the program"
    )
    parser.add_argument("--shot", metavar="FILE.png", help="write what is on the screen at the end")
    parser.add_argument(
        "--after", type=_seconds, metavar="2s", help="end the program then; default: when it ends"
    )
    parser.add_argument("--record", metavar="FILE.gif", help="write all that is on the screen")
    parser.add_argument("--info", action="store_true", help="say what this machine has, and end")
    return parser


def _script(text: str) -> str:
    try:
        parse_script(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return text


def _seconds(text: str) -> float:
    """A time such as 2s, 2.5 or 500ms."""
    number, unit = (text[:-2], 0.001) if text.endswith("ms") else (text.removesuffix("s"), 1)
    try:
        seconds = float(number) * unit
    except ValueError:
        seconds = -1
    if not 0 < seconds < float("inf"):
        raise argparse.ArgumentTypeError(f"{text!r} is no time: write 2s, 2.5s or 500ms")
    return seconds


def _run(program: str, arguments: list[str]) -> int:
    """Run a program as `python PROGRAM.py` would; returns the exit code."""
    if not os.path.exists(program):
        print(f"bgi: there is no program {program}", file=sys.stderr)
        return 2
    sys.argv = [program, *arguments]
    sys.path[0] = str(Path(program).resolve().parent)
    try:
        runpy.run_path(program, run_name="__main__")
    except WindowClosed:
        return 0  # by the user, or as planned
    except BGIError as error:
        print(f"bgi: {error}", file=sys.stderr)
        return 1
    finally:
        current.close_screen()
    return 0


def _say_what_there_is() -> None:
    """Print what this machine has."""
    for name, value in {
        "bgi": _installed("pybgi") or "not installed",
        "python": f"{platform.python_version()} ({platform.platform(terse=True)})",
        "numpy": _installed("numpy"),
        "pygame": f"{pygame.version.ver}{' of pygame-ce' if hasattr(pygame, 'IS_CE') else ''}"
        f" (SDL {'.'.join(map(str, pygame.get_sdl_version()))})",
        "pillow": _installed("pillow") or "not installed: no recording",
        "display": _display(),
        "sound": _sound(),
        "fonts": _fonts(),
    }.items():
        print(f"{name:8}  {value}")


def _installed(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def _display() -> str:
    if not display_exists():
        return "none"
    try:
        with quietly():
            pygame.display.init()
    except pygame.error as error:
        return f"none: {error}"
    driver = pygame.display.get_driver()
    sizes = ", ".join(f"{w}x{h}" for w, h in pygame.display.get_desktop_sizes())
    pygame.display.quit()
    return f"{sizes} (driver {driver})"


def _sound() -> str:
    from pygame import _sdl2

    try:
        with quietly():
            _sdl2.init_subsystem(_sdl2.INIT_AUDIO)
            names = _sdl2.get_audio_device_names(False)
    except (pygame.error, _sdl2.error) as error:
        return f"none: {error}"
    return ", ".join(names) or "none"


def _fonts() -> str:
    """The stroked fonts that come with the package."""
    from bgi import fonts

    found = sorted((Path(fonts.__file__).parent / "data").glob("*.CHR"))
    return ", ".join(file.stem for file in found)


if __name__ == "__main__":
    sys.exit(main())
