"""Pictures on disk: a page as a PNG that keeps its palette and indices, and any picture read."""

import io
import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.memory import rgb
from bgi.memory.sdl import pygame

Filename = str | os.PathLike[str]


def png(pixels: NDArray[Any], palette: NDArray[np.uint8]) -> bytes:
    """Pixels (height, width) with their palette (256, 3) as a PNG.

    Indices are kept as they are; pixels of four bytes become the colours that they mean.
    """
    size = pixels.shape[1], pixels.shape[0]
    if pixels.dtype == np.uint8:
        surface = pygame.image.frombuffer(np.ascontiguousarray(pixels).data, size, "P")
        surface.set_palette(palette.tolist())
    else:
        shown = palette[pixels & 15]
        own = pixels >= 16
        shown[own] = np.stack([pixels[own] >> shift & 255 for shift in (0, 8, 16)], axis=-1)
        surface = pygame.image.frombuffer(shown.tobytes(), size, "RGB")
    file = io.BytesIO()
    pygame.image.save(surface, file, "png")
    return file.getvalue()


def save_png(filename: Filename, pixels: NDArray[Any], palette: NDArray[np.uint8]) -> None:
    """Write a PNG, as `png` makes it; OSError if that fails."""
    picture = png(pixels, palette)
    with open(filename, "wb") as file:
        file.write(picture)


def load(filename: Filename, width: int | None, height: int | None) -> NDArray[np.uint8]:
    """Read a picture (PNG, BMP, JPEG, GIF, ...) as RGB, shape (height, width, 3), scaled if asked.

    OSError if it cannot be read, ValueError if it is no picture.
    """
    with open(filename, "rb") as file:
        try:
            surface = pygame.image.load(file, os.fspath(filename))
        except pygame.error as error:
            raise ValueError(f"{filename} is not a picture that can be read: {error}") from None
    size = width or surface.get_width(), height or surface.get_height()
    scaled = pygame.transform.scale(surface, size)
    colors = pygame.image.tobytes(scaled, "RGB")
    return np.frombuffer(colors, np.uint8).reshape(size[1], size[0], 3)


def nearest(picture: NDArray[np.uint8], palette: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The palette indices whose colours come nearest to those of a picture."""
    colors, places = np.unique(picture.reshape(-1, 3), axis=0, return_inverse=True)
    found = np.empty(len(colors), np.uint8)
    for start in range(0, len(colors), 4096):  # bounds the memory
        part = colors[start : start + 4096, None].astype(np.int32)
        found[start : start + 4096] = ((part - palette) ** 2).sum(axis=2).argmin(axis=1)
    return found[places.reshape(picture.shape[:2])]


def tagged(picture: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """The colours of a picture as a window's pixels hold them."""
    red, green, blue = np.moveaxis(picture.astype(np.uint32), 2, 0)
    mixed: NDArray[np.uint32] = blue << 16 | green << 8 | red | np.uint32(rgb.TAG)
    return mixed
