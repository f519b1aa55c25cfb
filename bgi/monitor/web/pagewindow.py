"""The program's side of the web monitor: a window that is a page in a browser."""

import importlib.util
import os
import sys
import threading
import time

from bgi.monitor.window import Window

PAGE_SECONDS = 10
"""How long a program waits for somebody to look before it begins."""


class PageWindow(Window):
    """The monitor that is a page; a browser looks at it when the constructor returns.

    Or nobody has come for ten seconds, and the program goes on without. BGIError if websockets is
    not installed.
    """

    child = "bgi.monitor.web.webchild"
    noun = "page"

    url = ""
    """The page's address, with the token behind its #."""

    _port = ""
    _token = ""
    _pages = 0
    _came = False  # whether a page has ever looked

    @classmethod
    def missing(cls) -> str:
        """What keeps us from serving pages, in a line that helps; empty if nothing does."""
        found = importlib.util.find_spec("websockets") is not None
        return "" if found else 'the web monitor needs websockets; type: pip install ".[web]"'

    def _await_opening(self) -> None:
        super()._await_opening()
        _say(f"see {self.url}")
        if os.environ.get("BGI_WEB_OPEN") == "1":
            threading.Thread(target=_open, args=[self.url], daemon=True).start()
        if _in_notebook():
            return  # which shows the page when the cell has run
        if not self._wait(lambda: self._came, time.monotonic() + PAGE_SECONDS):
            _say(f"nobody has looked for {PAGE_SECONDS} seconds; the program goes on")

    def _hear(self, word: str, rest: str) -> None:
        match word:
            case "address":
                self._arrive(*rest.split())
            case "pages":
                with self._news:
                    self._pages = int(rest)
                    self._came = self._came or self._pages > 0
                    self._news.notify_all()
            case _:
                super()._hear(word, rest)

    def _arrive(self, host: str, port: str, token: str, reach: str) -> None:
        """The server listens: the next one of this program is to be found at the same place."""
        self._port, self._token = port, token
        self.url = f"http://{host}:{port}/#{token}"
        os.environ.setdefault("BGI_WEB_PORT", port)
        os.environ.setdefault("BGI_WEB_TOKEN", token)
        if reach == "wide":
            _say(f"every machine that reaches {host} can ask this program for its page")

    def linger(self) -> None:
        """Wait for a key, as a window does, if anybody is there to read."""
        if self._pages:
            super().linger()

    def notebook_html(self) -> str:
        """The page in a frame."""
        if self._error is not None:
            return ""
        # Behind JupyterHub, jupyter-server-proxy leads to the port.
        hub = os.environ.get("JUPYTERHUB_SERVICE_PREFIX")
        source = f"{hub}proxy/{self._port}/#{self._token}" if hub else self.url
        return (
            f'<iframe src="{source}" width="660" height="525" style="border: 0; max-width: 100%" '
            'allow="fullscreen; autoplay"></iframe>'
        )


def _say(line: str) -> None:
    print(f"bgi: {line}", file=sys.stderr, flush=True)


def _open(url: str) -> None:
    import webbrowser  # late, as it is rarely asked for

    webbrowser.open(url)


def _in_notebook() -> bool:
    return "ipykernel" in sys.modules
