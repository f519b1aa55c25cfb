"""Scripts of one's own: a file that says what is pressed, typed and pointed at, and when.

Each line begins with a word: `keys Enter 1 Left` are pressed once, `endless Esc` after them for
ever; `typed 100 200` are typed for scanf() and cin, a line each, again and again; `line Ada Byron`
is a whole line; `mouse 100 50 1` is one look at the mouse, with the sum of its buttons; `clock
1992-06-15 12:00:00` is when the program begins. A line that begins with # says nothing.
"""

from __future__ import annotations

import calendar
import time as _time
from pathlib import Path

from bgi.turboc.runtime.scripted import Script, Scripted, codes, script, typed_lines

NAMES = ("A", "B")
"""Scripts that are there already."""


def scripted(name: str) -> Scripted:
    """A scripted PC, by A or B or by a file; ValueError says what is wrong with the file."""
    if name in NAMES:
        return script(name)
    try:
        lines = Path(name).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(f"--script is A, B or a file: {name}: {error}") from None
    made = Script("", [], [], [])
    for number, line in enumerate(lines, 1):
        try:
            _follow(made, line)
        except ValueError as error:
            raise ValueError(f"{name}:{number}: {error}") from None
    made.typed = made.typed or "\n"
    made.endless = made.endless or codes("Esc")
    made.looks = made.looks or [(0, 0, 0)]
    return Scripted(made)


def _follow(made: Script, line: str) -> None:
    """Take what one line says."""
    word, _, rest = line.strip().partition(" ")
    rest = rest.strip()
    match word:
        case "" | "#":
            pass
        case "keys":
            made.keys += codes(rest)
        case "endless":
            made.endless += codes(rest)
        case "typed":
            made.typed += typed_lines(" ".join(rest.split()))
        case "line":
            made.typed += f"{rest}\n"
        case "mouse":
            made.looks.append(_look(rest))
        case "clock":
            made.start = calendar.timegm(_time.strptime(rest, "%Y-%m-%d %H:%M:%S"))
        case _ if not word.startswith("#"):
            raise ValueError(f"{word} is none of keys, endless, typed, line, mouse, clock")


def _look(text: str) -> tuple[int, int, int]:
    """A place of the mouse, and its buttons."""
    numbers = [int(one) for one in text.split()]
    if len(numbers) not in (2, 3):
        raise ValueError("mouse needs x, y, and the buttons if any are down")
    x, y, *buttons = numbers
    return (buttons[0] if buttons else 0), x, y
