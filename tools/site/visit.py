"""A visit to the site, by `tools.chromium`: to try it, and to measure it."""

import functools
import http.server
import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tools.chromium import Browser, Tab

BEGIN = "from bgi import *\ninitgraph(VGA, VGAHI)\n"
CANVAS = "document.querySelector('.room:not([hidden]) canvas.screen')"
PRINTED = "document.querySelector('.printed').textContent"
ENDED = "document.querySelector('.player').dataset.ended"
LOADED = "document.querySelector('.player').dataset.loaded"


class _Handler(http.server.SimpleHTTPRequestHandler):
    """Serves files, as any host would."""

    missing: tuple[str, ...] = ()
    """Those that it does not have."""

    def log_message(self, *arguments: object) -> None:
        """Say nothing."""

    def do_GET(self) -> None:
        """Answer."""
        if self.path in self.missing:
            self.send_error(404)
        else:
            super().do_GET()


class _NoWorker(_Handler):
    missing = ("/sw.js",)


@contextmanager
def served(folder: Path, service_worker: bool = True) -> Iterator[str]:
    """The address of the site, until the end of the `with`.

    Without a service worker its pages can share no memory.
    """
    kind = functools.partial(_Handler if service_worker else _NoWorker, directory=str(folder))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), kind)
    threading.Thread(target=server.serve_forever, name="site", daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()


def visit(browser: Browser, address: str, shared: bool = True) -> Tab:
    """Open a page of the site, and wait until it is there."""
    tab = browser.tab()
    tab.resize(1280, 900)
    tab.go(address)
    isolated = "" if shared else "!"
    wait(tab, f"document.body?.dataset.ready && {isolated}crossOriginIsolated")
    return tab


def run(tab: Tab, program: str) -> None:
    """Type a program and press Run."""
    tab.evaluate(
        f"""(() => {{
            const editor = document.querySelector("textarea");
            editor.value = {json.dumps(program)};
            editor.dispatchEvent(new Event("input"));
            document.querySelector("[data-action=run]").click();
        }})()"""
    )


def click(tab: Tab, action: str) -> None:
    """Press one of the screen's buttons."""
    tab.evaluate(f"document.querySelector('[data-action={action}]').click()")


def printed(tab: Tab) -> str:
    """What the program has printed by its end."""
    wait(tab, ENDED)
    text: str = tab.evaluate(PRINTED)
    return text


def wait(tab: Tab, condition: str) -> None:
    """As long as it takes to load Python, too."""
    for patience in reversed(range(4)):
        try:
            tab.wait_for(condition)
            return
        except TimeoutError:
            if not patience:
                raise
