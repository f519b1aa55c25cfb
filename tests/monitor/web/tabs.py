"""What tests see of the page in a browser's tab, and do there."""

import base64
import contextlib
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from bgi.memory.card import Card
from bgi.memory.matching import shown
from bgi.monitor import picture
from tests.processes import wait_until
from tools.chromium import Tab

CANVAS = "document.getElementById('screen')"


def canvas(tab: Tab, element: str = CANVAS) -> NDArray[np.uint8]:
    """The colours that the page has painted, shape (height, width, 3)."""
    tab.wait_for(f"{element}.width > 0")
    text = tab.evaluate(
        f"""(() => {{
            const {{width, height}} = {element};
            const data = {element}.getContext("2d").getImageData(0, 0, width, height).data;
            let text = `${{height}},${{width}},`;
            for (const byte of data) text += String.fromCharCode(byte);
            return btoa(text);
        }})()"""
    )
    data = base64.b64decode(text)
    height, width, pixels = data.split(b",", 2)
    return np.frombuffer(pixels, np.uint8).reshape(int(height), int(width), 4)[..., :3]


def on(card: Card) -> NDArray[np.uint8]:
    """The colours that the card shows."""
    frame = card.frame()
    assert frame is not None
    return shown(picture.pixels(frame), picture.colors(card.colors()))


def shows(tab: Tab, expected: Callable[[], NDArray[np.uint8]]) -> None:
    """Wait until the page shows that."""

    def same() -> bool:
        with contextlib.suppress(RuntimeError):  # the page is being loaded
            return np.array_equal(canvas(tab), expected())
        return False

    wait_until(same)


def click(tab: Tab, element: str) -> None:
    """Click at the middle of an element: a selector, or an expression."""
    found = (
        f"document.querySelector('{element}')" if element.startswith(("[data", "#")) else element
    )
    tab.wait_for(f"{found}.offsetWidth")
    box = f"{found}.getBoundingClientRect()"
    x, y = tab.evaluate(f"[{box}.left + {box}.width / 2, {box}.top + {box}.height / 2]")
    for kind in ("Pressed", "Released"):
        tab.mouse(kind, x, y, button="left", clickCount=1, buttons=1 if kind == "Pressed" else 0)
