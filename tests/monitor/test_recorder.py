"""Pictures in files: recordings, and plans for programs that nobody watches."""

import io
from pathlib import Path

import numpy as np
import pytest

from bgi.errors import BGIError, WindowClosed
from bgi.memory.card import Card, Frame
from bgi.memory.sdl import pygame
from bgi.monitor.headless import Headless
from bgi.monitor.picture import shot
from bgi.monitor.plan import Plan
from bgi.monitor.recorder import Recorder
from bgi.monitor.script import parse_script
from tests.skips import needs_pygame

PALETTE = np.random.default_rng(1).integers(0, 256, (256, 3), np.uint8)


@needs_pygame
def test_a_shot_of_either_kind_of_frame() -> None:
    indices = bytes([1, 2, 3, 4, 5, 6])
    image = pygame.image.load(
        io.BytesIO(shot(Frame(3, 2, 1, False, indices), PALETTE.tobytes())), "x.png"
    )
    assert image.get_buffer().raw[:3] == indices[:3]
    four = np.array([[3, 0x03123456]], "<u4").tobytes()
    image = pygame.image.load(
        io.BytesIO(shot(Frame(2, 1, 4, True, four), PALETTE.tobytes())), "x.png"
    )
    assert [tuple(image.get_at((x, 0)))[:3] for x in (0, 1)] == [
        tuple(PALETTE[3].tolist()),
        (0x56, 0x34, 0x12),
    ]


# GIF


def frame(index: int, width: int = 4) -> Frame:
    return Frame(width, 3, 1, False, bytes([index]) * (3 * width))


def read(file: Path) -> list[tuple[int, tuple[int, int, int]]]:
    """The pictures of a GIF: milliseconds and the colour of the first pixel."""
    pil = pytest.importorskip("PIL.Image", reason="needs Pillow")
    with pil.open(file) as gif:
        found = []
        for number in range(gif.n_frames):
            gif.seek(number)
            found.append((gif.info["duration"], gif.convert("RGB").getpixel((0, 0))))
        return found


def colour(index: int) -> tuple[int, int, int]:
    red, green, blue = PALETTE[index].tolist()
    return red, green, blue


@pytest.fixture
def file(tmp_path: Path) -> Path:
    pytest.importorskip("PIL", reason="needs Pillow")
    return tmp_path / "r.gif"


def test_a_recording(file: Path) -> None:
    recorder = Recorder(str(file))
    for now, index in [(5.0, 1), (5.1, 2), (5.35, 3)]:
        recorder.add(now, frame(index), PALETTE.tobytes())
    recorder.save(6.0)
    assert read(file) == [(100, colour(1)), (250, colour(2)), (650, colour(3))]


def test_pictures_too_short_to_be_seen_are_left_out(file: Path) -> None:
    recorder = Recorder(str(file))
    for number in range(100):
        recorder.add(number / 1000, frame(number), PALETTE.tobytes())
    recorder.save(0.1)
    pictures = read(file)
    assert 4 <= len(pictures) <= 6
    assert all(milliseconds >= 20 for milliseconds, _ in pictures)
    assert pictures[-1] == (pictures[-1][0], colour(99))


def test_a_change_of_size_and_depth_on_the_way(file: Path) -> None:
    recorder = Recorder(str(file))
    recorder.add(0, frame(1), PALETTE.tobytes())
    recorder.add(1, frame(2, width=8), PALETTE.tobytes())
    four = np.full(12, 0x03123456, "<u4").tobytes()
    recorder.add(2, Frame(4, 3, 4, True, four), PALETTE.tobytes())
    recorder.save(3)
    assert read(file) == [(1000, colour(1)), (1000, colour(2)), (1000, (0x56, 0x34, 0x12))]


def test_a_picture_that_stays_longer_than_a_gif_can_say(file: Path) -> None:
    recorder = Recorder(str(file))
    recorder.add(0, frame(1), PALETTE.tobytes())
    recorder.add(1400, frame(2), PALETTE.tobytes())
    recorder.save(1401)
    lengths, colors = zip(*read(file), strict=True)
    assert lengths == (655_350, 655_350, 89_300, 1000)
    red, green, blue = colour(1)
    assert colors == (colour(1), (red, green, blue ^ 1), colour(1), colour(2))


def test_nothing_recorded_is_no_file(file: Path) -> None:
    with pytest.raises(OSError, match="nothing was on show"):
        Recorder(str(file)).save(1)
    assert not file.exists()


def test_without_pillow_one_line_helps(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(
        BGIError, match=r'^recording needs Pillow; type: pip install "\.\[record\]"$'
    ):
        Recorder("x.gif")


# Plans


@pytest.fixture
def card() -> Card:
    card = Card()
    card.set_mode(320, 200, 2)
    card.palette[:] = PALETTE
    return card


def test_an_empty_plan(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("BGI_KEYS", "BGI_SHOT", "BGI_AFTER", "BGI_RECORD"):
        monkeypatch.delenv(name, raising=False)
    assert Plan.from_environment() == Plan()
    monkeypatch.setenv("BGI_AFTER", "soon")
    with pytest.raises(ValueError, match="BGI_AFTER: 'soon' is not a time: write 2s, 2"):
        Plan.from_environment()


def test_the_planned_end(card: Card, tmp_path: Path) -> None:
    monitor = Headless(card=card, plan=Plan(after=1, shot=str(tmp_path / "s.png")))
    monitor.sleep(999)
    card.page(0)[0] = 7
    for _ in range(2):
        with pytest.raises(WindowClosed, match=r"^ended after 1 s, as planned$"):
            monitor.sleep(5)
    assert monitor.now == 1000
    card.page(0)[0] = 8
    monitor.close()  # too late for another picture
    image = pygame.image.load(str(tmp_path / "s.png"))
    assert image.get_at((0, 0))[:3] == colour(7)


def test_files_that_cannot_be_written_are_one_line_each(
    card: Card, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("PIL", reason="needs Pillow")
    nowhere = str(tmp_path / "nowhere" / "x")
    monitor = Headless(card=card, plan=Plan(shot=nowhere, record=nowhere))
    monitor.show()
    monitor.close()
    line = f"bgi: {nowhere} was not written: No such file or directory\n"
    assert capsys.readouterr() == ("", 2 * line)


def test_who_waits_for_a_key_that_never_comes_waits_until_the_end(card: Card) -> None:
    monitor = Headless(card=card, plan=Plan(after=1))
    with pytest.raises(WindowClosed):
        monitor.read_key()


def test_a_loop_around_kbhit_comes_to_the_end(card: Card) -> None:
    monitor = Headless(card=card, plan=Plan(after=1))
    with pytest.raises(WindowClosed):
        while not monitor.key_waiting():
            pass


def test_a_recording_in_virtual_time(card: Card, file: Path) -> None:
    monitor = Headless(card=card, plan=Plan(parse_script("a"), record=str(file)))
    for index in (1, 2, 3):
        card.page(0)[:] = bytes([index]) * (320 * 200)
        monitor.sleep(100)
    card.page(0)[:] = bytes([4]) * (320 * 200)
    monitor.read_key()  # waits for somebody to press it
    card.page(0)[:] = bytes([5]) * (320 * 200)
    monitor.close()
    lengths, colours = zip(*read(file), strict=True)
    assert lengths == (100, 100, 100, 250, 500)
    assert colours == tuple(map(colour, (1, 2, 3, 4, 5)))
