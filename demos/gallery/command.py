"""The command `python -m demos`: the gallery, one demo, or every demo's picture as a file."""

import argparse
import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from bgi import BGIError, NobodyThere, WindowClosed, closegraph
from bgi.machine import display_exists
from gallery import menu
from gallery.catalogue import load
from gallery.foreign import explain
from gallery.menu import CHOICES


def main(arguments: Sequence[str] | None = None, prog: str = "python -m demos") -> int:
    """Run the command, which is called `prog`; returns the process's exit code."""
    options = _parser(prog).parse_args(arguments)
    names = (options.name,) if options.name else CHOICES
    if options.list:
        for name in names:
            print(f"{name:13}{load(name).summary}")
        return 0
    if options.save is None and not os.environ.get("BGI_MONITOR") and not display_exists():
        print(f"demos: no display to open a window on; try: {prog} --save DIR", file=sys.stderr)
        return 1
    try:
        if options.save is not None:
            _save(names, options.save)
        elif options.name:
            load(options.name).run()
        else:
            _gallery()
    except NobodyThere as error:
        print(f"demos: {error}", file=sys.stderr)
    except WindowClosed:
        pass  # the user has had enough
    except KeyboardInterrupt:
        return 130
    except ImportError as error:
        print(f"demos: {explain(error)}", file=sys.stderr)
        return 1
    except (BGIError, OSError) as error:
        print(f"demos: {error}", file=sys.stderr)
        return 1
    finally:
        closegraph()
    return 0


def _parser(prog: str) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog=prog, description="Show what graphics.h can do: a gallery of demos, or one of them."
    )
    parser.add_argument(
        "name",
        nargs="?",
        type=_called,
        choices=CHOICES,
        metavar="NAME",
        help=f"run one demo: {', '.join(CHOICES)}",
    )
    parser.add_argument("--list", action="store_true", help="list the demos")
    parser.add_argument(
        "--save", type=Path, metavar="DIR", help="write their pictures as PNG; needs no display"
    )
    return parser


def _called(name: str) -> str:
    """The name of a demo, which may be given as its file: 02_ball, 02_ball.py, clock.c."""
    return name.upper() if name.upper() in CHOICES else re.sub(r"^\d+_|\.py$", "", name)


def _gallery() -> None:
    """The menu, the demo chosen, the menu again."""
    place = menu.choose(0)
    while place is not None:
        load(CHOICES[place]).run()
        place = menu.choose(place)


def _save(names: Sequence[str], folder: Path) -> None:
    """Draw demos where nobody looks, and write what they drew."""
    os.environ["BGI_MONITOR"] = "none"
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        file = folder / f"{name}.png"
        load(name).save(file)
        print(file)
