"""What the window costs: `python -m bench monitor`, best on a real display.

Every number is measured from outside, at the public functions or by what the system says of the two
processes. Linux only.
"""

import ctypes
import ctypes.util
import itertools
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable

import bgi
from bgi import current
from bgi.machine import display_exists
from bgi.monitor import Window

FLIPS = 20_000


def report() -> None:
    """Print the table."""
    if sys.platform != "linux":
        print("the window is measured on Linux only")
        return
    os.environ["BGI_MONITOR"] = "window"
    if not display_exists():
        os.environ["SDL_VIDEODRIVER"] = "dummy"
    row("import bgi", seconds_of("import bgi") * 1000, "ms")
    row("start-up to the first picture", statistics.median(starts(5)) * 1000, "ms")
    with_window(idle)
    with_window(answers)
    with_window(pace)
    with_window(loops)
    os.environ["BGI_RATE"] = "1000000"  # as fast as can be
    presents()
    with_window(memory)
    del os.environ["BGI_RATE"]


def row(name: str, value: float, unit: str) -> None:
    """Print one line."""
    print(f"{name:44}{value:10.2f} {unit}", flush=True)


def with_window(measure: Callable[[], None]) -> None:
    """Measure with a fresh window of 640 x 480."""
    bgi.initgraph(bgi.VGA, bgi.VGAHI)
    measure()
    bgi.closegraph()


def window() -> Window:
    """The current window."""
    monitor = current.screen.monitor
    assert isinstance(monitor, Window)
    return monitor


def processes() -> dict[str, int]:
    """The two processes, by what they are called in the table."""
    return {"program": os.getpid(), "window": window().pid}


def used(pid: int) -> float:
    """Seconds of processor time that a process has used."""
    if sys.platform == "win32":
        raise OSError("there is no /proc")
    with open(f"/proc/{pid}/stat", encoding="ascii") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def resident(pid: int) -> float:
    """Megabytes of memory that a process uses."""
    with open(f"/proc/{pid}/status", encoding="ascii") as file:
        return int(next(line for line in file if line.startswith("VmRSS")).split()[1]) / 1024


def seconds_of(source: str) -> float:
    """How long a fresh Python takes for a program, at best, without what it takes for none."""

    def best(program: str) -> float:
        times = []
        for _ in range(5):
            begin = time.perf_counter()
            subprocess.run([sys.executable, "-c", program], check=True)
            times.append(time.perf_counter() - begin)
        return min(times)

    return best(source) - best("")


def starts(times: int) -> list[float]:
    """Seconds from initgraph() to a picture in the window, again and again."""
    found = []
    for _ in range(times):
        begin = time.perf_counter()
        bgi.initgraph(bgi.VGA, bgi.VGAHI)
        bgi.circle(320, 240, 100)
        window().show()
        found.append(time.perf_counter() - begin)
        bgi.closegraph()
    return found


def idle(seconds: float = 5) -> None:
    """Processor time of both while the program waits in getch()."""
    bgi.circle(320, 240, 100)
    time.sleep(2)
    before = {name: used(pid) for name, pid in processes().items()}
    window().keys.wait(seconds)
    for name, pid in processes().items():
        row(f"idle in getch(): {name}", 100 * (used(pid) - before[name]) / seconds, "% of a core")


