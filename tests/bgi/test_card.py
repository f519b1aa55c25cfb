"""The card: the documented layout, both sides of the mapping, and nothing left behind."""

import gc
import mmap
import os
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bgi.memory.card import AT_PALETTE, AT_PIXELS, MAX_SIDE, PALETTE_BYTES, Card, Frame
from bgi.memory.card import _anonymous_file as anonymous_file

posix = pytest.mark.skipif(sys.platform == "win32", reason="uses POSIX descriptors")
linux = pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")


@pytest.fixture
def card() -> Card:
    card = Card()
    card.set_mode(640, 480, 4)
    return card


def memory(card: Card) -> mmap.mmap:
    """The card's buffer, mapped by its handle alone, as a foreign monitor would."""
    _, name, size = card.handle.split(":")
    if sys.platform == "win32":
        return mmap.mmap(-1, int(size), tagname=name)
    return mmap.mmap(int(name), int(size))


def handle_for_another(card: Card) -> str:
    """The handle as another process has it: with a descriptor of its own."""
    for fd in card.inherit:
        return f"fd:{os.dup(fd)}:{AT_PIXELS + card.capacity}"
    return card.handle


def test_the_header_is_as_documented(card: Card) -> None:
    card.visible = 2
    card.palette[0] = 1, 2, 3
    card.palette[255] = 7, 8, 9
    raw = memory(card)
    assert raw[:8] == b"BGICARD\0"
    assert struct.unpack_from("<8I", raw, 8) == (2, 640, 480, 4, 1, 2, card.changes, 0)
    assert raw[64:67] == b"\1\2\3"
    assert raw[64 + 765 : 64 + 768] == b"\7\10\11"
    assert len(raw) == 4096 + 2 * 1024 * 768


def test_the_header_of_a_text_mode_is_as_documented(card: Card) -> None:
    card.set_text_mode(80, 25, 16, 2)
    card.cursor[0], card.cursor[1] = 81, 0x0D0E
    raw = memory(card)
    assert struct.unpack_from("<8I", raw, 8) == (2, 80, 25, 1, 2, 0, card.changes, 0)
    assert struct.unpack_from("<4I", raw, 40) == (16, 81, 0x0D0E, 2)
    card.page(0)[:4] = b"A\7B\x1e"
    frame = card.frame()
    assert frame is not None and frame.text is not None
    assert frame[:4] == (640, 400, 2, False)
    assert frame.pixels == b"A\7B\x1e" + bytes(80 * 25 * 2 - 4)
    assert frame.text[:6] == (80, 25, 16, 81, 0x0D0E, 2)


def test_there_is_no_text_mode_of_other_characters(card: Card) -> None:
    with pytest.raises(ValueError, match="8, 14 or 16 pixels high, not 9"):
        card.set_text_mode(80, 25, 9)
    assert (card.width, card.height) == (640, 480)


def test_pixels_follow_page_after_page_from_top_to_bottom(card: Card) -> None:
    card.page(1)[3 * 640 + 5] = 9
    raw = memory(card)
    assert raw[4096 + (640 * 480) + 3 * 640 + 5] == 9
    assert sum(raw[4096:]) == 9


def test_a_new_card_shows_nothing() -> None:
    card = Card()
    assert (card.width, card.height, card.pages, card.visible, card.changes) == (0, 0, 0, 0, 0)
    assert card.frame() is None
    with pytest.raises(ValueError, match="there is no page 0"):
        card.page(0)


def test_set_mode_clears_all_but_the_palette(card: Card) -> None:
    card.page(0)[:] = bytes([7]) * (640 * 480)
    card.palette[5] = 1, 2, 3
    card.visible = 3
    before = card.changes
    card.set_mode(320, 200, 2)
    assert (card.width, card.height, card.pages, card.visible) == (320, 200, 2, 0)
    assert bytes(card.page(0)) + bytes(card.page(1)) == bytes(2 * 320 * 200)
    assert card.palette[5].tolist() == [1, 2, 3]
    assert card.changes == before + 1


