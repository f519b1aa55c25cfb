"""The command `python -m bgi`: run a graphics program somehow else, or say what this machine has.

    python -m bgi --monitor none --after 2s --record bounce.gif bounce.py

runs a program, any program, unchanged: without a window, in a time of its own, for two seconds. The
options stand before the program's name; whatever follows it is the program's.
"""

import argparse
import io
import os
import platform
import runpy
import sys
from collections.abc import Sequence
from contextlib import nullcontext
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from types import ModuleType, TracebackType

from bgi import __version__, current
from bgi.fonts import DATA
from bgi.graphics.slow import parse_rate
from bgi.kernel import hints
from bgi.machine import display_exists
from bgi.memory.sdl import FOUND, pygame, quietly, twins
from bgi.monitor import ending
from bgi.monitor.plan import note, written
from bgi.monitor.recorder import missing
from bgi.monitor.script import parse_script, parse_time
from bgi.monitor.web.pagewindow import PageWindow
from bgi.stdio import on_screen

VARIABLES = {
    "monitor": "BGI_MONITOR",
    "keys": "BGI_KEYS",
    "shot": "BGI_SHOT",
    "after": "BGI_AFTER",
    "record": "BGI_RECORD",
    "open": "BGI_WEB_OPEN",
    "slow": "BGI_SLOW",
    "step": "BGI_STEP",
}
"""The options that are for the program's monitor."""


CTRL_C = 130
"""The exit status of a C program that is ended by it."""

ENDINGS = (".c", ".cpp", ".cc", ".cxx")
"""Of the files that are C programs, in any case."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the process's exit status."""
    parser = _parser()
    options = parser.parse_args(arguments)
    if options.info:
        _say_what_there_is()
        return 0
    words = options.program[options.program[:1] == ["--"] :]  # which may end the options
    words = _port_behind(words, options)
    program, *rest = words or parser.error("which program? Give its file, or --info")
    if options.record and (reason := missing()):
        parser.error(reason)
    if options.open and (options.monitor or os.environ.get("BGI_MONITOR")) != "web":
        parser.error("--open goes with --monitor web")
    if options.monitor == "web" and (reason := PageWindow.missing()):
        parser.error(reason)
    given = {name: _told(value) for name in VARIABLES if (value := getattr(options, name))}
    os.environ.update({VARIABLES[name]: value for name, value in given.items()})
    if not os.path.exists(program):
        print(f"bgi: there is no program {program}", file=sys.stderr)
        return 2
    if not given:
        _say_what_stands_behind(program, rest)
    is_c = program.lower().endswith(ENDINGS)
    planned = [os.path.abspath(given[name]) for name in ("shot", "record") if name in given]
    try:
        with on_screen() if options.console else nullcontext():
            status = _run_c(program, rest, options) if is_c else _run(program, rest, options)
            current.end()
    except KeyboardInterrupt:
        if not is_c:
            raise
        status = CTRL_C
    finally:
        current.close_screen()
        unwritten = [file for file in planned if not _was_written(file)]
    return status or int(bool(unwritten))


def _port_behind(words: list[str], options: argparse.Namespace) -> list[str]:
    """`PROGRAM.C --port PROGRAM.py`: this option may stand behind a C program, too."""
    if not words or not words[0].lower().endswith(ENDINGS):
        return words
    for place, word in enumerate(words):
        name, equals, file = word.partition("=")
        if name == "--port" and (equals or place + 1 < len(words)):
            options.port = file if equals else words[place + 1]
            return words[:place] + words[place + 1 + (not equals) :]
    return words


def _told(value: object) -> str:
    """An option's value in a variable of the environment."""
    return "1" if value is True else str(value)


def _say_what_stands_behind(program: str, rest: list[str]) -> None:
    """A word to whoever gives this command options, and all of them in the wrong place."""
    options = {f"--{name}" for name in VARIABLES}
    behind = [word for word in rest if word.partition("=")[0] in options]
    if behind:
        what = f"{behind[0]} stands behind {program}, so it is for that program"
        print(f"bgi: {what}; options of python -m bgi stand before it", file=sys.stderr)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m bgi",
        usage="python -m bgi [options] PROGRAM.py [its arguments]\n"
        "       python -m bgi [options] PROGRAM.C [more files] [its arguments]\n"
        "       python -m bgi --info",
        description="Run a graphics program, in Python or in C for Turbo C, with keys that press "
        "themselves and pictures taken.",
        allow_abbrev=False,
    )
    parser.add_argument(
        "program",
        nargs=argparse.REMAINDER,
        metavar="PROGRAM.py",
        help="the program's file, and its arguments",
    )
    parser.add_argument(
        "--monitor",
        choices=("window", "web", "none"),
        help="where to draw (default: where there is room); web: in a browser",
    )
    parser.add_argument("--open", action="store_true", help="with web: open the browser")
    parser.add_argument(
        "--keys", type=_script, metavar='"1 Left Wait2s Esc"', help="keys to press for the program"
    )
    parser.add_argument("--shot", metavar="FILE.png", help="write what is on the screen at the end")
    parser.add_argument(
        "--after", type=_seconds, metavar="2s", help="end the program then; default: when it ends"
    )
    parser.add_argument(
        "--console", action="store_true", help="print and input on the screen, as printf and scanf"
    )
    parser.add_argument("--record", metavar="FILE.gif", help="write all that is on the screen")
    parser.add_argument(
        "--slow", type=_rate, metavar="500", help="set so many pixels a second, to be watched"
    )
    parser.add_argument(
        "--step", action="store_true", help="wait for a key after each call, and say its line"
    )
    _add_c(parser)
    parser.add_argument("--info", action="store_true", help="say what this machine has, and end")
    parser.add_argument("--version", action="version", version=f"bgi {__version__}")
    return parser


