"""check.picture: the screen as it is, against a picture in a file."""

import pytest

import bgi
from bgi.lab import check


def house_and_sun():
    house()
    bgi.circle(300, 300, 20)


def house(x=100, y=100, color=bgi.RED):
    bgi.setfillstyle(bgi.SOLID_FILL, color)
    bgi.bar(x, y, x + 60, y + 40)
    bgi.line(x, y, x + 30, y - 25)
    bgi.line(x + 30, y - 25, x + 60, y)


@pytest.fixture
def file(tmp_path):
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    house()
    bgi.writeimagefile(tmp_path / "house.png")
    bgi.cleardevice()
    return tmp_path / "house.png"


def test_the_same_picture_is_right(file):
    house()
    verdict = check.picture(file)
    assert verdict and str(verdict) == "picture: right"


def test_what_differs_is_counted_and_shown(file):
    house()
    bgi.putpixel(110, 110, 0)
    verdict = check.picture(file)
    assert not verdict and verdict.picture
    assert verdict.reason == "1 of 307,200 pixels are not as in house.png: first 110, 110"


def house_on_blue():
    bgi.setfillstyle(bgi.SOLID_FILL, bgi.BLUE)
    bgi.bar(0, 0, 639, 479)
    house()


def rims():
    bgi.rectangle(100, 100, 160, 140, bgi.RED)
    bgi.line(100, 100, 130, 75)
    bgi.line(130, 75, 160, 100)


def lying():
    bgi.setfillstyle(bgi.SOLID_FILL, bgi.RED)
    bgi.bar(100, 100, 140, 160)
    bgi.line(100, 100, 75, 130)
    bgi.line(75, 130, 100, 160)


def roof_beside():
    house()
    bgi.line(100, 100, 130, 75, bgi.BLACK)
    bgi.line(99, 101, 129, 76)


HINTS = [
    (house_on_blue, "the background has another colour"),
    (rims, "only the rims are there"),
    (lying, "x and y are exchanged"),
    (roof_beside, "only a few pixels are wrong"),
    (lambda: house(101), "it is shifted: -1 in x and +0 in y"),
    (lambda: house(color=bgi.YELLOW), "the forms are right"),
    (lambda: None, "nothing is drawn yet"),
    (lambda: house(103, 98), "it is shifted: -3 in x and +2 in y"),
    (lambda: house(color=bgi.BLUE), "the forms are right"),
    (lambda: bgi.line(100, 100, 130, 75), "something is missing"),
    (house_and_sun, "something more"),
]


@pytest.mark.parametrize(("draw", "hint"), HINTS)
def test_a_hint(file, draw, hint):
    draw()
    assert hint in check.picture(file).hint


def test_a_frame_around_the_screen_is_no_background(tmp_path):
    """The first pixel has its colour: the ground is what most pixels have."""
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    bgi.rectangle(0, 0, 639, 479, bgi.YELLOW)
    bgi.writeimagefile(tmp_path / "frame.png")
    bgi.putpixel(639, 479, bgi.BLACK)
    verdict = check.picture(tmp_path / "frame.png")
    assert "something is missing" in verdict.hint
    assert verdict.picture.array.shape[1] > 600, "the corner is enlarged"


def test_upside_down_and_mirrored(file):
    for flip, hint in ((slice(None, None, -1), "upside down"), (..., "left and right")):
        bgi.cleardevice()
        house()
        page = bgi.getimage(0, 0, 639, 479).array
        turned = page[flip] if flip is not ... else page[:, ::-1]
        bgi.putimage(0, 0, bgi.Image(turned), bgi.COPY_PUT)
        assert hint in check.picture(file).hint


def test_another_size_is_told(file):
    bgi.initgraph(bgi.EGA, bgi.EGAHI)
    verdict = check.picture(file)
    assert verdict.reason == "the screen has 640x350, house.png has 640x480 pixels"


def test_without_a_screen_or_a_file_it_says_so(file, tmp_path):
    with pytest.raises(FileNotFoundError):
        check.picture(tmp_path / "none.png")
    bgi.closegraph()
    with pytest.raises(bgi.BGIError, match="Graphics not initialized"):
        check.picture(file)
