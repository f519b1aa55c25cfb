"""SCORES.C: points are kept in a file, and read again letter by letter.

Files are opened in the folder that the program is started in; of a path the name counts.
"""

import sys

from bgi.conio import EOF
from bgi.stdio import printf, putchar


def open_file(name, mode):
    """A file of this folder; None if it cannot be opened."""
    name = name.replace("\\", "/").rpartition("/")[2]
    try:
        return open(name, mode, encoding=None if "b" in mode else "cp437")
    except OSError:
        return None


def next_code(file):
    """The code of the next character of a file; -1 at its end, as in C."""
    letter = file.read(1)
    return ord(letter) if letter else -1


NAME = "SCORES.TXT"

fp = None


def keep(name, points):
    global fp
    fp = open_file(NAME, "a")
    fp.write(f"{name} {points}\n")
    fp.write("*")
    fp.write("\n")
    fp.close()


def main():
    lines = 0
    in_ = open_file(NAME, "r")

    if in_ is None:
        printf("No scores yet.\n")
    else:
        in_.close()
    keep("Ada", 500)
    keep("Charles", 320)
    in_ = open_file(NAME, "rt")
    if in_ is None:
        sys.exit(1)
    while (c := next_code(in_)) != EOF:
        putchar(c)
        if c == 10:
            lines += 1
    in_.seek(0)
    printf("%d lines, the first letter is %c\n", lines, next_code(in_))
    in_.close()


if __name__ == "__main__":
    main()
