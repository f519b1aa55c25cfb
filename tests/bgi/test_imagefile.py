"""Pictures on disk: each format written and read, and nothing that a file holds does harm."""

import io
import struct
import subprocess
import sys
import zlib

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import bgi
from bgi import current
from bgi.memory import backend, gif, imagefile
from bgi.memory.matching import nearest
from bgi.memory.sdl import FOUND
from tests.pictures import read_indices
from tests.skips import needs_pygame

FORMS = ("png", "bmp", "gif", "jpg") if FOUND else ("png", "bmp", "gif")

PIL = pytest.importorskip("PIL.Image", reason="needs Pillow")


@pytest.fixture(autouse=True)
def screen():
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    return current.screen


def page():
    return current.screen.page.array.copy()


def draw_something():
    bgi.setfillstyle(bgi.SOLID_FILL, bgi.BLUE)
    bgi.bar(10, 10, 99, 49)
    bgi.circle(60, 30, 15)
    return page()


class TestWriting:
    @pytest.mark.parametrize(
        ("name", "form"),
        [("a.png", "PNG"), ("a.PNG", "PNG"), ("a", "PNG"), ("a.bmp", "BMP"), ("a.gif", "GIF")],
    )
    def test_the_name_says_the_format_and_indices_are_kept(self, tmp_path, name, form):
        drawn = draw_something()
        bgi.writeimagefile(tmp_path / name)
        with PIL.open(tmp_path / name) as picture:
            assert picture.format == form
        bgi.cleardevice()
        bgi.readimagefile(tmp_path / name)
        assert (page() == drawn).all()

    @needs_pygame
    @pytest.mark.parametrize("name", ["a.jpg", "a.JPEG"])
    def test_jpeg_keeps_the_look(self, tmp_path, name):
        bgi.setfillstyle(bgi.SOLID_FILL, bgi.GREEN)
        bgi.bar(0, 0, 639, 479)
        bgi.writeimagefile(tmp_path / name)
        with PIL.open(tmp_path / name) as picture:
            assert picture.format == "JPEG"
        bgi.cleardevice()
        bgi.readimagefile(tmp_path / name)
        assert (page() == bgi.GREEN).all()

    @pytest.mark.parametrize("name", ["a.txt", "a.tga", "a.png.exe"])
    def test_other_endings_are_refused(self, tmp_path, name):
        with pytest.raises(ValueError, match=r"written as \.png, \.bmp, \.jpg or \.gif"):
            bgi.writeimagefile(tmp_path / name)
        assert not (tmp_path / name).exists()

    def test_a_window_writes_its_colors(self, tmp_path):
        bgi.initwindow(20, 10)
        bgi.putpixel(3, 4, bgi.COLOR(1, 2, 3))
        for name in ("a.png", "a.bmp", "a.gif"):
            bgi.writeimagefile(tmp_path / name)
            with PIL.open(tmp_path / name) as picture:
                assert picture.convert("RGB").getpixel((3, 4)) == (1, 2, 3)

    def test_corners_in_any_order(self, tmp_path):
        draw_something()
        bgi.writeimagefile(tmp_path / "a.png", 10, 10, 99, 49)
        bgi.writeimagefile(tmp_path / "b.png", 99, 49, 10, 10)
        assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
        assert read_indices(tmp_path / "a.png").shape == (40, 90)

    @pytest.mark.parametrize("call", [bgi.writeimagefile, bgi.readimagefile])
    @pytest.mark.parametrize("name", [0, 3, 236.8, None, ["a.png"]])
    def test_a_number_is_no_file(self, call, name):
        with pytest.raises(TypeError, match="filename must be a str or a path, not"):
            call(name)


