"""Palette and colours: indices stay, looks change."""

import pytest

import bgi
from bgi import current


def look(index):
    """What a colour index looks like: (r, g, b)."""
    return tuple(current.screen.card.palette[index].tolist())


@pytest.fixture(autouse=True)
def _vga():
    bgi.initgraph()


def test_default_palette():
    assert bgi.getpalette().size == 16
    assert bgi.getpalette().colors == [0, 1, 2, 3, 4, 5, 20, 7, *range(56, 64)]
    assert look(bgi.BROWN) == (0xAA, 0x55, 0)
    assert look(bgi.DARKGRAY) == (0x55, 0x55, 0x55)
    assert look(bgi.LIGHTCYAN) == (0x55, 0xFF, 0xFF)


@pytest.mark.parametrize(
    "driver, mode, size, first",
    [
        (bgi.VGA, bgi.VGAHI, 16, [0, 1, 2, 3]),
        (bgi.EGA64, bgi.EGA64HI, 4, [0, 1, 4, 7]),
        (bgi.CGA, bgi.CGAC1, 1, [0, 1, 2, 3]),
        (bgi.IBM8514, bgi.IBM8514HI, 256, [0, 1, 2, 3]),
    ],
)
def test_sizes_of_palettes(driver, mode, size, first):
    bgi.initgraph(driver, mode)
    assert bgi.getpalettesize() == size
    assert bgi.getpalette().size == max(size, 4 if driver == bgi.EGA64 else 16)
    bgi.setpalette(0, 5)
    assert bgi.getdefaultpalette().colors[:4] == first


def test_ega_values():
    """The check values of the hardware: bits r g b R G B."""
    for value, rgb in {20: 0xAA5500, 38: 0xFFAA00, 9: 0x0000FF, 56: 0x555555}.items():
        bgi.setpalette(3, value)
        assert look(3) == (rgb >> 16, rgb >> 8 & 255, rgb & 255)


def test_200_line_modes_show_the_same_colours():
    rgb = [look(i) for i in range(16)]
    bgi.setgraphmode(bgi.VGALO)
    assert bgi.getpalette().colors == [*range(8), *range(16, 24)]
    assert [look(i) for i in range(16)] == rgb


def test_setbkcolor_recolours_and_redraws_nothing():
    bgi.putpixel(1, 1, 4)
    bgi.setbkcolor(bgi.BLUE)
    assert look(0) == (0, 0, 0xAA)
    assert (bgi.getpixel(0, 0), bgi.getpixel(1, 1), bgi.getbkcolor()) == (0, 4, 1)
    bgi.cleardevice()
    assert bgi.getpixel(1, 1) == 0
    bgi.setbkcolor(0)
    assert look(0) == (0, 0, 0)


def test_setpalette_never_complains():
    before = bgi.getpalette()
    for index, color in [(16, 1), (-1, 1), (1, -1), (10**30, 1)]:
        bgi.setpalette(index, color)
    assert bgi.getpalette() == before
    bgi.setpalette(2, 256 + 64 + 4)  # the low byte is kept, six bits of it are shown
    assert (bgi.getpalette().colors[2], look(2)) == (68, (0xAA, 0, 0))
    assert bgi.graphresult() == 0


def test_setallpalette():
    bgi.setallpalette([-1, 20, -1, 63])
    assert bgi.getpalette().colors[:5] == [0, 20, 2, 63, 4]
    saved = bgi.getpalette()
    bgi.setpalette(1, 5)
    bgi.setallpalette(saved)
    assert bgi.getpalette() == saved
    bgi.setallpalette([7] * 17)
    assert bgi.getpalette().colors == [7] * 16
    assert bgi.graphresult() == 0


def test_setallpalette_takes_the_struct_as_c_lays_it_out():
    bgi.setallpalette([16, *range(40, 56)])
    assert bgi.getpalette().colors == list(range(40, 56))
    bgi.setallpalette([1, 2])  # two colours
    assert bgi.getpalette().colors[:3] == [1, 2, 42]


