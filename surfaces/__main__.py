"""The command `python -m surfaces "sin(x*y)/2"`: a formula becomes a picture.

In a window, to walk round it; or in a file: a PNG, a GIF that turns, an SVG drawing, a page of
characters. `command.parser` says what may be typed, `command.output` draws it.
"""

import sys
from collections.abc import Sequence

import numpy as np

from bgi import BGIError, NobodyThere, WindowClosed, closegraph
from surfaces.animation import PillowMissing
from surfaces.command.output import put_out
from surfaces.command.parser import parse


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the process's exit code: 0, 1 for trouble, 2 for a wrong use."""
    order = parse(sys.argv[1:] if arguments is None else arguments)
    try:
        with np.errstate(all="ignore"):  # for heights that no float can hold
            put_out(order)
    except NobodyThere as error:
        print(f"surfaces: {error}", file=sys.stderr)
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


if __name__ == "__main__":
    sys.exit(main())
