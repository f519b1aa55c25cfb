"""The page of a driver that packs pixels into bytes, CGA.BGI or HERC.BGI: its lines run rightward.

Where other drivers draw every line downwards, and a level one from its first end, these draw to the
right, and an upright line from its second end: the same rule with x and y exchanged and the ends
too (Turbo C++ 3.0, captured).
"""

from bgi.memory.backend import draw_line
from bgi.memory.page import Page
from bgi.raster import lines


class PackedPage(Page):
    """A page whose lines run rightward."""

    trace = staticmethod(lines.trace_rightward)
    course = staticmethod(lines.course_rightward)

    def line(self, x1: int, y1: int, x2: int, y2: int, color: int) -> None:
        """A thin solid line."""
        visible = lines.clip(x1, y1, x2, y2, self.box)
        if visible is not None:
            left, right = sorted((visible[:2], visible[2:]))
            draw_line(self._surface, color, right, left)

    def thick_line(self, x1: int, y1: int, x2: int, y2: int, color: int) -> None:
        """A thick solid line."""
        for strand in lines.strands(x1, y1, x2, y2):
            self.line(*strand, color)
