"""Every key that is pressed, and the numbers that a program gets for it.

    python demos/03_keys.py

What it shows: getch() returns the character of a key; for a key without one it returns a 0, and the
next call returns the key's scan code. Characters beyond ASCII come in code page 437. Esc ends.
"""

from collections.abc import Sequence

from bgi import *

MODE = (VGA, VGAHI)
ESC = 27
TOP, ROW, ROWS = 72, 16, 24
COLUMNS = (16, 112, 240, 368)  # what getch() returned, then what it means

CHARACTERS = {8: "Backspace", 9: "Tab", 10: "Ctrl-Enter", 13: "Enter", 27: "Esc", 32: "Space"}
CHARACTERS[127] = "Ctrl-Backspace"

Name = tuple[int, str]


def run(first: int, names: Sequence[str], prefix: str = "") -> list[Name]:
    """Keys whose codes follow one another."""
    return [(first + number, prefix + name) for number, name in enumerate(names)]


FUNCTION_KEYS = [f"F{number}" for number in range(1, 11)]
SCAN_CODES: dict[int, str] = dict(
    [
        (3, "Ctrl-@"),
        (15, "Shift-Tab"),
        *run(16, "QWERTYUIOP", "Alt-"),
        *run(30, "ASDFGHJKL", "Alt-"),
        *run(44, "ZXCVBNM", "Alt-"),
        *run(59, FUNCTION_KEYS),
        *run(71, ("Home", "Up", "PgUp")),
        *((75, "Left"), (76, "5 of the keypad"), (77, "Right")),
        *run(79, ("End", "Down", "PgDn", "Ins", "Del")),
        *run(84, FUNCTION_KEYS, "Shift-"),
        *run(94, FUNCTION_KEYS, "Ctrl-"),
        *run(104, FUNCTION_KEYS, "Alt-"),
        *run(114, ("PrtSc", "Left", "Right", "End", "PgDn", "Home"), "Ctrl-"),
        *run(120, "1234567890-=", "Alt-"),
        (132, "Ctrl-PgUp"),
        *run(133, ("F11", "F12")),
        *run(135, ("F11", "F12"), "Shift-"),
        *run(137, ("F11", "F12"), "Ctrl-"),
        *run(139, ("F11", "F12"), "Alt-"),
    ]
)


def name(codes: Sequence[int]) -> str:
    """What the key is called."""
    if len(codes) == 2:
        return SCAN_CODES.get(codes[1], "?")
    code = codes[0]
    if code in CHARACTERS:
        return CHARACTERS[code]
    return f"Ctrl-{chr(code + 64)}" if code < 27 else bytes([code]).decode("cp437")


def head() -> None:
    """The title, and what the columns hold."""
    cleardevice()
    setcolor(WHITE)
    outtextxy(16, 16, "Press any key; Esc ends")
    setcolor(LIGHTCYAN)
    for x, text in zip(COLUMNS, ("getch()", "again", "hexadecimal", "key"), strict=True):
        outtextxy(x, 48, text)
    line(16, 62, 623, 62, CYAN)


def row(place: int, codes: Sequence[int]) -> None:
    """One key, in one of the rows; the row below it is cleared, as a mark."""
    y = TOP + ROW * place
    setfillstyle(SOLID_FILL, 0)
    bar(0, y - 4, 639, y + 2 * ROW - 5)
    texts = [str(code) for code in codes] + [""] * (2 - len(codes))
    texts += [" ".join(f"{code:02X}" for code in codes), name(codes)]
    for x, text, color in zip(COLUMNS, texts, (YELLOW, YELLOW, DARKGRAY, LIGHTGRAY), strict=True):
        setcolor(color)
        outtextxy(x, y, text)


def draw() -> None:
    """Some keys of each kind."""
    head()
    some = [[13], [27], [32], [97], [65], [1], [127], [129]]
    some += [[0, code] for code in (59, 72, 80, 75, 77, 71, 83, 15, 84, 94, 115, 16, 120)]
    for place, codes in enumerate(some):
        row(place, codes)


def main() -> None:
    """Show keys, row after row, until Esc comes."""
    initgraph(*MODE)
    head()
    place, codes = 0, [0]
    while codes != [ESC]:
        codes = [getch()]
        if codes == [0]:
            codes.append(getch())
        row(place, codes)
        place = (place + 1) % ROWS


if __name__ == "__main__":
    main()
