"""The part of `bgi.memory.backend` that pygame has: its surfaces, its lines, its files."""

from __future__ import annotations

import io
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from bgi.memory.sdl import pygame, quietly

_FORMAT: dict[int, Literal["P", "RGBX"]] = {1: "P", 4: "RGBX"}

draw_line = pygame.draw.line
draw_box = pygame.draw.rect


def surface(memory: memoryview, width: int, height: int, pixel_bytes: int) -> pygame.Surface:
    """A surface over memory, rows from top to bottom."""
    return pygame.image.frombuffer(memory, (width, height), _FORMAT[pixel_bytes])


def write_picture(pixels: NDArray[np.uint8], palette: NDArray[np.uint8] | None, form: str) -> bytes:
    """A file, "png", "bmp" or "jpg", of indices (height, width) or colours (height, width, 3)."""
    size = pixels.shape[1], pixels.shape[0]
    if palette is None:
        picture = pygame.image.frombuffer(pixels.tobytes(), size, "RGB")
    else:
        picture = pygame.image.frombuffer(pixels.tobytes(), size, "P")
        picture.set_palette(palette.tolist())
    file = io.BytesIO()
    pygame.image.save(picture, file, form)
    return file.getvalue()


def read_picture(data: bytes, form: str) -> tuple[NDArray[np.uint8], NDArray[np.uint8] | None]:
    """Indices (height, width) and their colours (256, 4), or RGBA (height, width, 4) and None.

    ValueError says what is wrong with the file.
    """
    try:
        with quietly():  # libpng prints what it thinks of a file
            picture = pygame.image.load(io.BytesIO(data), form)
    except pygame.error as error:
        raise ValueError(str(error)) from None
    width, height = picture.get_size()
    if picture.get_bitsize() != 8:
        pixels: NDArray[Any] = np.frombuffer(pygame.image.tobytes(picture, "RGBA"), np.uint8)
        return pixels.reshape(height, width, 4), None
    pixels = np.frombuffer(pygame.image.tobytes(picture, "P"), np.uint8)
    colors = np.full((256, 4), 255, np.uint8)
    palette = np.array([tuple(color)[:3] for color in picture.get_palette()], np.uint8)
    colors[: len(palette), :3] = palette
    key = picture.get_colorkey()
    if key is not None:
        colors[picture.map_rgb(key), 3] = 0
    return pixels.reshape(height, width), colors