def test_a_mode_must_fit() -> None:
    card = Card(capacity=1000)
    card.set_mode(100, 5, 2)
    with pytest.raises(ValueError, match=r"2 pages of 100 x 6 pixels need 1200 .* has 1000"):
        card.set_mode(100, 6, 2)
    for width, height, pages in [(0, 1, 1), (1, -1, 1), (1, 1, 0), (MAX_SIDE + 1, 1, 1)]:
        with pytest.raises(ValueError, match="no mode has"):
            card.set_mode(width, height, pages)
    assert (card.width, card.height, card.pages) == (100, 5, 2)


def test_pages_of_four_bytes_a_pixel() -> None:
    card = Card(capacity=4 * 6 * 2)
    with pytest.raises(ValueError, match="a pixel has 1 or 4 bytes, not 2"):
        card.set_mode(3, 2, 1, pixel_bytes=2)
    with pytest.raises(ValueError, match="3 pages of 3 x 2 pixels need 72 bytes"):
        card.set_mode(3, 2, 3, pixel_bytes=4)
    card.set_mode(3, 2, 2, pixel_bytes=4, square=True)
    assert (card.pixel_bytes, card.square) == (4, True)
    page = np.frombuffer(card.page(1), "<u4").reshape(2, 3)
    page[1, 2] = 0x03AABBCC
    card.visible = 1
    frame = card.frame()
    assert frame == Frame(3, 2, 4, True, bytes(20) + b"\xcc\xbb\xaa\3")
    del page
    card.set_mode(3, 2, 2)
    assert (card.pixel_bytes, card.square) == (1, False)


