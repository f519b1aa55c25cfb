"""The ten stroked fonts and the built-in one: sizes, directions, justification.

    python demos/06_fonts.py

What it shows: settextstyle() chooses a font, settextjustify() the point of the text that is put
on x, y, and setusercharsize() stretches strokes freely. Letters of stroked fonts are lines: they
stay sharp at any size. textwidth() and textheight() measure before anything is drawn. The last
pages are tables of every character.
"""

from functools import partial

from bgi import *
from gallery.pages import Page, leaf_through, show

MODE = (VGA, VGAHI)
BOTTOM = 455  # the last row below the bar
FONTS = (
    (DEFAULT_FONT, "DEFAULT_FONT"),
    (TRIPLEX_FONT, "TRIPLEX_FONT"),
    (SMALL_FONT, "SMALL_FONT"),
    (SANS_SERIF_FONT, "SANS_SERIF_FONT"),
    (GOTHIC_FONT, "GOTHIC_FONT"),
    (SCRIPT_FONT, "SCRIPT_FONT"),
    (SIMPLEX_FONT, "SIMPLEX_FONT"),
    (TRIPLEX_SCR_FONT, "TRIPLEX_SCR_FONT"),
    (COMPLEX_FONT, "COMPLEX_FONT"),
    (EUROPEAN_FONT, "EUROPEAN_FONT"),
    (BOLD_FONT, "BOLD_FONT"),
)
COLORS = (WHITE, YELLOW, LIGHTCYAN, LIGHTGREEN, LIGHTRED, LIGHTMAGENTA)
ACROSS = ((LEFT_TEXT, "LEFT"), (CENTER_TEXT, "CENTER"), (RIGHT_TEXT, "RIGHT"))
DOWN = ((BOTTOM_TEXT, "BOTTOM"), (CENTER_TEXT, "CENTER"), (TOP_TEXT, "TOP"))


def label(x: int, y: int, text: str, color: int = LIGHTGRAY) -> None:
    """A caption in the built-in font, its upper left corner at x, y."""
    settextstyle(DEFAULT_FONT, HORIZ_DIR, 1)
    settextjustify(LEFT_TEXT, TOP_TEXT)
    setcolor(color)
    outtextxy(x, y, text)


def fit_height(font: int, height: int) -> None:
    """Choose a font and stretch it, alike in both directions, to a height in pixels."""
    settextstyle(font, HORIZ_DIR, 4)
    own = textheight("H")
    setusercharsize(height, own, height, own)


def overview() -> None:
    """A line of each font, all of the same height, and its number."""
    for row, (font, name) in enumerate(FONTS):
        y = 12 + 40 * row
        label(16, y + 14, f"{font:2}  {name}")
        setcolor(COLORS[row % len(COLORS)])
        if font == DEFAULT_FONT:
            settextstyle(font, HORIZ_DIR, 2)
            outtextxy(190, y + 12, "Turbo C graphics.h 1987")
        else:
            fit_height(font, 28)
            outtextxy(190, y, "Turbo C graphics.h 1987")
        setcolor(DARKGRAY)
        line(16, y + 38, getmaxx() - 16, y + 38)


def sizes() -> None:
    """The built-in font grows by whole steps, strokes by Borland's ten ratios."""
    rows = (
        (DEFAULT_FONT, "A", 78, LIGHTCYAN),
        (TRIPLEX_FONT, "R", 84, YELLOW),
        (GOTHIC_FONT, "G", 84, LIGHTRED),
        (SCRIPT_FONT, "S", 84, LIGHTMAGENTA),
    )
    base = 14
    for font, letter, height, color in rows:
        base += height + 22
        label(16, base + 8, f"{FONTS[font][1]}, size 1 to 10", DARKGRAY)
        x = 16
        for size in range(1, 11):
            settextstyle(font, HORIZ_DIR, size)
            settextjustify(LEFT_TEXT, BOTTOM_TEXT)
            setcolor(color)
            outtextxy(x, base, letter)
            x += textwidth(letter) + 16


