"""WinBGIm's names: windows of any size, colours of any mixture, several at once."""

import numpy as np
import pytest

import bgi
from bgi import current
from bgi.monitor import Headless
from tests.pictures import read_indices


def test_a_window_of_any_size_with_any_colour():
    assert bgi.initwindow(300, 123, "A title") == 0
    assert (bgi.getmaxx(), bgi.getmaxy(), bgi.getmaxcolor()) == (299, 122, 15)
    assert (bgi.getwindowwidth(), bgi.getwindowheight()) == (300, 123)
    assert isinstance(current.screen.monitor, Headless)
    assert current.screen.monitor.title == "A title"
    orange = bgi.COLOR(255, 128, 0)
    assert orange == 0x030080FF
    bgi.setcolor(orange)
    bgi.line(0, 0, 299, 0)
    bgi.setfillstyle(bgi.SOLID_FILL, bgi.COLOR(1, 2, 3))
    bgi.bar(10, 10, 20, 20)
    bgi.fillellipse(100, 60, 30, 20)
    bgi.floodfill(200, 60, orange)
    bgi.setfillstyle(bgi.HATCH_FILL, orange)
    bgi.bar(250, 50, 290, 90)
    bgi.outtextxy(150, 5, "text")
    bgi.circle(60, 60, 15)
    bgi.putpixel([1, 2], 5, [bgi.COLOR(9, 9, 9), bgi.RED])
    assert bgi.getpixel(5, 0) == orange
    assert bgi.getpixel(15, 15) == 0x03030201
    assert bgi.getpixel(45, 60) == orange
    assert bgi.getpixel([1, 2], 5).tolist() == [0x03090909, bgi.RED]
    assert bgi.getpixel(256, 56) == orange
    assert bgi.getpixel(257, 57) == 0


def test_images_and_files_of_a_window(tmp_path):
    bgi.initwindow(100, 80)
    bgi.setbkcolor(bgi.COLOR(0, 0, 200))
    bgi.setfillstyle(1, bgi.COLOR(10, 20, 30))
    bgi.bar(0, 0, 9, 9)
    bgi.putpixel(20, 20, bgi.WHITE)
    image = bgi.getimage(0, 0, 30, 30)
    bgi.putimage(50, 40, image, bgi.COPY_PUT)
    assert bgi.getpixel(55, 45) == bgi.COLOR(10, 20, 30)
    bgi.putimage(50, 40, image, bgi.XOR_PUT)
    assert bgi.getpixel(55, 45) == 0
    bgi.writeimagefile(tmp_path / "w.png")
    bgi.cleardevice()
    bgi.readimagefile(tmp_path / "w.png")
    assert bgi.getpixel(5, 5) == bgi.COLOR(10, 20, 30)
    assert bgi.getpixel(40, 5) == 0x03C80000
    assert bgi.getpixel(20, 20) == 0x03FFFFFF
    bgi.readimagefile(tmp_path / "w.png", 99, 79, 50, 40)
    assert bgi.getpixel(51, 41) == bgi.COLOR(10, 20, 30)
    bgi.initgraph()
    bgi.readimagefile(tmp_path / "w.png", 0, 0, 199, 159)
    assert bgi.getpixel(40, 40) == bgi.WHITE
    assert bgi.getpixel(100, 100) == bgi.BLUE
    assert bgi.getpixel(200, 160) == 0


def test_files_that_are_no_pictures(tmp_path):
    bgi.initgraph()
    (tmp_path / "bad.png").write_bytes(b"\x89PNG\r\n\x1a\nrubbish")
    with pytest.raises(ValueError, match="cannot be read"):
        bgi.readimagefile(tmp_path / "bad.png")
    with pytest.raises(OSError):
        bgi.readimagefile(tmp_path / "missing.png")
    assert not current.screen.page.array.any()


def test_a_saved_screen_reads_back_the_same(tmp_path):
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
    bgi.putpixel(np.arange(640), 0, np.arange(640))
    bgi.writeimagefile(tmp_path / "a.png")
    before = read_indices(tmp_path / "a.png")
    bgi.cleardevice()
    bgi.readimagefile(tmp_path / "a.png")
    palette = current.screen.card.palette
    assert (palette[current.screen.page.array] == palette[before]).all()


def test_colour_macros():
    assert bgi.COLOR(255, 85, 85) == bgi.LIGHTRED
    own = bgi.COLOR(1, 2, 3)
    assert bgi.IS_RGB_COLOR(own)
    assert not bgi.IS_RGB_COLOR(7)
    assert bgi.IS_BGI_COLOR(15)
    assert not bgi.IS_BGI_COLOR(16)
    assert (bgi.RED_VALUE(own), bgi.GREEN_VALUE(own), bgi.BLUE_VALUE(own)) == (1, 2, 3)
    assert bgi.converttorgb(bgi.BROWN) == 0x0055AA


def test_several_windows():
    assert bgi.getcurrentwindow() == bgi.NO_CURRENT_WINDOW
    one, two = bgi.initwindow(100, 100), bgi.initwindow(200, 150)
    assert (one, two, bgi.getcurrentwindow()) == (0, 1, 1)
    bgi.putpixel(1, 1, 5)
    bgi.setcurrentwindow(one)
    assert (bgi.getmaxx(), bgi.getpixel(1, 1)) == (99, 0)
    bgi.setcurrentwindow(77)
    assert bgi.getcurrentwindow() == one
    bgi.closewindow(one)
    with pytest.raises(bgi.BGIError, match="not initialized"):
        bgi.putpixel(1, 1, 1)
    bgi.setcurrentwindow(two)
    assert bgi.getpixel(1, 1) == 5
    assert bgi.initwindow(10, 10) == 0
    bgi.closewindow(99)
    bgi.closegraph()
    assert bgi.getcurrentwindow() == bgi.NO_CURRENT_WINDOW


def test_double_buffering():
    bgi.initwindow(50, 50, dbflag=True)
    assert (bgi.getactivepage(), bgi.getvisualpage()) == (1, 0)
    bgi.swapbuffers()
    assert (bgi.getactivepage(), bgi.getvisualpage()) == (0, 1)


def test_the_largest_window():
    with pytest.raises(ValueError, match=r"1\.\.4096 pixels"):
        bgi.initwindow(4097, 1)


@pytest.mark.parametrize("size", [(0, 5), (5, -1), (5000, 5), ("5", 5), (None, 5)])
def test_impossible_windows(size):
    with pytest.raises((ValueError, TypeError)):
        bgi.initwindow(*size)
    assert bgi.getcurrentwindow() == bgi.NO_CURRENT_WINDOW
