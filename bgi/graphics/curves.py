"""Circles, ellipses, arcs, pies."""

from __future__ import annotations

import numpy as np

from bgi.constants import grError
from bgi.graphics.pen import Pen
from bgi.kernel.arguments import Number, Numbers, whole
from bgi.kernel.state import KERNEL
from bgi.raster import ellipses, polygons, slices
from bgi.raster.ellipses import CURVES, THICK_CURVES
from bgi.raster.patterns import EMPTY_ROWS, SOLID
from bgi.raster.regions import FigureRows
from bgi.raster.slices import DISCS, PIECES, REGIONS
from bgi.settings import arccoordstype


class Curves(Pen):
    """A screen to draw curves on."""

    def setaspectratio(self, xasp: Number, yasp: Number) -> None:
        """Set the aspect ratio of circles; -11 unless yasp is greater than 0 and xasp not less."""
        ratio = whole("xasp", xasp), whole("yasp", yasp)
        if ratio[0] < 0 or ratio[1] <= 0:
            KERNEL.result.set(grError)
        else:
            self.aspect = ratio

    def getaspectratio(self) -> tuple[int, int]:
        """The aspect ratio of circles."""
        return self.aspect

    def getarccoords(self) -> arccoordstype:
        """Centre of the last curve, and the ends of the last one that set them."""
        x, y, start, end, rx, ry = KERNEL.arc
        (x1, y1), (x2, y2) = ellipses.point_at(start, rx, ry), ellipses.point_at(end, rx, ry)
        return arccoordstype(x, y, x + x1, y + y1, x + x2, y + y2)

    # Outlines

    def circle(self, x: Numbers, y: Numbers, radius: Numbers, color: Numbers | None = None) -> None:
        """Draw circles, round on a screen of the mode's aspect ratio."""
        if type(x) is int and type(y) is int and type(radius) is int and color is None:
            xasp, yasp = self.aspect
            ry = radius * xasp // yasp
            if self._thick:
                self._elliptic_arc(x, y, 0, 360, radius, ry)
            else:
                KERNEL.arc = x, y, 0, 360, radius, ry
                page, cx, cy, ink = self.page, x + self._dx, y + self._dy, self._curve_ink
                curve = CURVES[0, 360, radius, ry, page.width]
                if not page.put_offsets(cx, cy, curve.pixels, ink, False):
                    page.put_cut(cx, cy, curve, ink)
        else:
            self._each(self.circle, x=x, y=y, radius=radius, color=color)

    def arc(
        self,
        x: Numbers,
        y: Numbers,
        stangle: Numbers,
        endangle: Numbers,
        radius: Numbers,
        color: Numbers | None = None,
    ) -> None:
        """Draw a part of a circle."""
        if (
            type(x) is int
            and type(y) is int
            and type(stangle) is int
            and type(endangle) is int
            and type(radius) is int
            and color is None
        ):
            self._arc(x, y, stangle, endangle, radius)
            return
        self._each(
            self._arc, x=x, y=y, stangle=stangle, endangle=endangle, radius=radius, color=color
        )

    def _arc(self, x: int, y: int, start: int, end: int, radius: int) -> None:
        xasp, yasp = self.aspect
        self._elliptic_arc(x, y, start, end, radius, radius * xasp // yasp)

    def ellipse(
        self,
        x: Numbers,
        y: Numbers,
        stangle: Numbers,
        endangle: Numbers,
        xradius: Numbers,
        yradius: Numbers,
        color: Numbers | None = None,
    ) -> None:
        """Draw an ellipse or a part of one."""
        if (
            type(x) is int
            and type(y) is int
            and type(stangle) is int
            and type(endangle) is int
            and type(xradius) is int
            and type(yradius) is int
            and color is None
        ):
            self._elliptic_arc(x, y, stangle, endangle, xradius, yradius)
            return
        self._each(
            self._elliptic_arc,
            x=x,
            y=y,
            stangle=stangle,
            endangle=endangle,
            xradius=xradius,
            yradius=yradius,
            color=color,
        )

    def _elliptic_arc(self, x: int, y: int, start: int, end: int, rx: int, ry: int) -> None:
        """From angle to angle; a thin curve ignores line style and write mode."""
        if start == -1:  # which is how the kernel says that there is no arc
            return
        cx, cy, ends = x + self._dx, y + self._dy, KERNEL.arc[2:]
        if self._thick:
            self._thick_arc(cx, cy, start, end, rx, ry)
        elif start != end:
            ends = start, end, rx, ry
            curve = CURVES.get((start, end, rx, ry, self.page.width))
            if curve is None:
                self._new_curve(cx, cy, start, end, rx, ry)
            else:
                self.page.curve(cx, cy, curve, self._curve_ink)
        KERNEL.arc = x, y, *ends

    def _new_curve(self, x: int, y: int, start: int, end: int, rx: int, ry: int) -> None:
        """A thin curve around an absolute point that is not kept yet.

        To keep one takes longer than to draw it: a whole one is kept when it is met again.
        """
        page, ink = self.page, self._curve_ink
        key = start, end, rx, ry, page.width
        curve = CURVES.again(*key)
        if curve is not None:
            page.curve(x, y, curve, ink)
        elif (start, end) == (0, 360):
            page.put_mirrored(x, y, ellipses.quadrant(rx, ry), ink)
        else:
            page.curve(x, y, CURVES[key], ink)

    def _thick_arc(self, x: int, y: int, start: int, end: int, rx: int, ry: int) -> None:
        """Lines from degree to degree around an absolute point; they know the write mode."""
        if not ellipses.drawable(rx, ry):
            return
        if self._wide:
            for side in np.stack(ellipses.thick_sides(start, end, rx, ry), axis=-1).tolist():
                x1, y1, x2, y2 = side
                for strand in self._strands(x + x1, y + y1, x + x2, y + y2):
                    self.page.styled_line(*strand, self._ink, SOLID, self._xor)
            return
        page, color, xor = self.page, self._ink, self._xor
        around = x - rx - 2, y - ry - 2, x + rx + 2, y + ry + 2
        if ellipses.is_fine(rx, ry) or page.holds(*around):
            figure = THICK_CURVES[start, end, rx, ry, xor, page.trace, page.width]
            if not page.put_offsets(x, y, figure, color, xor):
                page.put_seen(x, y, figure, color, xor)
        elif page.meets(*around):
            x1, y1, x2, y2 = ellipses.thick_sides(start, end, rx, ry)
            page.thick_lines((x + x1, y + y1, x + x2, y + y2), color, xor)

    # Filled

    def fillellipse(self, x: Numbers, y: Numbers, xradius: Numbers, yradius: Numbers) -> None:
        """Fill an ellipse and draw its outline."""
        self._each(self._fillellipse, x=x, y=y, xradius=xradius, yradius=yradius)

    def _fillellipse(self, x: int, y: int, rx: int, ry: int) -> None:
        cx, cy = x + self._dx, y + self._dy
        self._fill_curve(cx, cy, 0, 360, rx, ry, DISCS[rx, ry])
        self._elliptic_arc(x, y, 0, 360, rx, ry)

    def _fill_curve(
        self, x: int, y: int, first: int, last: int, rx: int, ry: int, rows: FigureRows
    ) -> None:
        """What a piece of an ellipse encloses, or all of one, around an absolute point."""
        page, ink, pattern = self.page, self._fill_ink, self._fill_rows
        kept = REGIONS.again(first, last, rx, ry, page.width)
        if kept is None or not page.fill_region(x, y, kept, ink, pattern):
            page.fill_figure(x, y, rows, ink, pattern)

    def pieslice(
        self, x: Numbers, y: Numbers, stangle: Numbers, endangle: Numbers, radius: Numbers
    ) -> None:
        """Fill a slice of a circle and draw its outline."""
        self._each(self._pieslice, x=x, y=y, stangle=stangle, endangle=endangle, radius=radius)

    def _pieslice(self, x: int, y: int, start: int, end: int, radius: int) -> None:
        xasp, yasp = self.aspect
        self._sector(x, y, start, end, radius, radius * xasp // yasp)

    def sector(
        self,
        x: Numbers,
        y: Numbers,
        stangle: Numbers,
        endangle: Numbers,
        xradius: Numbers,
        yradius: Numbers,
    ) -> None:
        """Fill a slice of an ellipse and draw its outline."""
        self._each(
            self._sector,
            x=x,
            y=y,
            stangle=stangle,
            endangle=endangle,
            xradius=xradius,
            yradius=yradius,
        )

    def _sector(self, x: int, y: int, start: int, end: int, rx: int, ry: int) -> None:
        """Quadrant by quadrant: each piece's area, then its arc; the two radii at the end."""
        start, end = slices.slice_angles(start, end)
        KERNEL.arc = (x, y, start, end, rx, ry) if start < end else (x, y, 0, 0, 0, 0)
        if not ellipses.drawable(rx, ry):
            return
        cx, cy, color = x + self._dx, y + self._dy, self._ink
        for first, last in slices.quarters(start, end):
            piece = PIECES[first, last, rx, ry, self.page.width]
            if self._fill_rows != EMPTY_ROWS:  # which leaves a polygon's interior alone
                self._fill_curve(cx, cy, first, last, rx, ry, piece.rows)
            if self._plain and piece.smooth:
                self.page.curve(cx, cy, piece.edge, color)
            else:
                corners = zip(piece.edge.dx.tolist(), piece.edge.dy.tolist(), strict=True)
                shifted = [(cx + dx, cy + dy) for dx, dy in corners]
                self._outline(polygons.paths(shifted), color)
        for angle in (start, end):  # without an angle between them both radii are a dot
            ex, ey = ellipses.point_at(angle, rx, ry) if start < end else (0, 0)
            self._segment(cx, cy, cx + ex, cy + ey, color)
