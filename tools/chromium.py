"""A headless Chromium to try pages in, by its DevTools protocol: no driver is needed for that.

https://chromedevtools.github.io/devtools-protocol/ tells what `Tab.call` may call.
"""

import base64
import contextlib
import itertools
import json
import os
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from websockets.sync.client import ClientConnection, connect

PATIENCE = 30  # seconds

Json = dict[str, Any]


def program() -> str | None:
    """Chromium's file, if it is installed."""
    names = ("chromium", "chromium-browser", "google-chrome")
    return next(filter(None, map(shutil.which, names)), None)


class Tab:
    """A page in the browser."""

    def __init__(self, line: ClientConnection, session: str) -> None:
        self._line = line
        self._session = session
        self._numbers = itertools.count(1)
        self.events: list[Json] = []
        for domain in ("Page", "Runtime", "Network"):
            self.call(f"{domain}.enable")

    def call(self, method: str, **parameters: object) -> Json:
        """Have the browser do something; its answer."""
        number = next(self._numbers)
        message = {"id": number, "method": method, "params": parameters}
        self._line.send(json.dumps({**message, "sessionId": self._session}))
        while True:
            answer: Json = json.loads(self._line.recv(PATIENCE))
            if answer.get("sessionId") != self._session:
                continue
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                result: Json = answer["result"]
                return result
            self.events.append(answer)

    def go(self, url: str) -> None:
        """Load a page."""
        self.call("Page.navigate", url="about:blank")  # another # alone loads nothing
        self.call("Page.navigate", url=url)

    def evaluate(self, expression: str) -> Any:
        """The value of an expression in JavaScript; promises are waited for."""
        answer = self.call(
            "Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True
        )
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"])
        return answer["result"].get("value")

    def wait_for(self, expression: str) -> Any:
        """Wait until an expression is true in JavaScript's sense."""
        deadline = time.monotonic() + PATIENCE
        while True:
            with contextlib.suppress(RuntimeError):  # while a page is loaded
                if value := self.evaluate(expression):
                    return value
            if time.monotonic() > deadline:
                raise TimeoutError(expression)
            time.sleep(0.01)

    def key(self, kind: str, key: str, code: str, modifiers: int = 0) -> None:
        """A key goes "down" or "up"; modifiers are 1 Alt, 2 Ctrl, 4 Meta, 8 Shift."""
        what = {"type": "keyDown" if kind == "down" else "keyUp", "key": key, "code": code}
        text = {"text": key} if len(key) == 1 and kind == "down" and not modifiers & 7 else {}
        self.call("Input.dispatchKeyEvent", **what, **text, modifiers=modifiers)

    def press(self, key: str, code: str, modifiers: int = 0) -> None:
        """A key goes down and up."""
        self.key("down", key, code, modifiers)
        self.key("up", key, code, modifiers)

    def mouse(self, kind: str, x: float, y: float, **more: object) -> None:
        """The mouse "Moved", "Pressed", "Released" or "Wheel"."""
        self.call("Input.dispatchMouseEvent", type=f"mouse{kind}", x=x, y=y, **more)

    def resize(self, width: int, height: int, scale: float = 1, phone: bool = False) -> None:
        """Give the page a size, a scale of its pixels, and maybe a phone's manners."""
        sizes: Json = {"width": width, "height": height, "deviceScaleFactor": scale}
        self.call("Emulation.setDeviceMetricsOverride", **sizes, mobile=phone)
        self.call("Emulation.setTouchEmulationEnabled", enabled=phone)

    def save_to(self, folder: Path) -> None:
        """Have the browser save what it downloads there."""
        self.call("Page.setDownloadBehavior", behavior="allow", downloadPath=str(folder))

    def close(self) -> None:
        """Close the tab, as its user does."""
        self.call("Page.close")

    def shot(self, file: Path) -> None:
        """Write a PNG of the page."""
        answer = self.call("Page.captureScreenshot", format="png")
        file.write_bytes(base64.b64decode(answer["data"]))


class Browser:
    """A running Chromium with a fresh profile."""

    def __init__(self, line: ClientConnection, pid: int) -> None:
        self._line = line
        self._numbers = itertools.count(-1, -1)
        self.pid = pid

    def tab(self) -> Tab:
        """Open a tab of its own window: hidden tabs paint nothing."""
        target = self._call("Target.createTarget", url="about:blank", newWindow=True)
        where = {"targetId": target["targetId"], "flatten": True}
        return Tab(self._line, self._call("Target.attachToTarget", **where)["sessionId"])

    def _call(self, method: str, **parameters: object) -> Json:
        number = next(self._numbers)
        self._line.send(json.dumps({"id": number, "method": method, "params": parameters}))
        while True:
            answer: Json = json.loads(self._line.recv(PATIENCE))
            if answer.get("id") == number and "sessionId" not in answer:
                result: Json = answer["result"]
                return result


@contextlib.contextmanager
def running(chromium: str) -> Iterator[Browser]:
    """A Chromium, until the end of the `with`."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [
            chromium,
            *("--headless=new", "--remote-debugging-port=0", f"--user-data-dir={profile}"),
            *("--no-first-run", "--disable-gpu", "--autoplay-policy=no-user-gesture-required"),
            *(["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []),
        ]
        process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
        try:
            assert process.stderr
            found = None
            while not found:
                found = re.search(r"listening on (ws://\S+)", process.stderr.readline())
            with connect(found[1], max_size=None) as line:
                yield Browser(line, process.pid)
                line.send(json.dumps({"id": 0, "method": "Browser.close"}))
            process.wait(PATIENCE)
        finally:
            process.kill()
            process.communicate()
