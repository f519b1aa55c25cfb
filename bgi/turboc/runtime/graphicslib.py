"""graphics.h: the functions of this library, as C calls them."""

from __future__ import annotations

from typing import Any

import bgi
from bgi import current
from bgi.turboc.runtime.binding import Function, characters, string
from bgi.turboc.runtime.memory import Pointer
from bgi.turboc.runtime.session import Session

DIRECT = """
void putpixel(int x, int y, long color); unsigned getpixel(int x, int y);
void line(int x1, int y1, int x2, int y2); void lineto(int x, int y); void linerel(int x, int y);
void moveto(int x, int y); void moverel(int x, int y); int getx(void); int gety(void);
void rectangle(int x1, int y1, int x2, int y2); void bar(int x1, int y1, int x2, int y2);
void bar3d(int x1, int y1, int x2, int y2, int depth, int top); void circle(int x, int y, int r);
void arc(int x, int y, int start, int end, int r); int getmaxx(void); int getmaxy(void);
void ellipse(int x, int y, int start, int end, int rx, int ry);
void fillellipse(int x, int y, int rx, int ry);
void pieslice(int x, int y, int start, int end, int r);
void sector(int x, int y, int start, int end, int rx, int ry);
void floodfill(int x, int y, long border); void cleardevice(void); void clearviewport(void);
void setviewport(int l, int t, int r, int b, int clip); int getmaxcolor(void);
void setcolor(long color); int getcolor(void); void setbkcolor(long color); int getbkcolor(void);
void setpalette(int number, int color); int getpalettesize(void);
void setrgbpalette(int number, int red, int green, int blue);
void setlinestyle(int style, unsigned pattern, int width); void setwritemode(int mode);
void setfillstyle(int pattern, long color); void setaspectratio(int x, int y);
void setactivepage(int page); void setvisualpage(int page); void outtext(text s);
void outtextxy(int x, int y, text s); void settextjustify(int h, int v);
void settextstyle(int font, int direction, int size); int textwidth(text s);
void setusercharsize(int mx, int dx, int my, int dy); int textheight(text s);
void closegraph(void); void setgraphmode(int mode);
int getgraphmode(void); int getmaxmode(void); void graphdefaults(void); int graphresult(void);
unsigned imagesize(int l, int t, int r, int b); unsigned setgraphbufsize(unsigned size);
"""
"""Those that C and Python call alike."""

OTHERS = """
void restorecrtmode(void);
void initgraph(int *gd, int *gm, text path); void detectgraph(int *gd, int *gm);
void getmoderange(int driver, int *low, int *high); char *getmodename(int mode);
char *getdrivername(void); char *grapherrormsg(int code); void getaspectratio(int *x, int *y);
void drawpoly(int n, int *points); void fillpoly(int n, int *points);
void setfillpattern(char *pattern, int color); void getfillpattern(char *pattern);
void getimage(int l, int t, int r, int b, void *image);
void putimage(int x, int y, void *image, int op); int registerbgidriver(void *driver);
int registerbgifont(void *font); int registerfarbgidriver(void *driver);
int registerfarbgifont(void *font);
void getviewsettings(viewporttype *to); void getlinesettings(linesettingstype *to);
void getfillsettings(fillsettingstype *to); void gettextsettings(textsettingstype *to);
void getarccoords(arccoordstype *to); void getpalette(palettetype *to);
palettetype *getdefaultpalette(void); void setallpalette(palettetype *palette);
int installuserdriver(text name, void *detect); int installuserfont(text name);
"""
"""Those that answer through pointers, or take arrays."""

TYPES = {
    "viewporttype": "struct @ { int left, top, right, bottom, clip; };",
    "linesettingstype": "struct @ { int linestyle; unsigned upattern; int thickness; };",
    "fillsettingstype": "struct @ { int pattern, color; };",
    "textsettingstype": "struct @ { int font, direction, charsize, horiz, vert; };",
    "arccoordstype": "struct @ { int x, y, xstart, ystart, xend, yend; };",
    "pointtype": "struct @ { int x, y; };",
    "palettetype": "struct @ { unsigned char size; signed char colors[16]; };",
}


def store(pointers: tuple[Any, ...], values: tuple[Any, ...]) -> None:
    """Store answers where pointers point."""
    for pointer, value in zip(pointers, values, strict=True):
        pointer.memory[pointer.at] = value


