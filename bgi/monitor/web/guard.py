"""Who may come in: a page of ours, by an address of this machine, with the token.

A browser runs pages of strangers, and they may send requests to this machine. So a request must
name this machine as its host: a stranger's name that leads here is refused (DNS rebinding). If a
page sent it, that page must come from the same place (the `Origin`). And who wants to see or to
type must know the token, which only the program's user was told.
"""

import hmac
import ipaddress
import os
import re
import secrets
import socket
from urllib.parse import urlsplit

from websockets.datastructures import Headers

TOKEN_BYTES = 18  # 144 bits, in 24 characters
_TOKEN = re.compile(r"[A-Za-z0-9_-]{22,100}")  # 22 characters are 132 bits
LOCAL = frozenset(("127.0.0.1", "::1", "localhost"))


class Guard:
    """The judge of requests to a server that listens at `address`.

    `hosts` are further names by which it may be reached: those of proxies. Beyond this machine it
    may be reached by its numbers, too, and by its own name. ValueError for a token that is easily
    guessed; by default it is made by chance.
    """

    def __init__(self, address: str, hosts: frozenset[str] = frozenset(), token: str = "") -> None:
        if token and not _TOKEN.fullmatch(token):
            raise ValueError(
                "BGI_WEB_TOKEN must be 22 to 100 letters, digits, - or _, made by chance"
            )
        self.token = token or secrets.token_urlsafe(TOKEN_BYTES)
        self._proxies = hosts
        self.wide = address not in LOCAL
        """Whether other machines can reach it."""
        self._names = LOCAL | hosts | ({socket.gethostname().lower()} if self.wide else set())

    @classmethod
    def from_environment(cls, address: str) -> "Guard":
        """What BGI_WEB_HOSTS and BGI_WEB_TOKEN say."""
        names = os.environ.get("BGI_WEB_HOSTS", "").lower().split(",")
        hosts = frozenset(filter(None, map(str.strip, names)))
        return cls(address, hosts, os.environ.get("BGI_WEB_TOKEN", ""))

    def objection(self, headers: Headers) -> str:
        """Why a request must be refused; nothing: an empty text."""
        hosts, origins = headers.get_all("Host"), headers.get_all("Origin")
        if len(hosts) != 1 or not self._is_ours(_name(hosts[0])):
            return "unknown host; BGI_WEB_HOSTS names those of proxies"
        if origins and not self._is_same(origins, hosts[0]):
            return "foreign origin"
        return ""

    def knows(self, token: str) -> bool:
        """Whether that is the token; what the answer takes tells nothing about it."""
        return hmac.compare_digest(token.encode(), self.token.encode())

    @property
    def framers(self) -> str:
        """Whose pages may hold ours in a frame: those of notebooks, here and behind proxies."""
        names = ("localhost", "127.0.0.1", *sorted(self._proxies))
        return " ".join(["'self'", *(f"http://{name}:* https://{name}:*" for name in names)])

    def _is_ours(self, name: str) -> bool:
        return name in self._names or (self.wide and _is_number(name))

    def _is_same(self, origins: list[str], host: str) -> bool:
        if len(origins) != 1:
            return False
        scheme, _, place = origins[0].lower().partition("://")
        ours = place == host.lower() or _name(place) in self._proxies
        return scheme in ("http", "https") and ours


def _name(place: str) -> str:
    """The host of `host:port`, in small letters; "" for what is none."""
    try:
        found = urlsplit(f"//{place}")
        plain = found.netloc == place and "@" not in place and found.port != 0
        return (found.hostname or "") if plain else ""
    except ValueError:
        return ""


def _is_number(name: str) -> bool:
    """Whether a host is an address and no name: no stranger can make it lead elsewhere."""
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
