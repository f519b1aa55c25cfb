"""BMP files, written and read with numpy: those without compression, as nearly all are.

Source: Microsoft's "Bitmap Storage": a header of 14 bytes, one of 12 (OS/2) or 40 and more, the
palette as blue, green, red and a spare byte, then rows from the bottom up, each a multiple of four
bytes.
"""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

Bytes = NDArray[np.uint8]

_FILE = struct.Struct("<2sI4xI")
_INFO = struct.Struct("<IiiHHIIiiII")
_UNCOMPRESSED, _BY_MASKS = 0, 3
_MASKS = 0xFF0000, 0x00FF00, 0x0000FF
"""What red, green and blue are of four bytes, unless a file says something else."""


def write(pixels: Bytes, palette: Bytes | None) -> bytes:
    """A file of indices (height, width) with a palette (256, 3), or of RGB (height, width, 3)."""
    height, width = pixels.shape[:2]
    line = (pixels if palette is not None else pixels[..., ::-1]).reshape(height, -1)
    rows = np.zeros((height, -(-line.shape[1] // 4) * 4), np.uint8)
    rows[:, : line.shape[1]] = line[::-1]
    table = b""
    if palette is not None:
        table = np.insert(palette[:, ::-1], 3, 0, axis=1).astype(np.uint8).tobytes()
    start = _FILE.size + _INFO.size + len(table)
    bits, colors = (24, 0) if palette is None else (8, 256)
    info = _INFO.pack(_INFO.size, width, height, 1, bits, 0, rows.size, 0, 0, colors, 0)
    return _FILE.pack(b"BM", start + rows.size, start) + info + table + rows.tobytes()


def read(data: bytes) -> tuple[Bytes, Bytes | None]:
    """Indices (height, width) and their colours (256, 4), or RGBA (height, width, 4) and None."""
    try:
        return _read(data)
    except struct.error:
        raise ValueError("it ends too soon") from None


def _read(data: bytes) -> tuple[Bytes, Bytes | None]:
    _, _, start = _FILE.unpack_from(data)
    (length,) = struct.unpack_from("<I", data, _FILE.size)
    compression = used = 0
    if length == 12:
        width, height, _, bits = struct.unpack_from("<HHHH", data, 18)
    else:
        _, width, height, _, bits, compression, *_, used, _ = _INFO.unpack_from(data, _FILE.size)
    masks = struct.unpack_from("<III", data, 54) if compression == _BY_MASKS else _MASKS
    if bits not in (1, 4, 8, 24, 32) or compression not in (_UNCOMPRESSED, _BY_MASKS):
        raise ValueError(f"a BMP of {bits} bits or of this compression needs pygame to be read")
    if masks != _MASKS:
        raise ValueError("its colours are in an order that needs pygame to be read")
    rows = _rows(data[start:], width, abs(height), bits)
    if height > 0:
        rows = rows[::-1]
    if bits < 24:
        parts = np.unpackbits(rows, axis=1).reshape(len(rows), -1, bits)
        indices = (parts @ (1 << np.arange(bits - 1, -1, -1))).astype(np.uint8)
        entry = 3 if length == 12 else 4
        table = data[_FILE.size + length : start][: entry * (used or 1 << bits)]
        return indices[:, :width], _colors(table, entry)
    pixels = rows[:, : width * bits // 8].reshape(len(rows), width, bits // 8)
    rgba = np.full((len(rows), width, 4), 255, np.uint8)
    rgba[..., :3] = pixels[..., 2::-1]
    return rgba, None


def _rows(data: bytes, width: int, height: int, bits: int) -> Bytes:
    row_bytes = -(-width * bits // 32) * 4
    if len(data) < row_bytes * height:
        raise ValueError("it ends too soon")
    return np.frombuffer(data[: row_bytes * height], np.uint8).reshape(height, row_bytes)


def _colors(table: bytes, entry: int) -> Bytes:
    """The palette as red, green, blue, alpha."""
    colors = np.full((256, 4), 255, np.uint8)
    found = np.frombuffer(table[: len(table) // entry * entry], np.uint8).reshape(-1, entry)[:256]
    colors[: len(found), :3] = found[:, 2::-1]
    return colors