class TestReading:
    def test_what_is_transparent_leaves_what_is_there(self, tmp_path):
        picture = PIL.new("RGBA", (40, 40), (255, 0, 0, 0))
        picture.paste((0, 170, 0, 255), (10, 10, 30, 30))
        picture.save(tmp_path / "a.png")
        bgi.setfillstyle(bgi.SOLID_FILL, bgi.BLUE)
        bgi.bar(0, 0, 99, 99)
        bgi.readimagefile(tmp_path / "a.png")
        assert bgi.getpixel([0, 9, 10, 29, 30], 20).tolist() == [1, 1, 2, 2, 1]

    def test_what_is_half_transparent_is_mixed(self, tmp_path):
        PIL.new("RGBA", (1, 1), (255, 255, 255, 128)).save(tmp_path / "a.png")
        bgi.initwindow(10, 10)
        bgi.putpixel(0, 0, bgi.COLOR(0, 100, 0))
        bgi.readimagefile(tmp_path / "a.png")
        assert bgi.getpixel(0, 0) == bgi.COLOR(128, 178, 128)

    @pytest.mark.parametrize("name", ["a.png", "a.gif"])
    def test_a_transparent_index(self, tmp_path, name):
        picture = PIL.fromarray(np.array([[0, 1, 2]], np.uint8), "P")
        picture.putpalette([0, 0, 0, 0, 0, 170, 0, 170, 0])
        picture.save(tmp_path / name, transparency=1)
        bgi.putpixel([0, 1, 2], 0, 15)
        bgi.readimagefile(tmp_path / name)
        assert bgi.getpixel([0, 1, 2], 0).tolist() == [0, 15, 2]

    def test_equal_colors_of_a_palette_keep_their_indices(self, tmp_path):
        for index in (3, 5, 9):
            bgi.setpalette(index, bgi.EGA_RED)
        bgi.putpixel(range(16), 0, range(16))
        bgi.writeimagefile(tmp_path / "a.png")
        before = page()
        bgi.cleardevice()
        bgi.readimagefile(tmp_path / "a.png")
        assert (page() == before).all()

    @needs_pygame
    @pytest.mark.parametrize("orientation", range(1, 9))
    def test_a_turned_photograph_stands_upright(self, tmp_path, orientation):
        picture = PIL.new("RGB", (64, 32))
        picture.paste((0, 170, 0), (0, 0, 16, 16))
        exif = PIL.Exif()
        exif[0x0112] = orientation
        picture.save(tmp_path / "a.jpg", exif=exif)
        upright = np.array(__import__("PIL.ImageOps").ImageOps.exif_transpose(picture_of(tmp_path)))
        bgi.readimagefile(tmp_path / "a.jpg")
        green = page()[: upright.shape[0], : upright.shape[1]] == bgi.GREEN
        assert (green == (upright[..., 1] > 85)).all()

    def test_print_colors_are_refused(self, tmp_path):
        PIL.new("CMYK", (8, 8)).save(tmp_path / "a.jpg")
        with pytest.raises(ValueError, match="CMYK"):
            bgi.readimagefile(tmp_path / "a.jpg")

    def test_stretched_as_the_whole_would_be_and_only_where_it_is_seen(self, tmp_path):
        PIL.fromarray(np.array([[0, 255], [255, 0]], np.uint8)).save(tmp_path / "a.png")
        bgi.readimagefile(tmp_path / "a.png", -(10**9), -(10**9), 10**9 - 1, 10**9 - 1)
        assert (page() == 0).all()  # the lower right quarter
        bgi.readimagefile(tmp_path / "a.png", -(10**9), 0, 10**9 - 1, 479)
        assert (page()[:240] == 15).all() and (page()[240:] == 0).all()

    def test_swapped_corners_and_the_viewport(self, tmp_path):
        PIL.new("L", (4, 4), 255).save(tmp_path / "a.png")
        bgi.setviewport(100, 50, 200, 150, 0)
        bgi.readimagefile(tmp_path / "a.png", 9, 7, 0, 0)
        assert page().sum() == 15 * 80 and page()[50:58, 100:110].all()


def picture_of(folder):
    return PIL.open(folder / "a.jpg")


def test_nearest_is_the_first_of_the_nearest():
    random = np.random.default_rng(3)
    palette = random.integers(0, 256, (16, 3)).astype(np.uint8)
    palette[9] = palette[4]
    colors = random.integers(0, 256, (500, 3)).astype(np.uint8)
    colors[:16] = palette
    distance = ((colors[:, None].astype(int) - palette) ** 2).sum(axis=2)
    assert (nearest(colors, palette) == distance.argmin(axis=1)).all()


