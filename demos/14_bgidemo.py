"""A tour of graphics.h, in the spirit of the one that came with the compiler.

    python demos/14_bgidemo.py

What it shows: a page for each thing that the library can do, from the list of its settings to
charts, curves, text in every font, XOR, images, palettes and the modes of other adapters. Each page
is one short function: read the one whose picture you want to draw.
"""

from dataclasses import astuple
from math import cos, radians, sin
from random import Random

import numpy as np
from numpy.typing import NDArray

from bgi import *
from gallery.pages import Page, leaf_through, show

MODE = (VGA, VGAHI)
HUES = (LIGHTRED, YELLOW, LIGHTGREEN, LIGHTCYAN, LIGHTBLUE, LIGHTMAGENTA)
CROP = (("apples", 34), ("pears", 22), ("plums", 15), ("cherries", 18), ("quinces", 11))
# A font, the size that suits it, and a word of it.
WORDS = (
    (DEFAULT_FONT, 2, "8 x 8"),
    (TRIPLEX_FONT, 4, "Triplex"),
    (SMALL_FONT, 8, "Small"),
    (SANS_SERIF_FONT, 4, "Sans serif"),
    (GOTHIC_FONT, 4, "Gothic"),
    (SCRIPT_FONT, 4, "Script"),
    (SIMPLEX_FONT, 4, "Simplex"),
    (TRIPLEX_SCR_FONT, 4, "Triplex script"),
    (COMPLEX_FONT, 4, "Complex"),
    (EUROPEAN_FONT, 2, "European"),
    (BOLD_FONT, 2, "Bold"),
)
chance = Random(1987)


def hue(number: int) -> int:
    """The six hues in turn."""
    return HUES[number % len(HUES)]


def write(x: int, y: int, text: str, color: int = LIGHTGRAY) -> None:
    """A text in a colour, in the font and justification in use."""
    setcolor(color)
    outtextxy(x, y, text)


