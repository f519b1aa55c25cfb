"""The server: the page's files, and a line (a WebSocket) to each page, on one port."""

import http
import logging
import os
import socket
from collections.abc import Awaitable, Callable
from urllib.parse import parse_qs, urlsplit

from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.datastructures import Headers
from websockets.extensions.permessage_deflate import ServerPerMessageDeflateFactory
from websockets.http11 import Request, Response

from bgi.monitor.web import assets
from bgi.monitor.web.guard import Guard
from bgi.monitor.web.words import LONGEST

LINE = "/line"
DOOR = "/door"  # where a page asks whether its token is the right one

_DEFLATE = ServerPerMessageDeflateFactory(compress_settings={"level": 1, "memLevel": 9})

# What is refused is none of the program's output.
_SILENT = logging.getLogger("bgi.monitor.web")
_SILENT.propagate = False
_SILENT.addHandler(logging.NullHandler())


class WebServer:
    """Answers requests that the guard has no objection to, and hands pages on to `admit`."""

    def __init__(self, guard: Guard, admit: Callable[[ServerConnection], Awaitable[None]]) -> None:
        self._guard = guard
        self._admit = admit
        self._files = assets.load()

    async def listen(self, address: str, port: int) -> int:
        """Begin; returns the port. If that port is taken any other will do. OSError."""
        try:
            server = await self._serve(address, port)
        except OSError:
            if not port:
                raise
            server = await self._serve(address, 0)
        found: int = next(iter(server.sockets)).getsockname()[1]
        return found

    async def _serve(self, address: str, port: int) -> Server:
        return await serve(
            self._admit,
            address,
            port,
            process_request=self._answer,
            compression=None,  # but by the extension, at its fastest
            extensions=[_DEFLATE],
            server_header=None,
            max_size=LONGEST,
            logger=_SILENT,
        )

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """The answer to a request, or None to open the line that it asks for."""
        if objection := self._guard.objection(request.headers):
            return _response(http.HTTPStatus.FORBIDDEN, objection)
        if getattr(request, "method", "GET") != "GET":  # before websockets 17 there was no other
            return _response(http.HTTPStatus.METHOD_NOT_ALLOWED, "GET only")
        address = urlsplit(request.path)
        if address.path in (LINE, DOOR):
            token = parse_qs(address.query).get("token", [""])[0]
            if not self._guard.knows(token):
                return _response(http.HTTPStatus.FORBIDDEN, "wrong token")
            return None if address.path == LINE else _response(http.HTTPStatus.OK, "welcome")
        kind, body = self._files.get(address.path, ("", b""))
        if not kind:
            return _response(http.HTTPStatus.NOT_FOUND, "no such file")
        policy = assets.policy(request.headers["Host"], self._guard.framers)
        return _response(http.HTTPStatus.OK, body, kind, policy)


def _response(
    status: http.HTTPStatus,
    body: str | bytes,
    kind: str = "text/plain; charset=utf-8",
    policy: str = "default-src 'none'",
) -> Response:
    data = body.encode() if isinstance(body, str) else body
    headers = Headers(
        {
            **assets.HEADERS,
            "Content-Security-Policy": policy,
            "Content-Type": kind,
            "Content-Length": str(len(data)),
        }
    )
    return Response(status.value, status.phrase, headers, data)


def asked_address() -> str:
    """Where BGI_WEB_ADDRESS wants the server; by default nothing but this machine reaches it."""
    return os.environ.get("BGI_WEB_ADDRESS", "") or "127.0.0.1"


def shown_address(address: str) -> str:
    """What to type for an address into a browser."""
    if address in ("0.0.0.0", "::"):
        return socket.gethostname()
    return f"[{address}]" if ":" in address else address


def asked_port() -> int:
    """The port of BGI_WEB_PORT; 0 for any. ValueError."""
    text = os.environ.get("BGI_WEB_PORT", "") or "0"
    if not (text.isascii() and text.isdigit() and int(text) < 1 << 16):
        raise ValueError(f"BGI_WEB_PORT is {text!r}; it may be a number from 0 to 65535")
    return int(text)