class TestGif:
    @pytest.mark.parametrize("interlace", [0, 1])
    @pytest.mark.parametrize("colors", [2, 3, 16, 256])
    @pytest.mark.parametrize("shape", [(1, 1), (7, 13), (90, 64)])
    def test_reads_what_pillow_writes(self, shape, colors, interlace):
        random = np.random.default_rng(colors)
        for pixels in (
            random.integers(0, colors, shape),
            np.add.outer(np.arange(shape[0]), np.arange(shape[1])) // 7 % colors,
        ):
            picture = PIL.fromarray(pixels.astype(np.uint8), "P")
            picture.putpalette(random.integers(0, 256, 768).astype(np.uint8).tobytes())
            file = io.BytesIO()
            picture.save(file, "GIF", interlace=interlace, optimize=False)
            indices, palette = gif.read(file.getvalue())
            shown = np.array(PIL.open(io.BytesIO(file.getvalue())).convert("RGB"))
            assert (palette[indices][..., :3] == shown).all()

    def test_a_picture_on_a_part_of_its_screen(self):
        head = b"GIF89a" + struct.pack("<HHBBB", 3, 2, 0x80, 0, 0) + bytes([0, 0, 0, 255, 255, 255])
        picture = b"," + struct.pack("<HHHHB", 1, 1, 1, 1, 0) + b"\x02\x02\x4c\x01\x00;"
        indices, palette = gif.read(head + picture)
        assert palette[indices][..., 3].tolist() == [[0, 0, 0], [0, 255, 0]]
        assert palette[indices][1, 1].tolist() == [255, 255, 255, 255]


# Malformed files

CRASHING = [
    b'/* XPM */\nstatic char *x[] = {\n"1 1 1 1",\n"a c #FF0000",\n"b"};\n',  # SIGSEGV in SDL_image
    bytes([0, 0, 2] + [0] * 9 + [0, 0, 24, 0]) + b"\0\0",  # a TGA of no size: SIGFPE
    b"GIF89a" + b"\xff" * 30,
]


def files():
    """A small file of each format."""
    pixels = np.arange(48, dtype=np.uint8).reshape(6, 8) % 16
    palette = np.arange(768, dtype=np.uint8).reshape(256, 3)
    return {form: imagefile.encode(pixels, palette, form) for form in FORMS}


FILES = files()


@st.composite
def malformed(draw):
    """A file with some bytes changed, cut out or put in."""
    data = bytearray(draw(st.sampled_from(sorted(FILES.values()))))
    for _ in range(draw(st.integers(1, 6))):
        at = draw(st.integers(0, len(data) - 1))
        if draw(st.booleans()):
            data[at] = draw(st.sampled_from([0, 1, 127, 128, 255]) | st.integers(0, 255))
        else:
            data[at : at + draw(st.integers(0, 9))] = draw(st.binary(max_size=9))
        data = data or bytearray(b"\0")
    return bytes(data)


@settings(deadline=None, max_examples=300)
@given(malformed() | st.binary(max_size=60))
@example(CRASHING[0])
@example(CRASHING[1])
@example(CRASHING[2])
def test_any_bytes_are_a_picture_or_a_clear_error(tmp_path_factory, data):
    file = tmp_path_factory.getbasetemp() / "any.png"
    file.write_bytes(data)
    before = page()
    try:
        bgi.readimagefile(file)
    except ValueError as error:
        assert str(error).startswith("any.png ")
        assert (page() == before).all()


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def bombs():
    """Small files that claim to be enormous."""
    head = struct.pack(">IIBBBBB", 30000, 30000, 1, 0, 0, 0, 0)
    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", b"") + chunk(b"IEND", b"")
    bmp = bytearray(FILES["bmp"])
    bmp[18:26] = struct.pack("<ii", 30000, -30000)
    jpg = b"\xff\xd8\xff\xc0" + struct.pack(">HBHHB9x", 17, 8, 60000, 60000, 3) + b"\xff\xd9"
    small = bytearray(FILES["gif"])
    small[6:10] = struct.pack("<HH", 60000, 60000)
    return {"png": png, "bmp": bytes(bmp), "jpg": jpg, "gif": bytes(small)}


@pytest.mark.parametrize("form", ["png", "bmp", "jpg", "gif"])
def test_a_small_file_that_claims_to_be_enormous_is_refused_unread(tmp_path, form, monkeypatch):
    monkeypatch.setattr(backend, "read_picture", None)  # to unpack it would fail in another way
    (tmp_path / "a").write_bytes(bombs()[form])
    with pytest.raises(ValueError, match=r"a cannot be read: \d+x-?\d+ pixels, and at most 67,108"):
        bgi.readimagefile(tmp_path / "a")


def test_what_crashed_the_interpreter(tmp_path):
    """In a process of its own, so that a crash is a failure and not the end of all tests."""
    code = "import sys; from bgi import *; initgraph(); readimagefile(sys.argv[1])"
    for number, data in enumerate(CRASHING):
        file = tmp_path / f"{number}.png"
        file.write_bytes(data)
        ran = subprocess.run([sys.executable, "-c", code, file], capture_output=True, text=True)
        assert ran.returncode == 1
        assert "ValueError" in ran.stderr
