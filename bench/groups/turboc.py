"""C programs: how long one is compiled, and how fast it runs beside the same in Python."""

import random
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from bench.timing import OURS, Row, Task
from bgi import VGA, VGAHI, closegraph, initgraph, putpixel
from bgi.turboc.running import Runnable
from bgi.turboc.runtime.session import Session

PYTHON = "Python"
"""The peer: the same program, written in Python by hand."""

PIXELS = """
#include <graphics.h>

void main()
{
    int gd = VGA, gm = VGAHI, x, y, color;
    long sum = 0;

    initgraph(&gd, &gm, "");
    for (y = 0; y < 100; y++)
        for (x = 0; x < 320; x++) {
            color = (x * 3 + y * 5) / 8 % 16;
            putpixel(x, y, color);
            sum += color;
        }
    closegraph();
}
"""

SIEVE = """
#include <graphics.h>

int prime[8191];

int count()
{
    int i, k, found = 0;

    for (i = 0; i <= 8190; i++)
        prime[i] = 1;
    for (i = 0; i <= 8190; i++)
        if (prime[i]) {
            for (k = i + i + 3; k <= 8190; k += i + i + 3)
                prime[k] = 0;
            found++;
        }
    return found;
}

void main() { count(); }
"""


def pixels() -> None:
    """PIXELS in Python."""
    initgraph(VGA, VGAHI)
    total = 0
    for y in range(100):
        for x in range(320):
            color = (x * 3 + y * 5) // 8 % 16
            putpixel(x, y, color)
            total += color
    closegraph()


def sieve() -> None:
    """SIEVE in Python."""
    prime = [1] * 8191
    found = 0
    for i in range(8191):
        if prime[i]:
            for k in range(i + i + 3, 8191, i + i + 3):
                prime[k] = 0
            found += 1


FUNCTION = """
int draw{number}(int x, int y)
{{
    int i, *p = &x, color = {color};
    struct place here;

    here.x = x;
    here.y = y;
    for (i = 0; i < {times}; i++) {{
        setcolor((color + i) % 16);
        if (here.x > getmaxx() / 2 && i % 3 == 0)
            line(here.x, here.y, x + i * 3, y - {color});
        else {{
            circle(x + 5, y, i + 2);
            points[i % 50].x += *p;
        }}
    }}
    switch (color) {{
    case 1: outtextxy(x, y, "one"); break;
    default: sprintf(text, "%d of %d", i, color); outtextxy(x, y, text);
    }}
    return here.x * 2 + points[3].y;
}}
"""


@cache
def thousand_lines() -> str:
    """A program of 1,000 lines."""
    chance = random.Random(1)
    text = "#include <graphics.h>\n#include <stdio.h>\n\nstruct place { int x, y; } points[50];\n"
    text += "char text[80];\n"
    number = 0
    while text.count("\n") < 960:
        text += FUNCTION.format(number=number, color=chance.randrange(16), times=number + 3)
        number += 1
    calls = "".join(f"    draw{each}({each}, {each + 5});\n" for each in range(number))
    return f"{text}\nvoid main()\n{{\n{calls}}}\n"


def read(text: str) -> Runnable:
    """A program from its text."""
    with TemporaryDirectory() as folder:
        file = Path(folder) / "PROGRAM.C"
        file.write_text(text, "ascii")
        return Runnable(str(file), {})


def compiling(_: int) -> float:
    """The thread's time from the text to something that runs."""
    text = thousand_lines()
    start = time.thread_time()
    read(text)
    return time.thread_time() - start


def running(text: str) -> Task:
    """The thread's time for a whole run of a program."""
    names: dict[str, Any] = read(text).load(Session())
    return timed(names["main"])


def timed(program: Callable[[], object]) -> Task:
    """The thread's time for a call."""

    def measured(_: int) -> float:
        start = time.thread_time()
        program()
        return time.thread_time() - start

    return measured


def rows() -> list[Row]:
    """The rows of this group."""
    return [
        Row("turboc", "C: 1,000 lines compiled", {OURS: compiling}),
        Row("turboc", "C: putpixel and arithmetic", {OURS: running(PIXELS), PYTHON: timed(pixels)}),
        Row("turboc", "C: sieve", {OURS: running(SIEVE), PYTHON: timed(sieve)}),
    ]
