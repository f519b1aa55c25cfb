"""What draws solid lines and small boxes, and knows files of pictures: pygame, or numpy alone.

pygame's are faster, and there is no other way to a JPEG. Where there is no pygame
(`bgi.memory.sdl`) numpy draws the same pixels.

All is drawn within the page: what is outside was clipped before. (pygame clips too, but fills a box
of which it leaves two columns instead of drawing its outline.) A `surface` lies over the memory of
a page; its `fill(color, (left, top, width, height))` fills a box.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from bgi.memory import sdl

if TYPE_CHECKING or sdl.FOUND:
    from bgi.memory import withpygame as found
else:
    from bgi.memory import withnumpy as found

surface: Callable[[memoryview, int, int, int], Any] = found.surface
"""A surface over memory, of that width and height and so many bytes a pixel."""
draw_line: Callable[..., object] = found.draw_line
"""A line on a surface, in a color, from its second end to its first; of width 1 or 3."""
draw_box: Callable[..., object] = found.draw_box
"""The outline of a box (left, top, width, height), in a color."""
write_picture = found.write_picture
read_picture = found.read_picture
