"""The site in a headless Chromium: programs run in the page as they do at home.

Skipped in CI, without Chromium, and until `python -m tools.site` has fetched what it needs.
"""

import base64
import contextlib
import json
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from bgi.memory.imagefile import load
from bgi.monitor.lens import SIZE
from tests.skips import IN_CI
from tools import chromium, pictures
from tools.chromium import Browser, Tab
from tools.pyodide import parts
from tools.site.build import build
from tools.site.visit import BEGIN, CANVAS, ENDED, PRINTED, click, printed, run, served, visit, wait

pytestmark = pytest.mark.timeout(300)  # Python is loaded, on a machine that may be busy


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    if IN_CI or not parts.cached():
        pytest.skip("needs Pyodide")
    folder = tmp_path_factory.mktemp("site")
    build(folder, parts.wheel(parts.NUMPY))
    return folder


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    found = chromium.program()
    if IN_CI or found is None:
        pytest.skip("needs Chromium")
    with chromium.running(found) as browser:
        yield browser


@pytest.fixture(scope="module")
def address(site: Path) -> Iterator[str]:
    with served(site) as address:
        yield address


@pytest.fixture(scope="module")
def suspended_address(site: Path) -> Iterator[str]:
    """A host whose pages can have no service worker, and so no shared memory."""
    with served(site, service_worker=False) as address:
        yield address


@pytest.fixture(scope="module")
def tab(browser: Browser, address: str) -> Tab:
    """The gallery: programs follow one another in it."""
    return visit(browser, address)


def canvas(tab: Tab) -> NDArray[np.uint8]:
    """What is on the screen, shape (height, width, 3)."""
    width, height, data = tab.evaluate(
        f"""(() => {{
            const {{ width, height }} = {CANVAS};
            const {{ data }} = {CANVAS}.getContext("2d").getImageData(0, 0, width, height);
            let text = "";
            for (const byte of data) text += String.fromCharCode(byte);
            return [width, height, btoa(text)];
        }})()"""
    )
    pixels = np.frombuffer(base64.b64decode(data), np.uint8)
    return pixels.reshape(height, width, 4)[..., :3]


def same_in_time(tab: Tab, expected: NDArray[np.uint8]) -> bool:
    """Whether the screen shows that picture, now or soon."""
    deadline = time.monotonic() + chromium.PATIENCE
    while time.monotonic() < deadline:
        with contextlib.suppress(RuntimeError):  # there is no screen yet
            shown = canvas(tab)
            if shown.shape == expected.shape and (shown == expected).all():
                return True
        time.sleep(0.1)
    return False


@pytest.mark.parametrize("name", ["hello", "fonts", "PLOTTER.C"])
def test_a_demo_draws_its_picture_to_the_pixel(tab: Tab, name: str) -> None:
    """The pictures of the documentation are those that are drawn at home: tests/test_docs.py."""
    tab.evaluate(f"""document.querySelector('[data-demo="{name}"]').click()""")
    wait(tab, f"{CANVAS}?.width")
    assert same_in_time(tab, load(pictures.PICTURES / f"{name}.png").rgba[..., :3])
    click(tab, "stop")
    assert "Traceback" not in printed(tab)


def test_a_key_is_read(tab: Tab) -> None:
    run(tab, BEGIN + "print(getch())\nprint(getch(), getch())\n")
    wait(tab, f"{CANVAS}?.width === 640")
    tab.press("a", "KeyA")
    tab.press("ArrowUp", "ArrowUp")
    assert printed(tab) == "97\n0 72\n"


def test_stop_ends_a_busy_loop_and_the_next_program_runs(tab: Tab) -> None:
    run(tab, BEGIN + "print('begins')\nwhile True:\n    pass\n")
    wait(tab, f"{PRINTED} === 'begins\\n'")
    click(tab, "stop")
    assert printed(tab) == "begins\nStopped.\n"
    run(tab, "print(6 * 7)\n")
    wait(tab, f"{PRINTED} === '42\\n'")


def test_stop_ends_a_wait_for_a_key(tab: Tab) -> None:
    run(tab, BEGIN + "print('begins')\ngetch()\n")
    wait(tab, f"{PRINTED} === 'begins\\n'")
    click(tab, "stop")
    assert printed(tab) == "begins\nStopped.\n"


@pytest.mark.parametrize(
    ("program", "error", "line"),
    [
        (BEGIN + "circle(1, 2)\n", "TypeError", 3),
        (BEGIN + "\nif True\n", "SyntaxError", 4),
    ],
)
def test_an_error_is_shown_with_its_line(tab: Tab, program: str, error: str, line: int) -> None:
    run(tab, program)
    assert f"\n{error}: " in printed(tab)
    assert tab.evaluate("document.querySelector('.wrong').textContent") == f"{line}\n"


OF_1993 = """\
/* \u00e4 */
#include <graphics.h>
#include <conio.h>

void main()
{
    int driver = VGA, mode = VGAHI;
    initgraph(&driver, &mode, "C:\\\\TC\\\\BGI");
    bar(0, 0, 99, 99);
    %s
    getch();
    closegraph();
}
"""


