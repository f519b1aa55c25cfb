"""Pictures on disk: a page as a PNG that keeps its palette and its very indices."""

import os

import numpy as np
from numpy.typing import NDArray

from bgi.sdl import pygame


def save_png(
    filename: str | os.PathLike[str], indices: NDArray[np.uint8], palette: NDArray[np.uint8]
) -> None:
    """Write indices (height, width) with their palette (256, 3); OSError if that fails."""
    height, width = indices.shape
    surface = pygame.image.frombuffer(np.ascontiguousarray(indices).data, (width, height), "P")
    surface.set_palette(palette.tolist())
    with open(filename, "wb") as file:
        pygame.image.save(surface, file, "png")