def test_a_monitor_never_sees_half_a_mode(card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
    seen = set()
    write = Card._set

    def write_and_look(self: Card, offset: int, number: int) -> None:
        write(self, offset, number)
        frame = self.frame()
        seen.add(frame and frame[:2])

    monkeypatch.setattr(Card, "_set", write_and_look)
    card.set_mode(320, 200, 2)
    assert seen == {None, (320, 200)}


def test_the_visible_page_is_counted_and_checked(card: Card) -> None:
    before = card.changes
    card.visible = 3
    assert (card.visible, card.changes) == (3, before + 1)
    for number in (-1, 4):
        with pytest.raises(ValueError, match=f"there is no page {number}; the mode has 4"):
            card.visible = number
    assert (card.visible, card.changes) == (3, before + 1)


def test_changes_wrap(card: Card) -> None:
    struct.pack_into("<I", memory(card), 32, 0xFFFFFFFF)
    card.touch()
    assert card.changes == 0


def test_pages_are_apart(card: Card) -> None:
    pages = [card.page(number) for number in range(4)]
    for number, page in enumerate(pages):
        page[:] = bytes([number + 1]) * len(page)
    assert [set(page) for page in pages] == [{1}, {2}, {3}, {4}]
    assert [page.nbytes for page in pages] == [640 * 480] * 4


def test_the_palette_is_a_view(card: Card) -> None:
    assert card.palette.shape == (256, 3)
    card.palette[:, 1] = np.arange(256)
    assert card.palette[200].tolist() == [0, 200, 0]


def test_the_other_side_sees_the_same_memory(card: Card) -> None:
    other = Card.attach(handle_for_another(card))
    card.page(2)[7] = 5
    card.visible = 2
    frame = other.frame()
    assert frame is not None
    assert frame[:4] == (640, 480, 1, False)
    assert frame.pixels == bytes(7) + b"\5" + bytes(640 * 480 - 8)
    other.page(2)[8] = 6
    assert card.page(2)[8] == 6


@pytest.mark.parametrize(
    "handle", ["", "fd", "fd:3", "fd:x:99999", "fd::99999", "disk:3:99999", "fd:3:-5", "fd:3:100"]
)
def test_attach_refuses_what_is_no_handle(handle: str) -> None:
    with pytest.raises(ValueError, match=r"graphics card"):
        Card.attach(handle)


@pytest.mark.parametrize("damage", [b"BGICARD\1", b"BGICARD\0\1\0\0\0", bytes(12)])
def test_attach_refuses_what_is_no_card(damage: bytes) -> None:
    card = Card(capacity=0)
    memory(card)[: len(damage)] = damage
    with pytest.raises(ValueError, match="is not a graphics card of version 2"):
        Card.attach(handle_for_another(card))


def test_attach_refuses_a_card_that_is_too_small() -> None:
    card = Card(capacity=0)
    kind, name, _ = card.handle.split(":")
    with pytest.raises(ValueError, match="cannot map"):
        Card.attach(f"{kind}:{name}:{100 * AT_PIXELS}")


@posix
def test_attach_refuses_a_descriptor_that_is_closed() -> None:
    fd = anonymous_file(AT_PIXELS)
    os.close(fd)
    with pytest.raises(ValueError, match="cannot map"):
        Card.attach(f"fd:{fd}:{AT_PIXELS}")


@given(header=st.binary(min_size=56, max_size=56))
def test_a_monitor_survives_any_header(header: bytes) -> None:
    check_frame(header)


@given(numbers=st.lists(st.integers(0, 40), min_size=12, max_size=12))
def test_a_monitor_survives_any_small_header(numbers: list[int]) -> None:
    check_frame(b"BGICARD\0" + struct.pack("<12I", *numbers))


def check_frame(header: bytes) -> None:
    card = Card(capacity=5000)
    memory(card)[: len(header)] = header
    width, height, pages, pixel_bytes, visible = struct.unpack_from("<5I", header, 12)
    (cell_height,) = struct.unpack_from("<I", header.ljust(56, b"\0"), 40)
    across, down = (8, cell_height) if pixel_bytes == 2 else (1, 1)
    frame = card.frame()
    if frame is None:
        assert not (
            0 < width * across <= MAX_SIDE
            and 0 < height * down <= MAX_SIDE
            and visible < pages
            and (pixel_bytes in (1, 4) or (pixel_bytes == 2 and cell_height in (8, 14, 16)))
            and width * height * pages * pixel_bytes <= 5000
        )
    else:
        assert frame[:3] == (width * across, height * down, pixel_bytes)
        assert len(frame.pixels) == width * height * pixel_bytes
    card.close()


def test_close_never_raises(card: Card) -> None:
    page, palette = card.page(0), card.palette
    card.close()
    card.close()
    page[0] = 3  # whoever still has a view may go on using it
    assert (page[0], palette.shape) == (3, (256, 3))


def test_a_closed_card_says_so(card: Card) -> None:
    card.close()
    with pytest.raises(ValueError, match="mmap closed"):
        card.touch()


@linux
def test_no_descriptor_is_left_open() -> None:
    def descriptors() -> int:
        gc.collect()
        return len(os.listdir("/proc/self/fd"))

    before = descriptors()
    for _ in range(5):
        Card().close()
        Card()  # never closed, just dropped
    assert descriptors() == before


@linux
def test_no_name_appears_anywhere() -> None:
    before = set(os.listdir("/dev/shm"))
    card = Card()
    assert set(os.listdir("/dev/shm")) == before
    assert os.fstat(card.inherit[0]).st_nlink == 0


@posix
def test_where_there_is_no_memfd(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "darwin")
    card = Card()
    card.set_mode(640, 480, 4)
    assert os.fstat(card.inherit[0]).st_nlink == 0
    assert os.fstat(card.inherit[0]).st_size == AT_PIXELS + card.capacity


@posix
def test_a_fork_shares_the_memory() -> None:
    program = """if True:
        import os
        from bgi.memory.card import Card
        card = Card()
        card.set_mode(320, 200, 2)
        if os.fork() == 0:
            card.page(0)[5] = 77
            raise SystemExit
        os.wait()
        print(card.page(0)[5], os.fstat(card.inherit[0]).st_nlink)
    """
    home = Path(__file__).resolve().parents[2]
    done = subprocess.run([sys.executable, "-c", program], cwd=home, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("77 0\n", "")


def test_the_palette_ends_before_the_pixels() -> None:
    assert AT_PALETTE + PALETTE_BYTES <= AT_PIXELS
