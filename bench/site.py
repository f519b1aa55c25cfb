"""What the site costs, in which Python runs in the page: `python -m bench site`.

A headless Chromium visits it, from a server on this machine.
"""

import contextlib
import time
from pathlib import Path
from tempfile import TemporaryDirectory

from bench.monitor import row
from tools import chromium
from tools.chromium import Browser
from tools.pyodide import parts
from tools.site.build import build
from tools.site.visit import BEGIN, LOADED, printed, run, served, visit, wait

SECONDS = 3
TIMED = f"""{BEGIN}
from time import perf_counter
count, end = 0, perf_counter() + {SECONDS}
while perf_counter() < end:
    %s
print(count / {SECONDS})
"""
RATES = {
    "swapbuffers": ("cleardevice(); swapbuffers(); count += 1", "a second"),
    "putpixel, a thousand at a time": (
        "for x in range(1000): putpixel(x % 640, x % 480, x % 16)\n    count += 1000",
        "a second",
    ),
    "kbhit": ("kbhit(); count += 1", "a second"),
}
NATURE = {True: "memory is shared", False: "Python is suspended"}


def report() -> None:
    """Print the table."""
    found = chromium.program()
    if found is None:
        print("the site is measured with Chromium")
        return
    with TemporaryDirectory() as folder, chromium.running(found) as browser:
        try:
            size = build(Path(folder) / "site", parts.wheel(parts.NUMPY))
        except parts.Missing as error:
            print(error)
            return
        row("a first visit loads, packed by no host", size / 1e6, "MB")
        for shared in NATURE:
            print(f"\n{NATURE[shared]}:")
            with served(Path(folder) / "site", service_worker=shared) as address:
                visits(browser, address, shared)


def visits(browser: Browser, address: str, shared: bool) -> None:
    """The first visit, the second one, and what programs do there."""
    for name in ("first", "second"):
        began = time.perf_counter()
        tab = visit(browser, address, shared)
        wait(tab, LOADED)
        row(f"{name} visit, until programs can run", time.perf_counter() - began, "s")
        began = time.perf_counter()
        run(tab, f"{BEGIN}circle(320, 240, 100)\nswapbuffers()\n")
        printed(tab)
        row("  from Run to the first picture shown", time.perf_counter() - began, "s")
        if name == "first":
            tab.close()
    for name, (body, unit) in RATES.items():
        run(tab, TIMED % body)
        with contextlib.suppress(ValueError):
            row(name, float(printed(tab)), unit)
    tab.close()
