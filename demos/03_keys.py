"""Every key that is pressed, and the numbers that a program gets for it.

    python demos/03_keys.py

What it shows: getch() returns the character of a key; for a key without one it returns a 0, and the
next call returns the key's scan code. Characters beyond ASCII come in code page 437. Esc ends.
"""

from bgi import *

MODE = (VGA, VGAHI)
ESC = 27
TOP = 72  # the first row of the table
ROW = 16  # pixels from a row to the next
ROWS = 24
COLUMNS = (16, 112, 240, 368)
HEADINGS = ("getch()", "again", "hexadecimal", "key")

CHARACTERS = {
    8: "Backspace",
    9: "Tab",
    10: "Ctrl-Enter",
    13: "Enter",
    27: "Esc",
    32: "Space",
    127: "Ctrl-Backspace",
}

# Scan codes that follow one another: the first, what the names begin with, and the keys.
SCAN_CODES = (
    (3, "", "Ctrl-@"),
    (15, "", "Shift-Tab"),
    (16, "Alt-", "Q W E R T Y U I O P"),
    (30, "Alt-", "A S D F G H J K L"),
    (44, "Alt-", "Z X C V B N M"),
    (59, "", "F1 F2 F3 F4 F5 F6 F7 F8 F9 F10"),
    (71, "", "Home Up PgUp"),
    (75, "", "Left Keypad-5 Right"),
    (79, "", "End Down PgDn Ins Del"),
    (84, "Shift-", "F1 F2 F3 F4 F5 F6 F7 F8 F9 F10"),
    (94, "Ctrl-", "F1 F2 F3 F4 F5 F6 F7 F8 F9 F10"),
    (104, "Alt-", "F1 F2 F3 F4 F5 F6 F7 F8 F9 F10"),
    (114, "Ctrl-", "PrtSc Left Right End PgDn Home"),
    (120, "Alt-", "1 2 3 4 5 6 7 8 9 0 - ="),
    (132, "", "Ctrl-PgUp"),
    (133, "", "F11 F12"),
    (135, "Shift-", "F11 F12"),
    (137, "Ctrl-", "F11 F12"),
    (139, "Alt-", "F11 F12"),
)


def name_of_scan_code(code: int) -> str:
    """What a key without a character is called."""
    for first, begin, keys in SCAN_CODES:
        names = keys.split()
        if first <= code < first + len(names):
            return begin + names[code - first]
    return "?"


def name_of_character(code: int) -> str:
    """What a key with a character is called."""
    if code in CHARACTERS:
        return CHARACTERS[code]
    if code < ord(" "):
        return "Ctrl-" + chr(code + 64)
    return bytes([code]).decode("cp437")


def head() -> None:
    """The title, and what the columns hold."""
    setcolor(WHITE)
    outtextxy(16, 16, "Press any key; Esc ends")
    setcolor(LIGHTCYAN)
    for x, text in zip(COLUMNS, HEADINGS, strict=True):
        outtextxy(x, 48, text)
    line(16, 62, getmaxx() - 16, 62, CYAN)


def cell(column: int, y: int, text: str, color: int) -> None:
    """A text in one of the columns."""
    setcolor(color)
    outtextxy(COLUMNS[column], y, text)


def row(place: int, first: int, second: int | None = None) -> None:
    """A key, in one of the rows; the row below is cleared, to show where the last one is."""
    y = TOP + ROW * place
    setfillstyle(SOLID_FILL, BLACK)
    bar(0, y - 4, getmaxx(), y - 5 + 2 * ROW)
    cell(0, y, str(first), YELLOW)
    if second is None:
        cell(2, y, f"{first:02X}", DARKGRAY)
        cell(3, y, name_of_character(first), LIGHTGRAY)
    else:
        cell(1, y, str(second), YELLOW)
        cell(2, y, f"{first:02X} {second:02X}", DARKGRAY)
        cell(3, y, name_of_scan_code(second), LIGHTGRAY)


def draw() -> None:
    """Some keys of each kind."""
    head()
    place = 0
    for code in (13, 27, 32, 97, 65, 1, 127, 129):
        row(place, code)
        place += 1
    for code in (59, 72, 80, 75, 77, 71, 83, 15, 84, 94, 115, 16, 120):
        row(place, 0, code)
        place += 1


def main() -> None:
    """Show keys, row after row, until Esc comes."""
    initgraph(*MODE)
    head()
    place = 0
    key = 0
    while key != ESC:
        key = getch()
        if key == 0:  # a key without a character: its scan code follows
            row(place, key, getch())
        else:
            row(place, key)
        place = (place + 1) % ROWS


if __name__ == "__main__":
    main()
