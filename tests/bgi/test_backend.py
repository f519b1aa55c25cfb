"""numpy alone draws what pygame draws, and reads and writes its files."""

import io
import struct
import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bgi.memory import backend, bmpfile, pngfile, sdl, withnumpy
from bgi.monitor import sdlkeys
from tests.skips import needs_pygame

WIDTH, HEIGHT = 40, 30

PIL = pytest.importorskip("PIL.Image", reason="needs Pillow")


def test_which_one_is_used():
    from_pygame = "pygame" in type(backend.surface(memoryview(bytearray(4)), 2, 2, 1)).__module__
    assert from_pygame == sdl.FOUND


def both(pixel_bytes=1):
    """A page of pygame's and one of numpy's; each with its pixels."""
    from bgi.memory import withpygame

    for kind in (withpygame, withnumpy):
        memory = memoryview(bytearray(WIDTH * HEIGHT * pixel_bytes))
        yield kind, kind.surface(memory, WIDTH, HEIGHT, pixel_bytes), memory


x, y = st.integers(1, WIDTH - 2), st.integers(1, HEIGHT - 2)
points = st.tuples(x, y)


@needs_pygame
@given(points, points, st.sampled_from([1, 3]), st.sampled_from([1, 4]))
def test_lines(start, end, width, pixel_bytes):
    across, down = abs(end[0] - start[0]), abs(end[1] - start[1])
    if width == 3 and across == down:  # there pygame's are not the kernel's, and are not asked for
        width = 1
    drawn = []
    for kind, surface, memory in both(pixel_bytes):
        kind.draw_line(surface, 7, end, start, width)
        drawn.append(bytes(memory))
    assert drawn[0] == drawn[1]


@needs_pygame
@given(points, points, st.booleans())
def test_boxes(corner, other, filled):
    left, right = sorted((corner[0], other[0]))
    top, bottom = sorted((corner[1], other[1]))
    box = left, top, right - left + 1, bottom - top + 1
    drawn = []
    for kind, surface, memory in both(4):
        if filled:
            surface.fill(0x03102030, box)
        else:
            kind.draw_box(surface, 0x03102030, box, 1)
        drawn.append(bytes(memory))
    assert drawn[0] == drawn[1]


@needs_pygame
def test_keys_have_the_numbers_of_pygame():
    ours = {name: number for name, number in vars(sdlkeys).items() if name.startswith("K")}
    assert len(ours) > 40
    assert ours == {name: getattr(sdl.pygame, name) for name in ours}


# Files

RANDOM = np.random.default_rng(5)
INDICES = RANDOM.integers(0, 256, (13, 17)).astype(np.uint8)
PALETTE = RANDOM.integers(0, 256, (256, 3)).astype(np.uint8)


def saved(picture, form, **options):
    file = io.BytesIO()
    picture.save(file, form, **options)
    return file.getvalue()


def rgba(pixels, colors):
    return pixels if colors is None else colors[pixels]


@pytest.mark.parametrize("module", [pngfile, bmpfile])
@pytest.mark.parametrize("palette", [PALETTE, None])
def test_everybody_reads_what_is_written(module, palette):
    pixels = INDICES if palette is not None else PALETTE[INDICES]
    data = module.write(pixels, palette)
    with PIL.open(io.BytesIO(data)) as picture:
        assert (np.array(picture.convert("RGB")) == PALETTE[INDICES]).all()
    read, colors = module.read(data)
    assert (rgba(read, colors)[..., :3] == PALETTE[INDICES]).all()
    assert palette is None or (read == INDICES).all()


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGB", "RGBA", "I;16"])
def test_png_of_all_kinds(mode):
    if mode == "I;16":
        picture = PIL.fromarray(INDICES.astype(np.uint16) * 256 + 9)
        expected = PIL.fromarray(INDICES)
    else:
        noise = RANDOM.integers(0, 256, (13, 17, 4)).astype(np.uint8)
        smooth = np.add.outer(np.arange(13), np.arange(17))[..., None] * [3, 5, 7, 9]
        whole = np.vstack([noise, smooth.astype(np.uint8)])  # every filter is of use somewhere
        expected = picture = PIL.fromarray(whole, "RGBA").convert(mode)
    read = pngfile.read(saved(picture, "PNG"))
    assert (rgba(*read) == np.array(expected.convert("RGBA"))).all()


@pytest.mark.parametrize("colors", [2, 4, 16])
@pytest.mark.parametrize("form", ["PNG", "BMP"])
def test_few_colors(colors, form):
    picture = PIL.fromarray(INDICES % colors, "P")
    picture.putpalette(PALETTE[:colors].tobytes())
    read = {"PNG": pngfile.read, "BMP": bmpfile.read}[form](saved(picture, form))
    assert (read[0] == INDICES % colors).all()
    assert read[1] is not None and (read[1][:colors, :3] == PALETTE[:colors]).all()


def test_a_color_that_is_transparent():
    data = saved(
        PIL.fromarray(PALETTE[INDICES]), "PNG", transparency=tuple(PALETTE[INDICES[3, 4]].tolist())
    )
    unseen = pngfile.read(data)[0][..., 3] == 0
    assert (unseen == (PALETTE[INDICES] == PALETTE[INDICES[3, 4]]).all(axis=2)).all()


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


@pytest.mark.parametrize("size", [(1, 1), (3, 5), (13, 17)])
def test_interlaced(size):
    """Adam7: the passes one after another, each a small picture of its own."""
    height, width = size
    pixels = INDICES[:height, :width]
    rows = b""
    for top, left, down, across in pngfile._PASSES[1]:
        part = pixels[top::down, left::across]
        rows += b"".join(b"\0" + row.tobytes() for row in part) if part.size else b""
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 1)
    chunks = [(b"IHDR", head), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")]
    data = pngfile.SIGNATURE + b"".join(chunk(*one) for one in chunks)
    with PIL.open(io.BytesIO(data)) as picture:
        assert (np.array(picture) == pixels).all()
    assert (pngfile.read(data)[0][..., 0] == pixels).all()


@pytest.mark.parametrize("height", [13, -13])
def test_a_bmp_upside_down(height):
    data = bytearray(bmpfile.write(INDICES, PALETTE))
    data[22:26] = struct.pack("<i", height)
    expected = INDICES if height > 0 else INDICES[::-1]
    assert (bmpfile.read(bytes(data))[0] == expected).all()


@given(st.integers(0, 400), st.binary(max_size=5), st.sampled_from([pngfile, bmpfile]))
def test_what_is_damaged_is_a_picture_or_an_error(at, bytes_, module):
    data = bytearray(module.write(INDICES, PALETTE))
    data[at : at + len(bytes_)] = bytes_
    for damaged in (data, data[:at]):
        try:
            module.read(bytes(damaged))
        except ValueError as error:
            assert str(error)


@pytest.mark.parametrize("call", [withnumpy.read_picture, None])
def test_a_jpeg_needs_pygame(call):
    with pytest.raises(ValueError, match="a JPEG needs pygame, which is not installed"):
        if call:
            call(b"", "jpg")
        else:
            withnumpy.write_picture(INDICES, PALETTE, "jpg")
