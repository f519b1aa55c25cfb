"""What crosses between program and window: lines of text, a word and its arguments.

========================  ==============================================================
to the window             meaning
========================  ==============================================================
``show N``                show the visible page now, answer ``shown N``
``title TEXT``            name the window
``sound HERTZ``           play that pitch; 0: silence
``pointer STATE``         the mouse driver's arrow is ``shown`` or ``hidden``, or the
                          ``system`` shows its own
``shape X Y WORDS``       give the arrow another look: hot spot, and 32 words as
                          `bgi.monitor.art.from_masks` has them; without numbers: its own
``move X Y``              put the pointer on that pixel
``limits L T R B``        keep the pointer in there; without numbers: everywhere
``lens TIMES FOLLOWS``    enlarge so many times, 0 for no more, what is at the ``mouse``, or
                          the ``pixels`` that are set last
``facts TEXT``            what the program's screen is like, a line each
``record FILE``           record what is on show from now on, until the end
(end of input)            the program has ended: go
========================  ==============================================================

========================  ==============================================================
to the program            meaning
========================  ==============================================================
``ready``                 the window is open
``failed REASON``         there is no window
``key A`` ``key 0 S``     a key was pressed: the bytes of `bgi.monitor.keycodes.encode`
``held FLAGS NAMES``      all that is down now: the Shift keys and their like, by
                          `bgi.monitor.keycodes.shift_flags`, and the names of the keys
``mouse EVENT X Y HELD``  an event of `bgi.monitor.pointer`, where, and the buttons held
``wheel CLICKS``          its wheel was turned, down or (less than 0) up
``shown N PRESENTS``      picture N is on show, the PRESENTS-th since the start
``recording``             something is being recorded: writing it will take its time
``recorded FAILURE``      the recording asked for is written, or what kept it from being
``facts``                 how is the program's screen?
``closed``                the user has closed the window
``address HOST PORT``     where a browser finds the page; more of it: `TOKEN`, and `wide`
                          (or `local`) if other machines reach it
``pages COUNT``           how many pages look
========================  ==============================================================
"""

import os
import sys
from collections.abc import Iterator

TITLE = "pybgi"
"""The name of a window that has not been given another."""


def encode(word: str, *arguments: object) -> bytes:
    """A message as one line of ASCII, whatever its text contains."""
    return " ".join((word, *map(str, arguments))).encode("unicode_escape") + b"\n"


def decode(line: bytes) -> tuple[str, str]:
    """The word and the rest of a line; never fails, an unknown word is the reader's to ignore."""
    word, _, rest = line.decode("unicode_escape", "replace").partition(" ")
    return word, rest


def receive(fd: int) -> Iterator[tuple[str, str]]:
    """The messages from a pipe until it ends.

    Read with os.read: a buffered file has a lock, and a thread that holds it while the interpreter
    shuts down is a fatal error.
    """
    pending = b""
    while chunk := os.read(fd, 4096):
        *lines, pending = (pending + chunk).split(b"\n")
        yield from map(decode, lines)


def take_pipes() -> tuple[int, int]:
    """The ends of the two pipes in the window's process: what it is told, and where it answers.

    Nothing else comes upon them. What a library prints goes to the terminal, and it reads nothing:
    on Windows even a library that is only loaded looks at the standard input, and waits there for
    whoever reads the pipe.
    """
    told, answers = os.dup(0), os.dup(1)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)
    if sys.platform != "win32":
        os.set_blocking(answers, False)
    return told, answers
