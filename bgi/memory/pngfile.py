"""PNG files, written and read with numpy and zlib.

Source: Portable Network Graphics (PNG) Specification, second edition, W3C 2003. A file is a chain
of chunks: length, four letters, data, checksum. Rows are filtered (section 9), then deflated.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Bytes = NDArray[np.uint8]

SIGNATURE = b"\x89PNG\r\n\x1a\n"
_GRAY, _RGB, _INDEXED, _GRAY_ALPHA, _RGBA = 0, 2, 3, 4, 6
_SAMPLES = {_GRAY: 1, _RGB: 3, _INDEXED: 1, _GRAY_ALPHA: 2, _RGBA: 4}
_DEPTHS = {
    _GRAY: (1, 2, 4, 8, 16),
    _RGB: (8, 16),
    _INDEXED: (1, 2, 4, 8),
    _GRAY_ALPHA: (8, 16),
    _RGBA: (8, 16),
}
_PASSES = {
    0: ((0, 0, 1, 1),),
    # Adam7: the first row and column of each pass, and the steps to the next ones.
    1: (
        (0, 0, 8, 8),
        (0, 4, 8, 8),
        (4, 0, 8, 4),
        (0, 2, 4, 4),
        (2, 0, 4, 2),
        (0, 1, 2, 2),
        (1, 0, 2, 1),
    ),
}


# Writing


def write(pixels: Bytes, palette: Bytes | None) -> bytes:
    """A file of indices (height, width) with a palette (256, 3), or of RGB (height, width, 3)."""
    height, width = pixels.shape[:2]
    rows = np.zeros((height, 1 + pixels[0].size), np.uint8)  # each begins with its filter: none
    rows[:, 1:] = pixels.reshape(height, -1)
    kind = _RGB if palette is None else _INDEXED
    chunks = {b"IHDR": struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)}
    if palette is not None:
        chunks[b"PLTE"] = palette.tobytes()
    chunks |= {b"IDAT": zlib.compress(rows.tobytes()), b"IEND": b""}
    return SIGNATURE + b"".join(_chunk(*chunk) for chunk in chunks.items())


def _chunk(kind: bytes, data: bytes) -> bytes:
    checksum = zlib.crc32(kind + data)
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)


# Reading


class _Header(NamedTuple):
    width: int
    height: int
    depth: int
    kind: int
    compression: int
    filtering: int
    interlace: int

    @property
    def pixel_bits(self) -> int:
        return self.depth * _SAMPLES[self.kind]

    def check(self) -> None:
        if not (
            self.depth in _DEPTHS.get(self.kind, ())
            and self.compression == self.filtering == 0
            and self.interlace in _PASSES
        ):
            raise ValueError("its header makes no sense")


def read(data: bytes) -> tuple[Bytes, Bytes | None]:
    """Indices (height, width) and their colours (256, 4), or RGBA (height, width, 4) and None."""
    chunks: dict[bytes, bytes] = {}
    for kind, content in _chunks(data):
        chunks[kind] = chunks.get(kind, b"") + content if kind == b"IDAT" else content
    try:
        header = _Header(*struct.unpack(">IIBBBBB", chunks[b"IHDR"]))
        header.check()
        samples = _samples(header, zlib.decompress(chunks[b"IDAT"]))
    except (KeyError, struct.error, zlib.error) as error:
        raise ValueError(f"it is damaged: {error}") from None
    if header.kind == _INDEXED:
        return samples[..., 0].astype(np.uint8), _colors(chunks)
    return _rgba(header, samples, chunks.get(b"tRNS", b"")), None


def _chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    at = len(SIGNATURE)
    while at + 12 <= len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        content = data[at + 8 : at + 8 + length]
        at += 12 + length
        if data[at - 4 : at] != struct.pack(">I", zlib.crc32(kind + content)):
            raise ValueError("it is damaged: a checksum is wrong")
        yield kind, content


def _samples(header: _Header, data: bytes) -> NDArray[np.uint16]:
    """The numbers of all pixels, shape (height, width, samples)."""
    height, width = header.height, header.width
    samples = np.zeros((height, width, _SAMPLES[header.kind]), np.uint16)
    at = 0
    for top, left, down, across in _PASSES[header.interlace]:
        part = samples[top::down, left::across]
        rows, row_bytes = len(part), -(-part.shape[1] * header.pixel_bits // 8)
        if part.size == 0:
            continue
        end = at + rows * (row_bytes + 1)
        if end > len(data):
            raise ValueError("it ends too soon")
        filtered = np.frombuffer(data[at:end], np.uint8).reshape(rows, row_bytes + 1)
        part[...] = _unpacked(_unfiltered(filtered, -(-header.pixel_bits // 8)), header, part.shape)
        at = end
    return samples


def _unpacked(rows: Bytes, header: _Header, shape: tuple[int, ...]) -> NDArray[np.uint16]:
    """The samples in the bytes of rows, the first one in the highest bits."""
    if header.depth == 16:
        numbers = rows.view(">u2").astype(np.uint16)
    elif header.depth == 8:
        numbers = rows.astype(np.uint16)
    else:
        bits = np.unpackbits(rows, axis=1).reshape(len(rows), -1, header.depth)
        weights = 1 << np.arange(header.depth - 1, -1, -1)
        numbers = (bits @ weights).astype(np.uint16)
    return numbers[:, : shape[1] * shape[2]].reshape(shape)


def _unfiltered(filtered: Bytes, step: int) -> Bytes:
    """The bytes of rows whose first byte says how the others are filtered.

    `step` is the distance, in bytes, to the same part of the pixel before.
    """
    rows = filtered[:, 1:].copy()
    above = np.zeros_like(rows[0])
    for how, row in zip(filtered[:, 0].tolist(), rows, strict=True):
        if how == 1:  # the sum of all before it
            for part in range(step):
                np.cumsum(row[part::step], out=row[part::step], dtype=np.uint8)
        elif how == 2:
            row += above
        elif how in (3, 4):
            row[:] = (_average if how == 3 else _paeth)(row.tolist(), above.tolist(), step)
        elif how:
            raise ValueError(f"it is damaged: there is no filter {how}")
        above = row
    return rows


def _average(row: list[int], above: list[int], step: int) -> list[int]:
    left = [0] * step + row
    for i, up in enumerate(above, step):
        left[i] = left[i] + (left[i - step] + up >> 1) & 255
    return left[step:]


def _paeth(row: list[int], above: list[int], step: int) -> list[int]:
    left, corners = [0] * step + row, [0] * step + above
    for i, (b, c) in enumerate(zip(above, corners, strict=False), step):
        a = left[i - step]
        to_a, to_b, to_c = abs(b - c), abs(a - c), abs(a + b - 2 * c)
        nearest = a if to_a <= to_b and to_a <= to_c else b if to_b <= to_c else c
        left[i] = left[i] + nearest & 255
    return left[step:]


def _colors(chunks: dict[bytes, bytes]) -> Bytes:
    """The palette as red, green, blue, alpha."""
    colors = np.full((256, 4), 255, np.uint8)
    palette = np.frombuffer(chunks.get(b"PLTE", b"")[:768], np.uint8)
    if len(palette) % 3:
        raise ValueError("its palette is damaged")
    colors[: len(palette) // 3, :3] = palette.reshape(-1, 3)
    alpha = np.frombuffer(chunks.get(b"tRNS", b"")[:256], np.uint8)
    colors[: len(alpha), 3] = alpha
    return colors


def _rgba(header: _Header, samples: NDArray[np.uint16], transparent: bytes) -> Bytes:
    """Colours of eight bits; `transparent` names one that is not seen."""
    wide = (1 << header.depth) - 1
    every = samples.astype(np.uint32) * 255 // wide if header.depth != 16 else samples >> 8
    colors = header.kind in (_RGB, _RGBA)
    rgba = np.full((*samples.shape[:2], 4), 255, np.uint8)
    rgba[..., :3] = every[..., :3] if colors else every[..., :1]
    if header.kind in (_GRAY_ALPHA, _RGBA):
        rgba[..., 3] = every[..., -1]
    elif len(transparent) == 2 * samples.shape[2]:
        unseen = np.frombuffer(transparent, ">u2")
        rgba[(samples == unseen).all(axis=2), 3] = 0
    return rgba
