"""The command `python -m demos`: the gallery, one demo, or every demo's picture as a file."""

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from bgi import BGIError, WindowClosed, closegraph, initgraph, writeimagefile
from bgi.monitor import display_exists
from demos import NAMES, load, menu, summary

NO_DISPLAY = "demos: no display to open a window on; try: python -m demos --save DIR"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the process's exit code."""
    options = _parser().parse_args(arguments)
    names = (options.name,) if options.name else NAMES
    if options.list:
        for name in names:
            print(f"{name:13}{summary(load(name))}")
        return 0
    if options.save is None and not os.environ.get("BGI_MONITOR") and not display_exists():
        print(NO_DISPLAY, file=sys.stderr)
        return 1
    try:
        if options.save is not None:
            _save(names, options.save)
        elif options.name:
            load(options.name).main()
        else:
            _gallery()
    except WindowClosed:
        pass  # the user has had enough
    except KeyboardInterrupt:
        return 130
    except (BGIError, OSError) as error:
        print(f"demos: {error}", file=sys.stderr)
        return 1
    finally:
        closegraph()
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m demos",
        description="Show what graphics.h can do: a gallery of demos, or one of them.",
    )
    parser.add_argument(
        "name", nargs="?", choices=NAMES, metavar="NAME", help=f"run one demo: {', '.join(NAMES)}"
    )
    parser.add_argument("--list", action="store_true", help="list the demos")
    parser.add_argument(
        "--save", type=Path, metavar="DIR", help="write their pictures as PNG; needs no display"
    )
    return parser


def _gallery() -> None:
    """The menu, the demo chosen, the menu again."""
    place = menu.choose(0)
    while place is not None:
        load(NAMES[place]).main()
        place = menu.choose(place)


def _save(names: Sequence[str], folder: Path) -> None:
    """Draw demos where nobody looks, and write what they drew."""
    os.environ["BGI_MONITOR"] = "none"
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        demo = load(name)
        initgraph(*demo.MODE)
        demo.draw()
        file = folder / f"{name}.png"
        writeimagefile(file)
        print(file)


if __name__ == "__main__":
    sys.exit(main())