def test_setrgbpalette_loads_registers_not_colours():
    bgi.setrgbpalette(8, 63, 0, 0)
    assert look(8) == (0x55, 0x55, 0x55)
    bgi.setrgbpalette(56, 63, 0, 0)
    assert look(8) == (255, 0, 0)
    assert bgi.getpalette().colors[8] == 56
    bgi.setrgbpalette(20, 21, 42, 64 + 63)
    assert look(6) == (0x55, 0xAA, 0xFF)
    bgi.setrgbpalette(256 + 20, 63, 63, 63)
    assert look(6) == (255, 255, 255)
    assert bgi.graphresult() == 0


def test_setrgbpalette_takes_arrays():
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
    bgi.setrgbpalette(range(100, 103), [0, 252, 4], 0, 128)
    assert [look(i) for i in (100, 101, 102)] == [(0, 0, 130), (255, 0, 130), (4, 0, 130)]


def test_no_dac_on_the_ega():
    bgi.initgraph(bgi.EGA, bgi.EGAHI)
    bgi.setrgbpalette(1, 63, 63, 63)
    assert bgi.graphresult() == bgi.grError
    assert look(1) == (0, 0, 0xAA)


def test_cga():
    bgi.initgraph(bgi.CGA, bgi.CGAC0)
    assert [look(i) for i in (1, 2, 3)] == [(85, 255, 85), (255, 85, 85), (255, 255, 85)]
    assert bgi.getpalette().colors == list(range(16))
    bgi.setbkcolor(bgi.BLUE)
    assert look(0) == (0, 0, 0xAA)
    bgi.setpalette(0, bgi.RED)
    assert look(0) == (0xAA, 0, 0)
    bgi.setpalette(1, 5)
    assert (bgi.getpalette().colors[:2], look(1)) == ([bgi.RED, 5], (85, 255, 85))
    assert bgi.graphresult() == 0


def test_cga_in_two_colours_colours_the_foreground():
    bgi.initgraph(bgi.CGA, bgi.CGAHI)
    assert look(1) == (255, 255, 255)
    bgi.setbkcolor(bgi.GREEN)
    assert (look(0), look(1)) == ((0, 0, 0), (0, 0xAA, 0))
    bgi.setbkcolor(0)
    assert look(1) == (0, 0xAA, 0)


def test_ibm8514():
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
    assert bgi.getpalette().size == 256
    assert (bgi.getcolor(), look(255)) == (255, (255, 255, 255))
    assert [look(i) for i in (1, 6, 15)] == [(0, 0, 170), (170, 85, 0), (255, 255, 255)]
    assert (look(16), look(31), look(32), look(40)) == (
        (0, 0, 0),
        (255, 255, 255),
        (0, 0, 255),
        (255, 0, 0),
    )
    bgi.setrgbpalette(200, 252, 128, 4)
    assert look(200) == (255, 130, 4)
    bgi.setpalette(1, 2)
    assert bgi.graphresult() == bgi.grError
    bgi.setbkcolor(200)
    assert look(0) == look(200)
    bgi.graphdefaults()
    assert look(0) == (0, 0, 0)


def test_setcolor_keeps_the_low_byte_and_draws_in_the_low_bits():
    for color, kept in [(15, 15), (16, 16), (31, 31), (-1, 255), (2**40 + 3, 3)]:
        bgi.setcolor(color)
        bgi.line(0, 0, 3, 0)
        bgi.circle(50, 50, 9)
        assert bgi.getcolor() == kept
        assert bgi.getpixel(0, 0) == bgi.getpixel(59, 50) == kept & 15


def test_setbkcolor_ignores_what_is_no_colour():
    bgi.setbkcolor(4)
    for color in (-1, 16, 255, 10**20):
        bgi.setbkcolor(color)
    assert (bgi.getbkcolor(), bgi.getpalette().colors[0]) == (4, 4)