def heading(text: str, y: int = 34) -> None:
    """A line in triplex letters, centred."""
    settextstyle(TRIPLEX_FONT, HORIZ_DIR, 4)
    settextjustify(CENTER_TEXT, CENTER_TEXT)
    write(getmaxx() // 2, y, text, WHITE)
    settextstyle(DEFAULT_FONT, HORIZ_DIR, 1)
    settextjustify(LEFT_TEXT, TOP_TEXT)


# Opening


def welcome() -> None:
    """A title, wreathed by ellipses."""
    for ring in range(24):
        setcolor(hue(ring // 4))
        ellipse(319, 227, 0, 360, 310 - 6 * ring, 90 + 5 * ring)
    settextjustify(CENTER_TEXT, CENTER_TEXT)
    settextstyle(BOLD_FONT, HORIZ_DIR, USER_CHAR_SIZE)
    setusercharsize(3, 2, 3, 2)
    for shift in range(5, -1, -1):
        write(319 + shift, 196 + shift, "graphics", YELLOW if shift == 0 else BLUE)
    settextstyle(TRIPLEX_SCR_FONT, HORIZ_DIR, 4)
    write(319, 284, "a tour", WHITE)


def status() -> None:
    """Everything that can be asked."""
    driver, mode = getdrivername(), getmodename(getgraphmode())
    rows = (
        ("getdrivername, getmodename", f"{driver}, {mode}"),
        ("getmoderange", str(getmoderange(CURRENT_DRIVER))),
        ("getmaxx, getmaxy, getmaxcolor", f"{getmaxx()}, {getmaxy()}, {getmaxcolor()}"),
        ("getaspectratio", str(getaspectratio())),
        ("getviewsettings", str(astuple(getviewsettings()))),
        ("getx, gety", f"{getx()}, {gety()}"),
        ("getcolor, getbkcolor", f"{getcolor()}, {getbkcolor()}"),
        ("getlinesettings", str(astuple(getlinesettings()))),
        ("getfillsettings", str(astuple(getfillsettings()))),
        ("getfillpattern", getfillpattern().hex(" ")),
        ("gettextsettings", str(astuple(gettextsettings()))),
        ("getpalettesize", str(getpalettesize())),
        ("getpalette().colors", " ".join(map(str, getpalette().colors))),
        ("imagesize(0, 0, 99, 99)", str(imagesize(0, 0, 99, 99))),
        ("graphresult", f"{graphresult()}: {grapherrormsg(grOk)}"),
    )
    heading("What can be asked")
    for row, (call, answer) in enumerate(rows):
        write(24, 76 + 24 * row, call, LIGHTCYAN)
        write(280, 76 + 24 * row, answer, YELLOW)


# Points and lines


def galaxy() -> None:
    """Six thousand stars in two arms, one call: where a number goes, an array goes too."""
    heading("putpixel with arrays")
    random = np.random.default_rng(1987)
    along = random.random(6000)
    turn = 7 * along + np.pi * random.integers(0, 2, 6000) + random.normal(0, 0.3, 6000)
    reach = 20 + 270 * along + random.normal(0, 8, 6000)
    x, y = 320 + reach * np.cos(turn), 262 + 0.62 * reach * np.sin(turn)
    hot = np.array((WHITE, YELLOW, LIGHTRED, LIGHTMAGENTA, LIGHTBLUE, BLUE))
    putpixel(x, y, hot[np.int64(along * 6)])


def twinkle() -> None:
    """Give stars another colour: what is dark stays dark."""
    for _ in range(2000):
        x, y = chance.randrange(640), chance.randrange(70, 456)
        color = getpixel(x, y)
        if color != BLACK:
            putpixel(x, y, DARKGRAY + (color + 1) % 8)


def styles() -> None:
    """The five line styles in both widths, and patterns of sixteen bits."""
    heading("setlinestyle")
    names = ("SOLID_LINE", "DOTTED_LINE", "CENTER_LINE", "DASHED_LINE")
    for style, name in enumerate(names):
        write(40, 86 + 36 * style, name)
        setcolor(HUES[style])
        for row, width in enumerate((NORM_WIDTH, THICK_WIDTH)):
            setlinestyle(style, 0, width)
            line(170, 84 + 36 * style + 12 * row, 600, 84 + 36 * style + 12 * row)
    for row in range(16):
        setlinestyle(USERBIT_LINE, 0xFFFF >> row, NORM_WIDTH)
        line(170, 244 + 12 * row, 600, 244 + 12 * row, hue(row))
        write(40, 241 + 12 * row, f"user, {0xFFFF >> row:04X}", DARKGRAY)


def walk() -> None:
    """A pen that remembers where it is: from the middle outwards, and back by one line."""
    heading("moveto, linerel, lineto")
    moveto(320, 262)
    for step in range(1, 46):
        setcolor(hue(step // 4))
        forth = 1 if step % 2 else -1
        linerel(forth * 13 * step, 0)
        linerel(0, forth * 8 * step)
    setcolor(WHITE)
    lineto(320, 262)


# Curves


def arcs() -> None:
    """Quarter by quarter, growing; getarccoords() tells where each ends."""
    heading("arc, ellipse, getarccoords")
    for step in range(60):
        setcolor(hue(step // 4))
        ellipse(320, 262, 90 * step, 90 * step + 90, 20 + 4 * step, 14 + 3 * step)
        ends = getarccoords()
        fillellipse(ends.xend, ends.yend, 2, 2)


def circles() -> None:
    """An empty page; its circles come one after the other."""
    heading("circle")


def another_circle() -> None:
    """Random in every way."""
    setlinestyle(SOLID_LINE, 0, chance.choice((NORM_WIDTH, THICK_WIDTH)))
    setcolor(chance.randrange(BLUE, WHITE + 1))
    circle(chance.randrange(640), chance.randrange(70, 456), chance.randrange(5, 60))


def ratios() -> None:
    """setaspectratio: the same radius, flatter and flatter."""
    heading("setaspectratio")
    xasp, yasp = getaspectratio()
    for step in range(20):
        setaspectratio(xasp * (20 - step) // 20, yasp)
        circle(320, 262, 180, hue(step))
    setaspectratio(xasp, yasp)


# Charts


def bars() -> None:
    """bar3d, leaning back."""
    heading("bar3d")
    settextjustify(CENTER_TEXT, TOP_TEXT)
    for height in range(0, 41, 10):
        y = 400 - 8 * height
        line(60, y, 600, y, DARKGRAY)
        write(40, y - 4, str(height))
    for place, (name, share) in enumerate(CROP):
        left = 90 + 104 * place
        setfillstyle(place + SLASH_FILL, HUES[place])
        setcolor(WHITE)
        bar3d(left, 400 - 8 * share, left + 56, 400, 20, 1)
        write(left + 28, 412, name)


def pie() -> None:
    """Slices to scale, their names beside the middle of their arcs."""
    heading("sector, getarccoords")
    settextstyle(SANS_SERIF_FONT, HORIZ_DIR, 2)
    start = 0
    for place, (name, share) in enumerate(CROP):
        end = start + share * 360 // 100
        setcolor(BLACK)  # the arc's middle, where no one sees it
        arc(320, 256, start, (start + end) // 2, 178)
        middle = getarccoords()
        setcolor(WHITE)
        setfillstyle(place + SLASH_FILL, HUES[place])
        sector(320, 256, start, 360 if place == len(CROP) - 1 else end, 150, 150)
        settextjustify(LEFT_TEXT if middle.xend > 320 else RIGHT_TEXT, CENTER_TEXT)
        write(middle.xend, middle.yend, f"{name} {share}%", HUES[place])
        start = end


# Areas


def patterns() -> None:
    """The twelve fill patterns, side by side."""
    heading("setfillstyle")
    for pattern in range(USER_FILL):
        left, top = 46 + 140 * (pattern % 4), 80 + 122 * (pattern // 4)
        setfillstyle(pattern, hue(pattern))
        bar(left, top, left + 124, top + 100)
        rectangle(left, top, left + 124, top + 100)


def fan() -> None:
    """Polygons that turn about a point, in one call."""
    heading("fillpoly with arrays")
    turn = np.radians(np.arange(0, 360, 20))[:, None] + np.array((0, 0.42, 0.1, -0.12))
    reach = np.array((30, 190, 130, 190))
    points = np.stack((320 + reach * np.cos(turn), 262 - reach * np.sin(turn)), axis=2)
    fillpoly(points, fill=np.array(HUES)[np.arange(18) % 6], color=BLUE)


def flood() -> None:
    """Circles that cross, and what is poured into the cells between them."""
    heading("floodfill")
    setcolor(WHITE)
    circle(320, 262, 189)
    for degrees in range(0, 360, 60):
        circle(*polar(degrees, 95), 95)
    for place in range(6):
        cells = (
            (60 * place, 50, SOLID_FILL),
            (60 * place, 140, CLOSE_DOT_FILL),
            (60 * place + 30, 110, HATCH_FILL),
            (60 * place + 30, 178, LINE_FILL),
        )
        for number, (degrees, reach, pattern) in enumerate(cells):
            setfillstyle(pattern, hue(place + number))
            floodfill(*polar(degrees, reach), WHITE)


def polar(degrees: float, reach: float) -> tuple[float, float]:
    """The point in that direction from the page's middle, and that far away."""
    return 320 + reach * cos(radians(degrees)), 262 - reach * sin(radians(degrees))


# Text


def fonts() -> None:
    """A word of each font."""
    heading("settextstyle")
    settextjustify(LEFT_TEXT, CENTER_TEXT)
    for font, size, word in WORDS:
        settextstyle(font, HORIZ_DIR, size)
        write(60 + 290 * (font % 2), 96 + 64 * (font // 2), word, hue(font))


# Screen


def viewports() -> None:
    """Nine windows on the same figure, each cutting off what leaves it."""
    heading("setviewport")
    for place in range(9):
        left, top = 20 + 204 * (place % 3), 94 + 128 * (place // 3)
        rectangle(left - 1, top - 25, left + 192, top + 92, DARKGRAY)
        setviewport(left, top, left + 191, top + 115, 1)
        for radius in range(8, 200, 8):
            circle(96 * (place % 3), 58 * (place // 3), radius, hue(place))
        setviewport(0, 24, getmaxx(), getmaxy(), 1)


class Searchlight:
    """A box that goes about on a web of lines, both in XOR mode."""

    turn = 0.0

    def draw(self) -> None:
        """The web, and the box at its first place."""
        heading("setwritemode(XOR_PUT)")
        setwritemode(XOR_PUT)
        for degrees in range(0, 360, 3):
            line(320, 262, *polar(degrees, 190), LIGHTCYAN)
        self.box()

    def box(self) -> None:
        """Drawn, or taken away: that is the same call."""
        setlinestyle(SOLID_LINE, 0, THICK_WIDTH)
        x, y = 320 + 150 * cos(self.turn), 262 + 90 * sin(2 * self.turn)
        rectangle(x - 90, y - 60, x + 90, y + 60, LIGHTRED)

    def move(self) -> None:
        """Away, and there again a little farther."""
        self.box()
        self.turn += 0.02
        self.box()


def kaleidoscope() -> None:
    """A corner of the screen, and the same in three mirrors."""
    heading("getimage, putimage")
    for _ in range(60):
        another_splinter()


def another_splinter() -> None:
    """A triangle more: images are arrays, and arrays can be turned around."""
    setviewport(100, 104, 319, 289, 1)
    x, y = chance.randrange(220), chance.randrange(186)
    corners = [(x + chance.randrange(-40, 40), y + chance.randrange(-40, 40)) for _ in range(3)]
    fillpoly(corners, fill=chance.choice(HUES), color=BLACK)
    image = getimage(0, 0, 219, 185)
    put_array(220, 0, image.array[:, ::-1])
    put_array(0, 186, image.array[::-1, :])
    put_array(220, 186, image.array[::-1, ::-1])


def put_array(x: int, y: int, pixels: NDArray[np.uint8]) -> None:
    """Rows of pixels as an image."""
    putimage(x, y, Image(pixels), COPY_PUT)


# Colours and modes


def swatches() -> None:
    """Fifteen beams; their looks will change, their pixels will not."""
    heading("setpalette, getpalette")
    for color in range(1, 16):
        beam = [(320, 440)]
        for angle in (radians(12 * color - 12), radians(12 * color)):
            beam.append((round(320 + 300 * cos(angle)), round(440 - 340 * sin(angle))))
        fillpoly(beam, fill=color, color=color)


def another_look() -> None:
    """A colour takes one of the 64 that the EGA could mix; the bar's and the text's stay."""
    color = chance.choice((1, 2, 3, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14))
    setpalette(color, chance.randrange(64))


def mode_page() -> None:
    """What a mode can do: its name, its colours, and a circle that is round on its glass."""
    colors = min(getmaxcolor() + 1, 256)
    view = getviewsettings()
    width, height = view.right - view.left + 1, view.bottom - view.top + 1
    for color in range(colors):
        setfillstyle(SOLID_FILL, color)
        left, right = width * color // colors, width * (color + 1) // colors
        bar(left, height * 2 // 3, right - 1, height)
    setlinestyle(SOLID_LINE, 0, THICK_WIDTH)
    circle(width * 3 // 4, height // 3, height // 4 * 10000 // getaspectratio()[0])
    settextjustify(CENTER_TEXT, CENTER_TEXT)
    outtextxy(width // 3, height // 3 - 6, getmodename(getgraphmode()) or "")
    outtextxy(width // 3, height // 3 + 6, f"{colors} colours")


def farewell() -> None:
    """The last page."""
    settextjustify(CENTER_TEXT, CENTER_TEXT)
    settextstyle(GOTHIC_FONT, HORIZ_DIR, 8)
    for shift in range(6, -1, -1):
        write(319 + shift, 190 + shift, "That was all", YELLOW if shift == 0 else BLUE)
    settextstyle(SANS_SERIF_FONT, HORIZ_DIR, 3)
    write(319, 290, "Now draw something of your own.", LIGHTCYAN)


def of_mode(title: str, driver: int, mode: int) -> Page:
    """The page of a mode."""
    return Page(title, mode_page, mode=(driver, mode))


LIGHT = Searchlight()
PAGES = (
    Page("Welcome", welcome),
    Page("Status", status),
    Page("Points", galaxy, twinkle, 50),
    Page("Line styles", styles),
    Page("A pen", walk),
    Page("Arcs", arcs),
    Page("Circles", circles, another_circle, 30),
    Page("Aspect ratio", ratios),
    Page("Bar chart", bars),
    Page("Pie chart", pie),
    Page("Fill patterns", patterns),
    Page("Polygons", fan),
    Page("Flood fill", flood),
    Page("Fonts", fonts),
    Page("Viewports", viewports),
    Page("Write modes", LIGHT.draw, LIGHT.move),
    Page("Images", kaleidoscope, another_splinter, 60),
    Page("Palette", swatches, another_look, 80),
    of_mode("CGA mode 0", CGA, CGAC0),
    of_mode("CGA mode 1", CGA, CGAC1),
    of_mode("CGA, 2 colours", CGA, CGAHI),
    of_mode("Hercules", HERCMONO, HERCMONOHI),
    of_mode("EGA", EGA, EGAHI),
    of_mode("8514", IBM8514, IBM8514LO),
    Page("The end", farewell),
)


def draw() -> None:
    """The first page."""
    show(PAGES)


def main() -> None:
    """Leaf through the pages until Esc comes."""
    leaf_through(PAGES)


if __name__ == "__main__":
    main()
