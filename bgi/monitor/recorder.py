"""A recording of what was on show: pictures and their times, written as a GIF that moves.

Pillow writes the file; it is optional. Until then the pictures wait, compressed: a minute of a
typical program fits into a few megabytes.
"""

import importlib.util
import zlib
from collections.abc import Iterator
from typing import Any

from bgi.errors import BGIError
from bgi.memory.card import Frame
from bgi.monitor.picture import colored, pixels

TICK = 0.01  # seconds: the GIF's unit of time
SHORTEST = 2  # ticks: browsers show a picture that is meant to be shorter far too long
LONGEST = 65535  # ticks: all that a GIF can say of one picture; eleven minutes
LAST = 0.5  # seconds at least for the last picture, before it all begins again


def missing() -> str:
    """What keeps us from recording, in a line that helps; empty if nothing does."""
    found = importlib.util.find_spec("PIL") is not None
    return "" if found else 'recording needs Pillow; type: pip install ".[record]"'


class Recorder:
    """A recording under way; BGIError if Pillow is not installed."""

    def __init__(self, file: str) -> None:
        if reason := missing():
            raise BGIError(reason)
        self.file = file
        self._frames: list[tuple[float, Frame, bytes]] = []

    def add(self, now: float, frame: Frame, palette: bytes) -> None:
        """A picture is on show from `now` (in seconds) on, if it is not already."""
        packed = frame._replace(pixels=zlib.compress(frame.pixels, 1))
        if not self._frames or self._frames[-1][1:] != (packed, palette):
            self._frames.append((now, packed, palette))

    def save(self, now: float) -> None:
        """Write what has been on show until `now`; OSError if that fails, or nothing has been."""
        kept: list[tuple[int, int]] = []  # from which tick on which picture is seen
        for number, (then, _, _) in enumerate(self._frames):
            tick = round(then / TICK)
            if kept and tick - kept[-1][0] < SHORTEST:
                tick, _ = kept.pop()  # the later picture takes the place of one hardly seen
            kept.append((tick, number))
        if not kept:
            raise OSError("nothing was on show")
        starts = [tick for tick, _ in kept]
        starts.append(max(round(now / TICK), starts[-1] + round(LAST / TICK)))
        shown = [
            (number, part)
            for (start, number), end in zip(kept, starts[1:], strict=True)
            for part in _parts(end - start)
        ]
        images = self._images([number for number, _ in shown])
        next(images).save(
            self.file,
            format="GIF",
            save_all=True,
            append_images=images,
            duration=[round(1000 * TICK * part) for _, part in shown],
            loop=0,
            optimize=True,  # pixels that stay as they were are left out: a third less
        )

    def _images(self, numbers: list[int]) -> Iterator[Any]:
        """Pillow's images of some of the pictures, all in the size of the first of them."""
        from PIL import Image

        size, before, marked = None, None, False
        for number in numbers:
            _, packed, palette = self._frames[number]
            frame = packed._replace(pixels=zlib.decompress(packed.pixels))
            image = _image(frame, palette)
            size = size or image.size
            image = image if image.size == size else image.resize(size, Image.Resampling.NEAREST)
            same = before is not None and self._frames[number][1:] == self._frames[before][1:]
            marked = same and not marked
            yield _marked(image) if marked else image
            before = number


def _parts(length: int) -> list[int]:
    """A time in ticks cut into pieces that a GIF can say."""
    rest = length % LONGEST
    return [LONGEST] * (length // LONGEST) + [rest] * (rest > 0)


def _marked(image: Any) -> Any:
    """The same picture, its first pixel a shade off: Pillow would join it with one just like it."""
    marked = image.convert("RGB")
    red, green, blue = marked.getpixel((0, 0))
    marked.putpixel((0, 0), (red, green, blue ^ 1))
    return marked.quantize(256)


def _image(frame: Frame, palette: bytes) -> Any:
    from PIL import Image

    size = frame.width, frame.height
    if frame.pixel_bytes == 4:
        return Image.frombytes("RGB", size, colored(frame, palette), "raw", "RGBX").quantize(256)
    image = Image.frombytes("P", size, pixels(frame).tobytes())
    image.putpalette(palette)
    return image
