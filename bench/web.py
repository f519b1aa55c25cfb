"""What the web monitor costs: `python -m bench web`, with a headless Chromium that looks.

Pictures are counted where the page has painted them, and a key's time runs in the page, too: from
the key to the pixel that the program changes because of it. Linux only.
"""

import os
import re
import statistics
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager

from bench.monitor import row, used
from tools import chromium
from tools.chromium import Browser, Tab

SECONDS = 4.0
KEYS = 60

BALL = """
from bgi import *
initgraph(VGA, VGAHI)
setfillstyle(SOLID_FILL, LIGHTRED)
x, y, dx, dy = 100, 100, 7, 5
while True:
    cleardevice()
    rectangle(0, 0, 639, 479)
    fillellipse(x, y, 20, 20)
    dx = -dx if not 20 < x + dx < 619 else dx
    dy = -dy if not 20 < y + dy < 459 else dy
    x, y = x + dx, y + dy
    swapbuffers()
"""
SURFACE = """
from bgi import *
from surfaces import rotation, surface
initgraph(VGA, VGAHI)
turn = 0.0
while True:
    cleardevice()
    surface("sin(x*y)", n=40, mode="fill+mesh", transform=rotation("z", turn))
    turn += 0.05
    swapbuffers()
"""
TEXT = """
from bgi.conio import *
from bgi.dos import delay
clrscr()
number = 0
while True:
    cprintf("line %d of what a program writes\\r\\n", number)
    number += 1
    delay(16)
"""
PALETTE = """
from bgi import *
initgraph(VGA, VGAHI)
for number in range(480):
    setcolor(number % 15 + 1)
    line(0, number, 639, number)
number = 0
while True:
    setpalette(number % 15 + 1, number % 63 + 1)
    number += 1
    delay(16)
"""
NOISE = """
import numpy as np
from bgi import *
from bgi import current
initgraph(VGA, VGAHI)
pictures = np.random.default_rng(1).integers(0, 16, (8, 480, 640), np.uint8)
number = 0
while True:
    current.screen.page.array[:] = pictures[number % 8]
    number += 1
    swapbuffers()
"""
PIXELS = """
from bgi import *
initgraph(VGA, VGAHI)
number = 0
while True:
    number += 1
    putpixel(number % 640, number // 640 % 480, number // 1000 % 16)
"""
ECHO = """
from bgi import *
initgraph(VGA, VGAHI)
color = 0
while True:
    getch()
    color = 15 - color
    putpixel(0, 0, color)
"""
PROGRAMS = {
    "a bouncing ball": BALL,
    "a surface that turns": SURFACE,
    "a text that scrolls": TEXT,
    "a palette that cycles": PALETTE,
    "noise on the whole screen": NOISE,
    "putpixel without a pause": PIXELS,
}

# A picture is on the page when it says so; then the time since the last key is noted, if the pixel
# in the corner has changed.
COUNTING = """
window.painted = 0;
window.waits = [];
let pressed = 0, before = 0;
addEventListener("keydown", () => (pressed = performance.now()), true);
const send = WebSocket.prototype.send;
WebSocket.prototype.send = function (message) {
  send.call(this, message);
  if (message !== "shown") return;
  window.painted++;
  if (!pressed) return;
  const canvas = document.getElementById("screen");
  const now = canvas.getContext("2d").getImageData(0, 0, 1, 1).data[0];
  if (now === before) return;
  window.waits.push(performance.now() - pressed);
  [pressed, before] = [0, now];
};
"""


def report() -> None:
    """Print the table."""
    found = chromium.program()
    if sys.platform != "linux" or found is None:
        print("the web monitor is measured on Linux, with Chromium")
        return
    with chromium.running(found) as browser:
        for name, source in PROGRAMS.items():
            with seen(browser, source) as (program, tab):
                pictures(name, program, tab)
        with seen(browser, ECHO) as (_, tab):
            keys(tab)


@contextmanager
def seen(browser: Browser, source: str) -> Iterator[tuple[subprocess.Popen[str], Tab]]:
    """A program, and a page that looks at it."""
    program = subprocess.Popen(
        [sys.executable, "-c", source],
        env=os.environ | {"BGI_MONITOR": "web"},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        assert program.stderr
        found = re.search(r"http\S+", program.stderr.readline())
        assert found
        tab = browser.tab()
        tab.call("Page.addScriptToEvaluateOnNewDocument", source=COUNTING)
        tab.go(found[0])
        tab.wait_for("window.painted > 0")
        yield program, tab
        tab.close()
    finally:
        program.kill()
        program.communicate()


def pictures(name: str, program: subprocess.Popen[str], tab: Tab) -> None:
    """Pictures a second, and what the process between takes for one."""
    time.sleep(1)
    child = int(subprocess.check_output(["pgrep", "-P", str(program.pid)]))
    painted, begin, busy = tab.evaluate("painted"), time.perf_counter(), used(child)
    time.sleep(SECONDS)
    painted = tab.evaluate("painted") - painted
    seconds, busy = time.perf_counter() - begin, used(child) - busy
    row(name, painted / seconds, "pictures a second")
    row("  each takes the monitor's process", 1000 * busy / painted, "ms")


def keys(tab: Tab) -> None:
    """Milliseconds from a key to the pixel that it changes."""
    for number in range(KEYS):
        tab.press("a", "KeyA")
        tab.wait_for(f"waits.length > {number}")
        time.sleep(0.05 + number % 7 / 300)
    waits = sorted(tab.evaluate("waits"))
    row("from a key to its pixel", statistics.median(waits), "ms")
    row("  of ten the slowest", waits[len(waits) * 9 // 10], "ms")