def answers() -> None:
    """Milliseconds from a key to the program, where X can be told to press one."""
    names = [ctypes.util.find_library(name) for name in ("X11", "Xtst")]
    if not all(names) or not os.environ.get("DISPLAY"):
        print("key to program: needs X11 and its test extension")
        return
    x11, test = (ctypes.CDLL(name) for name in names)
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = ctypes.c_void_p(x11.XOpenDisplay(None))
    number = subprocess.run(
        ["xdotool", "search", "--onlyvisible", "--pid", str(window().pid)],
        capture_output=True,
        timeout=10,
    ).stdout.split()[-1]
    subprocess.run(["xdotool", "windowfocus", number], timeout=10, check=True)
    code = x11.XKeysymToKeycode(display, ctypes.c_ulong(ord("a")))
    for name, pause in (("key to program, in a dialogue", 0.2), ("key to program, long idle", 1.5)):
        delays = []
        for _ in range(10):
            time.sleep(pause)
            test.XTestFakeKeyEvent(display, code, 1, ctypes.c_ulong(0))
            test.XTestFakeKeyEvent(display, code, 0, ctypes.c_ulong(0))
            begin = time.perf_counter()
            x11.XFlush(display)
            bgi.getch()
            delays.append(time.perf_counter() - begin)
        row(name, statistics.median(delays) * 1000, "ms")
    x11.XCloseDisplay(display)


def pace(pictures: int = 240) -> None:
    """How regularly swapbuffers() returns."""
    moments = []
    for number in range(pictures):
        bgi.cleardevice()
        bgi.bar(number, 100, number + 50, 200)
        bgi.swapbuffers()
        moments.append(time.perf_counter())
    gaps = [1000 * (b - a) for a, b in itertools.pairwise(moments[20:])]
    row("swapbuffers(), a second", 1000 / statistics.mean(gaps), "pictures")
    row("  from one to the next, standard deviation", statistics.stdev(gaps), "ms")


def loops(seconds: float = 2) -> None:
    """What kbhit() does to a loop that only asks, and to one that draws."""
    before, end = time.process_time(), time.monotonic() + seconds
    while time.monotonic() < end:
        for _ in range(100):
            bgi.kbhit()
    row("while not kbhit(): pass", 100 * (time.process_time() - before) / seconds, "% of a core")
    times = {}
    for name, ask in (("with", bgi.kbhit), ("without", lambda: 0)):
        begin = time.perf_counter()
        for number in range(200_000):
            ask()
            bgi.putpixel(number % 640, number // 640 % 480, number % 15 + 1)
        times[name] = (time.perf_counter() - begin) / 200_000 * 1e6
    row("kbhit() and putpixel()", times["with"], "us")
    row("  putpixel() alone", times["without"], "us")


def presents() -> None:
    """Milliseconds for one picture in several sizes, everything between two calls included."""
    openings: list[tuple[str, Callable[[], object]]] = [
        ("320x200", lambda: bgi.initgraph(bgi.CGA, bgi.CGAC0)),
        ("640x480", lambda: bgi.initgraph(bgi.VGA, bgi.VGAHI)),
        ("1024x768", lambda: bgi.initgraph(bgi.IBM8514, bgi.IBM8514HI)),
        ("640x480, 32 bits", lambda: bgi.initwindow(640, 480)),
        ("1000x700, 32 bits", lambda: bgi.initwindow(1000, 700)),
    ]
    for name, opening in openings:
        opening()
        for warming in (20, 300):
            begin = time.perf_counter()
            for number in range(warming):
                bgi.putpixel(number, 7, number % 3 + 1)
                window().show()
            cost = (time.perf_counter() - begin) / warming
        row(f"a picture of {name}", cost * 1000, "ms")
        bgi.closegraph()


def memory(flips: int = FLIPS) -> None:
    """What many flips leave behind, in memory and open files."""

    def state() -> dict[str, tuple[float, int]]:
        return {
            name: (resident(pid), len(os.listdir(f"/proc/{pid}/fd")))
            for name, pid in processes().items()
        }

    for number in range(1000):
        flip(number)
    before, begin = state(), time.perf_counter()
    for number in range(flips):
        flip(number)
    row(f"{flips} flips, as fast as can be", flips / (time.perf_counter() - begin), "a second")
    for name, (megabytes, files) in state().items():
        row(f"  {name}: memory", megabytes - before[name][0], "MB more")
        row(f"  {name}: open files", files - before[name][1], "more")


def flip(number: int) -> None:
    """One picture of an animation."""
    bgi.putpixel(number % 640, number // 640 % 480, number % 16)
    bgi.swapbuffers()
