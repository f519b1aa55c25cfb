"""What the original's C library printed, read and computed: tests/original/stdlib.txt."""

import re
from pathlib import Path

from bgi.clib.bits import signed

FILE = Path(__file__).parent / "original" / "stdlib.txt"


def lines(start=""):
    """The lines that begin so, without the beginning."""
    text = FILE.read_text(encoding="utf-8").splitlines()
    return [line.removeprefix(start) for line in text if line.startswith(start)]


def printed():
    """What sprintf made: each a format, its arguments, the text."""
    found = [line.split("\t") for line in lines("%")]
    return [(f"%{format}", values(given), made[1:-1]) for format, given, made in found]


def read():
    """What sscanf read: each a format, the input, what it returned, the values that it stored."""
    found = []
    for line in lines("scanf "):
        format, text, answer = line.split("\t")
        returned, _, stored = answer.partition(" ")
        found.append((format, text, int(returned), stored[1:-1].split("][")))
    return found


def numbers(start):
    """The numbers and words of the line that begins so."""
    (line,) = lines(start + " ")
    return line.split()


def values(given):
    """Arguments as C wrote them, in Python; an int has 16 bits unless it ends in an L."""
    if given == "n":
        return ([],)
    if given == "np":
        return (None,)
    uncast = re.sub(r"\(.*?\)", "", given)
    found = eval(f"({re.sub(r'(?<=[0-9])[uL]', '', uncast)},)")
    return tuple(signed(v, 16) if isinstance(v, int) and "L" not in uncast else v for v in found)
