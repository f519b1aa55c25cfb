"""The files of the page, and the headers that go with what is answered."""

from pathlib import Path

FOLDER = Path(__file__).with_name("page")
INDEX = "index.html"
_KINDS = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".svg": "image/svg+xml",
}


def load() -> dict[str, tuple[str, bytes]]:
    """What each path answers: a kind and the bytes. All of it is public: no file holds a secret."""
    files = {
        f"/{file.name}": (_KINDS[file.suffix], file.read_bytes())
        for file in FOLDER.iterdir()
        if file.suffix in _KINDS
    }
    return {**files, "/": files[f"/{INDEX}"]}


HEADERS = {
    "Cache-Control": "no-store",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "Connection": "close",
}
"""What goes with every answer."""


def policy(host: str, framers: str) -> str:
    """What a page may do, for a browser: run these files, and speak to `host`, nothing else."""
    parts = {
        "default-src": "'none'",
        "script-src": "'self'",
        "style-src": "'self'",
        "img-src": "'self'",
        "connect-src": f"'self' ws://{host} wss://{host}",  # Safari's 'self' is for files only
        "base-uri": "'none'",
        "form-action": "'none'",
        "frame-ancestors": framers,
    }
    return "; ".join(f"{key} {value}" for key, value in parts.items())
