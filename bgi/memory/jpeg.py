"""What the head of a JPEG file says: size, how many components, and which way up it was taken.

A file is a chain of segments, each FF, a letter and a length. Sources: ITU T.81, annex B; for the
way up Exif 2.3, tag 0112 (a TIFF directory in segment E1).
"""

from __future__ import annotations

import struct
from typing import NamedTuple

_FRAMES = {0xC0, 0xC1, 0xC2, 0xC3, 0xC5, 0xC6, 0xC7, 0xC9, 0xCA, 0xCB, 0xCD, 0xCE, 0xCF}
_EXIF, _START_OF_SCAN = 0xE1, 0xDA
_ORIENTATION = 0x0112


class Head(NamedTuple):
    """Width and height as stored; colour components of a pixel; orientation as Exif numbers it."""

    width: int
    height: int
    components: int
    orientation: int


def head(data: bytes) -> Head:
    """The head of a file; ValueError if it is cut short."""
    orientation, at = 1, 2
    while at + 4 <= len(data) and data[at] == 0xFF:
        kind = data[at + 1]
        if kind == 0xFF:  # padding
            at += 1
            continue
        (length,) = struct.unpack_from(">H", data, at + 2)
        body = data[at + 4 : at + 2 + length]
        if kind in _FRAMES and len(body) >= 6:
            _, height, width, components = struct.unpack_from(">BHHB", body)
            return Head(width, height, components, orientation)
        if kind == _EXIF and body.startswith(b"Exif\0\0"):
            orientation = _orientation(body[6:])
        if kind == _START_OF_SCAN:
            break
        at += 2 + length
    raise ValueError("it ends too soon")


def _orientation(tiff: bytes) -> int:
    """Orientation 1..8 in a TIFF directory; 1, upright, if it says nothing that makes sense."""
    order = {b"II": "<", b"MM": ">"}.get(tiff[:2])
    if order is None:
        return 1
    try:
        (at,) = struct.unpack_from(f"{order}L", tiff, 4)
        (entries,) = struct.unpack_from(f"{order}H", tiff, at)
        for entry in range(entries):
            tag, _, _, value = struct.unpack_from(f"{order}HHLH", tiff, at + 2 + 12 * entry)
            if tag == _ORIENTATION:
                return value if 1 <= value <= 8 else 1
    except struct.error:  # a directory that points outside
        pass
    return 1