def directions() -> None:
    """Level and upwards: a chart is where one needs both."""
    label(16, 10, "HORIZ_DIR reads to the right, VERT_DIR upwards.")
    setcolor(DARKGRAY)
    for y in range(48, 369, 40):
        line(84, y, 620, y)
    columns = (
        ("points", 290, LIGHTRED),
        ("lines", 150, YELLOW),
        ("circles", 210, LIGHTGREEN),
        ("polygons", 255, LIGHTMAGENTA),
        ("images", 120, LIGHTCYAN),
    )
    for place, (name, height, color) in enumerate(columns):
        left = 110 + 102 * place
        setcolor(color)
        setfillstyle(SOLID_FILL, BLACK)
        bar3d(left, 368 - height, left + 60, 368, 16, 1)
        settextjustify(CENTER_TEXT, CENTER_TEXT)
        settextstyle(TRIPLEX_FONT, VERT_DIR, 4)
        outtextxy(left + 26, 368 - height // 2, name)
        settextstyle(SMALL_FONT, HORIZ_DIR, 5)
        outtextxy(left + 30, 380, str(height))
    setcolor(WHITE)
    settextstyle(SANS_SERIF_FONT, VERT_DIR, 4)
    outtextxy(40, 208, "drawn in a second")
    settextstyle(SANS_SERIF_FONT, HORIZ_DIR, 4)
    outtextxy(352, 414, "what is drawn")


def justification() -> None:
    """Every combination; the cross is the point given to outtextxy."""
    label(16, 10, "The crosses are the points given to outtextxy().")
    for row, (down, below) in enumerate(DOWN):
        for column, (across, beside) in enumerate(ACROSS):
            x, y = 110 + 210 * column, 110 + 130 * row
            label(x - 60, y + 48, f"{beside}, {below}", DARKGRAY)
            setcolor(LIGHTRED)
            line(x - 10, y, x + 10, y)
            line(x, y - 10, x, y + 10)
            settextstyle(COMPLEX_FONT, HORIZ_DIR, 4)
            settextjustify(across, down)
            setcolor(YELLOW)
            outtextxy(x, y, "Typo")


def stretched() -> None:
    """setusercharsize: width and height apart from each other."""
    label(16, 10, "setusercharsize(multx, divx, multy, divy)")
    settextstyle(TRIPLEX_FONT, HORIZ_DIR, USER_CHAR_SIZE)
    for row, (mult, div) in enumerate(((1, 3), (2, 3), (1, 1), (2, 1), (3, 1))):
        y = 28 + 40 * row
        label(16, y + 14, f"{mult}, {div}, 1, 1", DARKGRAY)
        settextstyle(TRIPLEX_FONT, HORIZ_DIR, USER_CHAR_SIZE)
        setusercharsize(mult, div, 1, 1)
        setcolor(LIGHTCYAN)
        outtextxy(130, y, "Stretch")
    left, top, right, bottom = 16, 252, getmaxx() - 16, 440
    setcolor(LIGHTBLUE)
    rectangle(left, top, right, bottom)
    label(left + 8, top + 8, "as wide and as high as its box: measured, then stretched")
    settextstyle(TRIPLEX_FONT, HORIZ_DIR, 4)
    words = "Fits in the box"
    setusercharsize(right - left - 32, textwidth(words), bottom - top - 24, textheight(words))
    setcolor(YELLOW)
    outtextxy(left + 16, top + 8, words)


def table(font: int, first: int) -> None:
    """The characters of a font from code `first` on, in rows of sixteen."""
    lines = (256 - first) // 16
    height = 436 // lines
    for row in range(lines):
        y = 8 + height * row
        code = first + 16 * row
        label(12, y + 12, f"{code:3}", DARKGRAY)
        if font == DEFAULT_FONT:
            settextstyle(font, HORIZ_DIR, 2)
            y = y + 5
        else:
            fit_height(font, 27)
        settextjustify(CENTER_TEXT, TOP_TEXT)
        setcolor(YELLOW if code < 128 else LIGHTCYAN)  # beyond ASCII: code page 437
        for column in range(16):
            outtextxy(70 + 36 * column, y, bytes([code + column]))
    setcolor(CYAN)
    line(42, 8, 42, BOTTOM - 12)


PAGES = (
    Page("The fonts", overview),
    Page("Sizes", sizes),
    Page("Directions", directions),
    Page("Justification", justification),
    Page("Widths and heights of one's own", stretched),
    Page("DEFAULT_FONT", partial(table, DEFAULT_FONT, 0)),
    *(Page(name, partial(table, font, 32)) for font, name in FONTS[1:]),
)


def draw() -> None:
    """The first page."""
    show(PAGES)


def main() -> None:
    """Leaf through the pages until Esc comes."""
    leaf_through(PAGES)


if __name__ == "__main__":
    main()
