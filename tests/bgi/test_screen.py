"""The screen: its mode, viewport and pages. (Colours: test_palette.)"""

import sys
import threading

import numpy as np

import bgi
from bgi import current
from bgi.kernel.state import KERNEL
from bgi.settings import viewporttype


def test_queries_of_the_mode():
    bgi.initgraph()
    assert bgi.getdrivername() == "EGAVGA"
    assert (bgi.getgraphmode(), bgi.getmaxmode()) == (2, 2)
    assert [bgi.getmodename(n) for n in (-1, 0, 1, 2, 3)] == [
        None,
        "640 x 200 EGA",
        "640 x 350 EGA",
        "640 x 480 VGA",
        None,
    ]
    bgi.restorecrtmode()
    assert bgi.getgraphmode() == 2
    bgi.setgraphmode(bgi.getgraphmode())


def test_setviewport_refuses(vga):
    vga.setviewport(10, 10, 20, 20, 1)
    for corners in [(-1, 0, 5, 5), (0, 0, 640, 5), (5, 0, 4, 5), (0, 9, 5, 8), (0, 0, 5, 480)]:
        vga.setviewport(*corners, 1)
        assert KERNEL.result.take() == -11
    vga.putpixel(0, 0, 3)
    assert vga.page.get(10, 10) == 3


def test_pages():
    bgi.initgraph()
    card = current.screen.card
    bgi.putpixel(3, 3, 4)
    bgi.swapbuffers()
    assert card.visible == 0
    assert bgi.getpixel(3, 3) == 0
    bgi.putpixel(3, 3, 9)
    bgi.swapbuffers()
    assert card.visible == 1
    assert bgi.getpixel(3, 3) == 4
    bgi.setvisualpage(0)
    assert card.visible == 0
    bgi.setactivepage(1)
    assert bgi.getpixel(3, 3) == 9
    for unknown in (-1, 2, 10**20):
        bgi.setactivepage(unknown)
        bgi.setvisualpage(unknown)
    assert (card.visible, bgi.getpixel(3, 3)) == (0, 9)


def test_the_viewport_holds_on_every_page():
    bgi.initgraph()
    bgi.setviewport(10, 10, 20, 20, 1)
    bgi.setactivepage(1)
    bgi.bar(-100, -100, 100, 100)
    assert current.screen.page.array.sum() == 11 * 11 * 15


def test_graphdefaults_keeps_the_picture():
    bgi.initgraph()
    bgi.setcolor(3)
    bgi.setpalette(1, 20)
    bgi.setviewport(5, 5, 50, 50, 1)
    bgi.putpixel(0, 0, 7)
    bgi.graphdefaults()
    assert (bgi.getcolor(), bgi.getpixel(5, 5), bgi.getpalette().colors[1]) == (15, 7, 1)


def test_the_viewport_and_the_current_position(vga):
    assert vga.getviewsettings() == viewporttype(0, 0, 639, 479, 1)
    vga.bar(0, 0, 639, 479)
    vga.moveto(7, 8)
    vga.setviewport(10, 20, 30, 40, 0)
    assert vga.getviewsettings() == viewporttype(10, 20, 30, 40, 0)
    assert (vga.getx(), vga.gety()) == (0, 0)
    vga.moveto(7, 8)
    vga.clearviewport()
    assert (vga.getx(), vga.gety()) == (0, 0)
    assert not vga.page.array[20:41, 10:31].any()
    assert (vga.page.array == 15).sum() == 640 * 480 - 21 * 21


def test_a_mode_that_changes_leaves_calls_of_other_threads_whole():
    """A call ends on the screen that it began on; the next one finds the new mode."""
    modes = [(bgi.CGA, 0), (bgi.VGA, bgi.VGAHI), (bgi.IBM8514, bgi.IBM8514HI), (bgi.HERCMONO, 0)]
    points, corners = np.arange(1100), np.array([(0, 0), (1000, 20), (30, 700)])
    errors = []
    over = threading.Event()

    def draw():
        try:
            while not over.is_set():
                bgi.putpixel(points, points, points)
                bgi.line(0, 700, 1000, 0)
                bgi.circle(300, 200, 190)
                bgi.fillpoly(corners)
                bgi.putimage(900, 600, bgi.getimage(0, 0, 99, 99), bgi.COPY_PUT)
                bgi.floodfill(5, 5, 15)
        except Exception as error:
            errors.append(error)

    bgi.initgraph()
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    threads = [threading.Thread(target=draw) for _ in range(3)]
    try:
        for thread in threads:
            thread.start()
        for driver, mode in modes * 50:
            bgi.initgraph(driver, mode)
    finally:
        over.set()
        for thread in threads:
            thread.join()
        sys.setswitchinterval(interval)
    assert errors == []