def _add_c(parser: argparse.ArgumentParser) -> None:
    """The options for C programs."""
    group = parser.add_argument_group(
        "C programs", "for PROGRAM.C and PROGRAM.CPP, as they were written for Turbo C"
    )
    group.add_argument("--check", action="store_true", help="only say what is wrong with it")
    group.add_argument(
        "-I", action="append", default=[], metavar="DIR", help="another folder of what it includes"
    )
    group.add_argument(
        "-D", action="append", default=[], metavar="NAME=VALUE", help="define a macro"
    )
    group.add_argument("--trace", metavar="FILE", help="write a line for each call of the library")
    group.add_argument(
        "--script", metavar="A|B|FILE", help="keys and a clock that are always the same"
    )
    group.add_argument("--port", metavar="PROGRAM.py", help="write it in Python, and do not run it")
    group.add_argument("--files", action="store_true", help="let it write files in its folder")


def _run_c(program: str, arguments: list[str], options: argparse.Namespace) -> int:
    """Run a C program; returns the exit status."""
    from bgi.turboc.command import run_c  # late, as only C programs need it

    try:
        return run_c(
            program,
            arguments,
            check=options.check,
            folders=options.I,
            defined=options.D,
            trace=options.trace,
            script=options.script,
            files=options.files,
            port=options.port,
        )
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt) and not ending.reason(error):
            raise
        return _report(error)


def _script(text: str) -> str:
    try:
        parse_script(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return text


def _rate(text: str) -> int:
    try:
        return parse_rate(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error).partition("; ")[2]) from None


def _seconds(text: str) -> float:
    try:
        return parse_time(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _run(program: str, arguments: list[str], options: argparse.Namespace) -> int:
    """Run a program as `python PROGRAM.py` would; returns the exit status."""
    watched = options.trace or options.script
    sys.argv = [program, *arguments]
    if not sys.flags.safe_path:  # otherwise Python puts no folder there
        sys.path[0] = str(Path(program).resolve().parent)
    try:
        return _run_watched(program, options) if watched else _execute(program)
    except SystemExit as end:
        return _status(end)
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt) and not ending.reason(error):
            raise  # Ctrl-C: a status of its own
        return _report(error)


def _run_watched(program: str, options: argparse.Namespace) -> int:
    """Run a program under a script, or with a trace; returns the exit status."""
    from bgi.turboc.runtime.session import Session  # late, as few programs need it
    from bgi.turboc.watching import watched

    def main() -> int:
        try:
            return _execute(program, names)
        except SystemExit as end:
            return _status(end)

    trace = Path(options.trace) if options.trace else None
    try:
        session = Session(trace, options.script, Path(program).parent, options.files)
    except ValueError as error:
        print(f"bgi: {error}", file=sys.stderr)
        return 2
    with watched(session) as names:
        return session.run(main)


def _execute(program: str, names: dict[str, object] | None = None) -> int:
    """Run a program, which finds names besides Python's; returns 0, if it does not end itself."""
    if os.path.isdir(program):
        runpy.run_path(program, names, run_name="__main__")
        return 0
    module = sys.modules["__main__"] = ModuleType("__main__")
    module.__file__ = os.path.abspath(program)
    module.__dict__.update(names or {})
    with io.open_code(program) as file:
        code = compile(file.read(), module.__file__, "exec", dont_inherit=True)
    exec(code, module.__dict__)
    return 0


def _report(error: BaseException) -> int:
    """Say what the program ended by, without our part of the traceback; the exit status."""
    traceback: TracebackType | None = error.__traceback__
    while traceback and traceback.tb_frame.f_code.co_filename == __file__:
        traceback = traceback.tb_next
    hints.add_to(error, traceback)
    try:
        sys.excepthook(type(error), error.with_traceback(traceback), traceback)
    except SystemExit as end:
        return _status(end)
    return 1


def _status(end: SystemExit) -> int:
    """The exit status of a program that called sys.exit(); a text is said, and means 1."""
    if end.code is None or isinstance(end.code, int):
        return end.code or 0
    print(end.code, file=sys.stderr)
    return 1


def _was_written(file: str) -> bool:
    """Whether a planned file was written, and say so; a failure has been said where it occurred."""
    if file not in written:
        note(file, "the program opened no screen")
    if written[file]:
        print(f"bgi: {file} was written", file=sys.stderr)
    return written[file]


def _say_what_there_is() -> None:
    """Print what this machine has."""
    for name, value in {
        "bgi": __version__,
        "python": f"{platform.python_version()} ({platform.platform(terse=True)})",
        "numpy": _installed("numpy"),
        "pygame": _pygame(),
        "pillow": _installed("pillow") or "not installed: no recording",
        "websockets": _installed("websockets") or "not installed: no page in a browser",
        "display": _display(),
        "sound": _sound(),
        "fonts": _fonts(),
    }.items():
        print(f"{name:10}  {value}")


def _pygame() -> str:
    if not FOUND:
        return "not installed: no window"
    maker = " of pygame-ce" if hasattr(pygame, "IS_CE") else ""
    sdl = ".".join(map(str, pygame.get_sdl_version()))
    return "; ".join(filter(None, (f"{pygame.version.ver}{maker} (SDL {sdl})", twins())))


def _installed(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def _display() -> str:
    if not (FOUND and display_exists()):
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
    if not FOUND:
        return "none"
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
    names = (os.path.splitext(file) for file in sorted(os.listdir(DATA)))
    return ", ".join(name for name, kind in names if kind == ".CHR")


if __name__ == "__main__":
    sys.exit(main())