class GraphicsLibrary:
    """The functions of OTHERS for one program."""

    def __init__(self, program: Session, palette: Any) -> None:
        """
        Args:
            program: the program.
            palette: the class of palettetype.
        """
        self._trace = program.trace
        self._default = Pointer([palette()])

    def _note(self, name: str, given: tuple[Any, ...] = (), answer: Any = ...) -> None:
        if self._trace:
            self._trace.call(name, given, answer)

    def initgraph(self, gd: Pointer, gm: Pointer, path: Any) -> None:
        """The mode is not looked at where the driver is to be found out."""
        driver, where = gd.memory[gd.at], characters(path) if path is not None else b""
        mode = gm.memory[gm.at] if driver else 0
        answer = bgi.initgraph(driver, mode, where.decode("cp437"))
        store((gd, gm), answer)
        self._note("initgraph", (driver, mode, where), answer)

    def restorecrtmode(self) -> None:
        """Where there are no graphics, behind closegraph(), nothing happens."""
        self._note("restorecrtmode")
        if current.loaded() is not None:
            bgi.restorecrtmode()

    def detectgraph(self, gd: Pointer, gm: Pointer) -> None:
        answer = bgi.detectgraph()
        store((gd, gm), answer)
        self._note("detectgraph", (), answer)

    def getmoderange(self, driver: int, low: Pointer, high: Pointer) -> None:
        answer = bgi.getmoderange(driver)
        store((low, high), answer)
        self._note("getmoderange", (driver,), answer)

    def getaspectratio(self, x: Pointer, y: Pointer) -> None:
        answer = bgi.getaspectratio()
        store((x, y), answer)
        self._note("getaspectratio", (), answer)

    def getmodename(self, mode: int) -> Pointer:
        name = bgi.getmodename(mode) or ""
        self._note("getmodename", (mode,), name.encode())
        return string(name)

    def getdrivername(self) -> Pointer:
        name = bgi.getdrivername()
        self._note("getdrivername", (), name.encode())
        return string(name)

    def grapherrormsg(self, code: int) -> Pointer:
        message = bgi.grapherrormsg(code)
        self._note("grapherrormsg", (code,), message.encode())
        return string(message)

    def drawpoly(self, n: int, points: Pointer) -> None:
        self._poly("drawpoly", n, points)

    def fillpoly(self, n: int, points: Pointer) -> None:
        self._poly("fillpoly", n, points)

    def _poly(self, name: str, n: int, points: Pointer) -> None:
        flat = list(points.memory[points.at : points.at + 2 * max(n, 0)])
        flat += [0] * (2 * max(n, 0) - len(flat))  # what lies behind an array that is too short
        if n > 0:
            getattr(bgi, name)(n, flat)
        self._note(name, (n, *flat))

    def setfillpattern(self, pattern: Pointer, color: int) -> None:
        rows = [pattern.memory[pattern.at + row] & 0xFF for row in range(8)]
        bgi.setfillpattern(bytes(rows), color)
        self._note("setfillpattern", (*[(row ^ 0x80) - 0x80 for row in rows], color))

    def getfillpattern(self, pattern: Pointer) -> None:
        pattern.memory[pattern.at : pattern.at + 8] = bgi.getfillpattern()
        self._note("getfillpattern")

    # Palettes

    def getpalette(self, to: Pointer) -> None:
        self._note("getpalette")
        _keep(bgi.getpalette(), to)

    def getdefaultpalette(self) -> Pointer:
        self._note("getdefaultpalette")
        _keep(bgi.getdefaultpalette(), self._default)
        return self._default

    def setallpalette(self, palette: Pointer) -> None:
        self._note("setallpalette")
        given = palette.memory[palette.at]
        bgi.setallpalette([(color ^ 0x80) - 0x80 for color in given.colors[: given.size]])

    # Drivers and fonts

    def installuserdriver(self, name: Any, detect: Any) -> int:
        written = characters(name)
        number = bgi.installuserdriver(written.decode("cp437"), detect)
        self._note("installuserdriver", (written,), number)
        return number

    def installuserfont(self, name: Any) -> int:
        written = characters(name)
        number = bgi.installuserfont(written.decode("cp437"))
        self._note("installuserfont", (written,), number)
        return number

    def getimage(self, left: int, top: int, right: int, bottom: int, image: Any) -> None:
        """A memory of characters gets Borland's bytes; others hold the picture itself."""
        if image is not None:
            picture = bgi.getimage(left, top, right, bottom)
            if isinstance(image.memory, bytearray):
                data = bytes(picture)
                if image.at + len(data) > len(image.memory):
                    raise IndexError(image.at + len(data))
                image.memory[image.at : image.at + len(data)] = data
            else:
                image.memory[image.at] = picture
        self._note("getimage", (left, top, right, bottom))

    def putimage(self, x: int, y: int, image: Any, op: int) -> None:
        if image is not None:
            memory = image.memory
            if isinstance(memory, bytearray):
                bgi.putimage(x, y, bytes(memory[image.at :]), op)
            elif isinstance(memory[image.at], bgi.Image):
                bgi.putimage(x, y, memory[image.at], op)
        self._note("putimage", (x, y, op))

    def registerbgidriver(self, driver: Any) -> int:
        self._note("registerbgidriver", (), 0)
        return 0

    def registerbgifont(self, font: Any) -> int:
        self._note("registerbgifont", (), 1)
        return 1

    registerfarbgidriver, registerfarbgifont = registerbgidriver, registerbgifont


def _keep(found: bgi.palettetype, to: Pointer) -> None:
    """Store a palette."""
    target = to.memory[to.at]
    target.size = found.size
    target.colors[: len(found.colors)] = bytes(color & 0xFF for color in found.colors[:16])


def _settings(name: str) -> Function:
    """A function that answers with a structure."""

    def call(self: GraphicsLibrary, to: Pointer) -> None:
        found = getattr(bgi, name)()
        target = to.memory[to.at]
        fields = target.MEMBERS
        values = tuple(getattr(found, field) for field in fields)
        for field, value in zip(fields, values, strict=True):
            setattr(target, field, int(value))
        self._note(name, (), values)

    return call


for _name in ("viewsettings", "linesettings", "fillsettings", "textsettings", "arccoords"):
    setattr(GraphicsLibrary, f"get{_name}", _settings(f"get{_name}"))