def test_a_program_of_1993_is_pasted_and_runs(tab: Tab) -> None:
    run(tab, OF_1993 % "putpixel(200, 200, RED);")
    expected = np.zeros((480, 640, 3), np.uint8)
    expected[:100, :100], expected[200, 200] = 255, (0xAA, 0, 0)
    wait(tab, f"{CANVAS}?.width === 640")
    assert same_in_time(tab, expected)
    tab.press("x", "KeyX")
    assert printed(tab) == ""
    assert tab.evaluate("document.querySelector('#name').textContent") == "PROGRAM.C"


def test_an_error_in_c_is_shown_with_its_line(tab: Tab) -> None:
    run(tab, OF_1993 % "putpixel(200, 200);")
    assert printed(tab).startswith("PROGRAM.C:10:")
    assert tab.evaluate("document.querySelector('.wrong').textContent") == "10\n"
    run(tab, "print(6 * 7)\n")
    assert printed(tab) == "42\n"


def test_when_python_itself_fails_it_begins_anew(tab: Tab) -> None:
    """Its stack is JavaScript's, which ends without a RecursionError."""
    run(tab, "class A:\n    def __repr__(self): return repr(self)\nrepr(A())\n")
    assert "\nOut of stack" in printed(tab)
    run(tab, "print(6 * 7)\n")
    assert printed(tab) == "42\n"


def test_what_is_drawn_is_seen_though_the_program_asks_for_nothing(tab: Tab) -> None:
    run(tab, BEGIN + "bar(0, 0, 99, 99)\nputpixel(200, 200, RED)\nwhile True:\n    pass\n")
    expected = np.zeros((480, 640, 3), np.uint8)
    expected[:100, :100], expected[200, 200] = 255, (0xAA, 0, 0)
    wait(tab, f"{CANVAS}?.width === 640")
    assert same_in_time(tab, expected)
    click(tab, "stop")
    wait(tab, ENDED)


def test_every_picture_is_shown_and_waited_for(tab: Tab) -> None:
    """As many pictures as swaps, the last one too."""
    run(tab, BEGIN + "for x in range(30):\n    putpixel(x, x, 15)\n    swapbuffers()\n")
    assert printed(tab) == ""
    assert canvas(tab).any(axis=2).sum() == 15


def test_delay_takes_its_time(tab: Tab) -> None:
    program = "import time\nbegan = time.monotonic()\nfor i in range(10):\n    delay(20)\n"
    run(tab, BEGIN + program + "print(time.monotonic() - began >= 0.2)\n")
    assert printed(tab) == "True\n"


def test_the_mouse(tab: Tab) -> None:
    run(
        tab,
        "from bgi import *\ninitwindow(640, 480)\nseen = []\n"
        "registermousehandler(WM_RBUTTONDOWN, lambda x, y: seen.append((x, y)))\n"
        "while not ismouseclick(WM_LBUTTONDOWN) or not seen:\n    delay(5)\n"
        "print(getmouseclick(WM_LBUTTONDOWN) == seen[0])\n",
    )
    wait(tab, f"{CANVAS}?.width === 640")
    for button, held in (("left", 1), ("right", 2)):
        at = {"x": 200, "y": 300, "button": button, "clickCount": 1}
        tab.mouse("Moved", 200, 300)
        tab.call("Input.dispatchMouseEvent", type="mousePressed", buttons=held, **at)
        tab.call("Input.dispatchMouseEvent", type="mouseReleased", **at)
    assert printed(tab) == "True\n"


def test_the_magnifier_and_the_board(tab: Tab) -> None:
    """Also over what a program has left."""
    run(tab, BEGIN + "putpixel(100, 200, YELLOW)\nmagnifier(8, 'pixels')\ngetch()\n")
    said = "document.querySelector('.lens:not([hidden]) figcaption')?.textContent"
    wait(tab, f"{said} === 'x 100  y 200  color 14 YELLOW'")
    tab.press("x", "KeyX")
    assert printed(tab) == ""
    assert tab.evaluate("document.querySelector('.board').hidden")
    click(tab, "board")
    assert tab.evaluate("document.querySelector('.board canvas').width") == SIZE[0]
    assert tab.evaluate("document.querySelector('.board').offsetHeight > 100")
    click(tab, "board")
    for _ in range(3):
        click(tab, "lens")
    assert tab.evaluate(f"{said} === undefined")


def test_input_asks_on_the_page(tab: Tab) -> None:
    run(tab, "print('Hello,', input('Name? '))\n")
    wait(tab, "!document.querySelector('.answer').hidden")
    tab.evaluate(
        "(() => { const input = document.querySelector('.answer input');"
        "input.value = 'Ada'; input.form.requestSubmit(); })()"
    )
    assert printed(tab) == "Name? Ada\nHello, Ada\n"


def test_two_windows(tab: Tab) -> None:
    run(tab, "from bgi import *\ninitwindow(300, 200)\ninitwindow(200, 300)\ngetch()\n")
    shown = "[...document.querySelectorAll('.room:not([hidden]) canvas.screen')]"
    wait(tab, f"{shown}.map((c) => `${{c.width}}x${{c.height}}`).join() === '300x200,200x300'")
    tab.press("x", "KeyX")
    wait(tab, ENDED)


