"""A form to fill in, with windows that open over each other and go again.

    python demos/22_form.py

What it shows: gettext() keeps what a window covers, puttext() brings it back. A field is a few
cells of another colour in which keys are edited: getch() tells of arrows as a 0 and a scan code.
Tab, Enter, up and down change the field, F1 helps, F10 shows all, Esc ends.
"""

from collections.abc import Callable

from bgi.conio import *

UP, DOWN, F1, F10 = 72, 80, 59, 68
ENTER, ESC, TAB, BACKSPACE = 13, 27, 9, 8
FIELDS = [("Name", 24), ("Street", 24), ("Town", 24), ("Telephone", 14), ("Born in", 4)]
SHADE = 0xB0  # ░ in code page 437
LEFT, TOP = 20, 7  # of the form


def frame(left: int, top: int, right: int, bottom: int, title: str, color: int) -> None:
    """A window with a shadow."""
    window(1, 1, 80, 25)
    textattr(DARKGRAY)
    for row in range(top + 1, bottom + 2):  # what is in the shadow stays to be read
        cells = bytearray(gettext(left + 2, row, right + 2, row))
        cells[1::2] = bytes([DARKGRAY]) * (len(cells) // 2)
        puttext(left + 2, row, right + 2, row, cells)
    textattr(color)
    window(left, top, right, bottom)
    clrscr()
    window(1, 1, 80, 25)
    gotoxy(left, top)
    cprintf("┌─ %s %s┐", title, "─" * (right - left - 4 - len(title)))
    for row in range(top + 1, bottom):
        for column in (left, right):
            gotoxy(column, row)
            putch("│")
    gotoxy(left, bottom)
    cputs("└" + "─" * (right - left - 1) + "┘")


def over(left: int, top: int, right: int, bottom: int, show: Callable[[], None]) -> None:
    """Show something on top, wait for a key, and bring back what was there."""
    before = gettext(left, top, right + 2, bottom + 1)
    show()
    getch()
    puttext(left, top, right + 2, bottom + 1, before)


def field(number: int, text: str, active: bool) -> None:
    """A name, and the cells to type in."""
    name, width = FIELDS[number]
    textattr(BLACK + 16 * LIGHTGRAY)
    gotoxy(LEFT + 3, TOP + 2 + 2 * number)
    cprintf("%-10s", name)
    textattr(WHITE + 16 * (BLUE if active else CYAN))
    cprintf(" %-*s ", width, text)
    gotoxy(LEFT + 14 + len(text), TOP + 2 + 2 * number)


def help_page() -> None:
    """What the keys do."""
    frame(30, 9, 62, 16, "Help", YELLOW + 16 * GREEN)
    for row, words in enumerate(["Tab Enter  next field", "Up Down    choose a field", "F10  all"]):
        gotoxy(33, 11 + row)
        cputs(words)


def all_page(texts: list[str]) -> None:
    """What has been filled in."""
    frame(26, 8, 66, 16, "All of it", WHITE + 16 * MAGENTA)
    for row, (name, _) in enumerate(FIELDS):
        gotoxy(29, 10 + row)
        cprintf("%-10s %s", name, texts[row])


def desk() -> None:
    """What lies under everything."""
    puttext(1, 1, 80, 25, bytes([SHADE, LIGHTGRAY + 16 * BLUE]) * (80 * 25))
    textattr(BLACK + 16 * LIGHTGRAY)
    gotoxy(1, 1)
    cprintf("%-80s", "  F1 Help   F10 Show all   Esc End")


textmode(C80)
desk()
frame(LEFT, TOP, LEFT + 42, TOP + 12, "A form", BLACK + 16 * LIGHTGRAY)
texts = ["Ada Lovelace", "", "London", "", "1815"]
here = 0
for number in range(len(FIELDS)):
    field(number, texts[number], False)
while True:
    field(here, texts[here], True)
    key = getch()
    if key == ESC:
        break
    scan = getch() if key == 0 else 0
    if scan == F1:
        over(30, 9, 62, 16, help_page)
    elif scan == F10:
        over(26, 8, 66, 16, lambda: all_page(texts))
    elif scan in (UP, DOWN) or key in (TAB, ENTER):
        field(here, texts[here], False)
        here = (here + (-1 if scan == UP else 1)) % len(FIELDS)
    elif key == BACKSPACE:
        texts[here] = texts[here][:-1]
    elif key >= 32 and len(texts[here]) < FIELDS[here][1]:
        texts[here] += bytes([key]).decode("cp437")
textmode(C80)