def test_each_program_begins_anew(tab: Tab) -> None:
    run(tab, BEGIN + "setcolor(RED)\nsetbkcolor(BLUE)\nimport random\nrandom.mark = 1\n")
    wait(tab, ENDED)
    run(tab, BEGIN + "print(getcolor(), getbkcolor(), graphresult())\n")
    assert printed(tab) == "15 0 0\n"


def test_a_link_holds_the_program(tab: Tab, browser: Browser, address: str) -> None:
    program = "print('häh? \\u2713')\n"
    run(tab, program)
    wait(tab, ENDED)
    tab.evaluate("document.querySelector('#share').click()")
    tab.wait_for("location.hash.includes('=')")
    place = tab.evaluate("location.hash")
    other = visit(browser, address + place)
    assert other.evaluate("document.querySelector('textarea').value") == program
    assert other.evaluate(ENDED) is None  # nothing runs because a link was opened
    other.close()


@pytest.mark.parametrize("page", ["", "docs/lines.html", "docs/a-z.html"])
def test_a_telephone_has_room_for_it(browser: Browser, address: str, page: str) -> None:
    tab = visit(browser, address + page)
    tab.resize(380, 800, 2, phone=True)
    assert tab.evaluate("document.documentElement.scrollWidth") <= 380
    tab.close()


def test_a_block_of_the_documentation_runs(browser: Browser, address: str) -> None:
    tab = visit(browser, f"{address}docs/lines.html")
    tab.evaluate("document.querySelector('pre.runs + .bar button').click()")
    wait(tab, f"document.querySelector('.player') && {ENDED}")
    name = tab.evaluate("document.querySelector('article img').src").rpartition("/")[2]
    expected = load(pictures.PICTURES / name).rgba[..., :3]
    height, width, _ = expected.shape
    assert (canvas(tab)[:height, :width] == expected).all()
    broken = json.dumps("bar(1, 2, 3, 4)\ncircle(1)\n")
    tab.evaluate(f"document.querySelector('pre.runs').textContent = {broken}")
    tab.evaluate("document.querySelector('pre.runs + .bar button').click()")
    wait(tab, f"{ENDED} === '1'")
    assert tab.evaluate("document.querySelector('pre .wrong').textContent") == "circle(1)"
    tab.close()


def test_a_lesson_and_its_program_run(browser: Browser, address: str) -> None:
    tab = visit(browser, f"{address}docs/course/01-screen.html")
    first = "document.querySelector('pre.runs:has(+ .bar + p img) + .bar button')"
    tab.evaluate(f"{first}.click()")
    wait(tab, f"document.querySelector('.player') && {ENDED} === '0'")
    name = tab.evaluate("document.querySelector('article img').src").rpartition("/")[2]
    expected = load(pictures.PICTURES / name).rgba[..., :3]
    height, width, _ = expected.shape
    assert (canvas(tab)[:height, :width] == expected).all()
    tab.evaluate("[...document.querySelectorAll('pre.runs + .bar button')].at(-2).click()")
    assert same_in_time(tab, load(pictures.LESSONS_PICTURES / "01_screen.png").rgba[..., :3])
    tab.press("x", "KeyX")
    assert printed(tab) == ""
    tab.close()


def test_a_program_in_c_of_the_documentation_runs(browser: Browser, address: str) -> None:
    tab = visit(browser, f"{address}docs/from-c.html")
    tab.evaluate("document.querySelector('pre.runs[data-name$=C] + .bar button').click()")
    wait(tab, f"{CANVAS}?.width === 640")
    tab.press("Escape", "Escape")
    assert printed(tab) == ""
    tab.close()


def test_without_shared_memory_python_is_suspended(
    browser: Browser, suspended_address: str
) -> None:
    tab = visit(browser, suspended_address, shared=False)
    loop = "x = 0\nwhile not kbhit():\n    x += 1\n    swapbuffers()\n"
    run(tab, BEGIN + loop + "print(x > 2, getch())\n")
    wait(tab, f"{CANVAS}?.width === 640")
    time.sleep(0.5)
    tab.press("a", "KeyA")
    assert printed(tab) == "True 97\n"
    run(tab, BEGIN + "print('begins')\ngetch()\n")
    wait(tab, f"{PRINTED} === 'begins\\n'")
    click(tab, "stop")
    assert printed(tab) == "begins\nStopped.\n"
    tab.close()


def test_the_second_visit_needs_no_network(browser: Browser, site: Path) -> None:
    with served(site) as address:
        tab = visit(browser, address)
        run(tab, "print('first')\n")
        assert printed(tab) == "first\n"
    tab.evaluate("location.reload()")
    tab.wait_for("!document.body?.dataset.ready")
    wait(tab, "document.body?.dataset.ready && crossOriginIsolated")
    run(tab, BEGIN + "circle(320, 240, 100)\nprint('second')\n")
    assert printed(tab) == "second\n"
    assert canvas(tab).any()
    tab.close()
