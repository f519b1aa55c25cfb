"""Who is let in, and that nothing that is said can do harm."""

import contextlib
import hmac
import http.client
import os
import random
import re
import socket
import sys
from collections.abc import Mapping
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as some
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from bgi.errors import BGIError
from bgi.memory.card import Card
from bgi.monitor import PageWindow
from bgi.monitor.web import audience, guard, words
from bgi.monitor.web.guard import Guard
from bgi.monitor.web.words import FULL, LONGEST, REFUSED, understood
from tests.monitor.web.page import Page, addressed
from tests.processes import PATIENCE, wait_until


def get(
    window: PageWindow, path: str, headers: Mapping[str, str] | None = None, method: str = "GET"
) -> http.client.HTTPResponse:
    """The answer to a request, its body read."""
    host, _ = addressed(window.url)
    line = http.client.HTTPConnection(host, timeout=PATIENCE)
    line.request(method, path, headers=dict(headers or {}))
    answer = line.getresponse()
    answer.body = answer.read()  # type: ignore[attr-defined]
    return answer


def refused(window: PageWindow, token: str, **more: Any) -> int:
    """The status by which a line is refused."""
    host, _ = addressed(window.url)
    with pytest.raises(InvalidStatus) as caught, connect(f"ws://{host}/line?token={token}", **more):
        pass
    return caught.value.response.status_code


def test_the_token_is_long_and_another_each_time() -> None:
    tokens = {Guard("127.0.0.1").token for _ in range(50)}
    assert len(tokens) == 50
    assert guard.TOKEN_BYTES * 8 >= 128
    assert all(len(token) == guard.TOKEN_BYTES * 4 // 3 for token in tokens)


def test_it_is_compared_in_constant_time(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[bytes, bytes]] = []

    def compare(a: bytes, b: bytes) -> bool:
        asked.append((a, b))
        return False

    monkeypatch.setattr(hmac, "compare_digest", compare)
    judge = Guard("127.0.0.1")
    assert not judge.knows("grün")
    assert asked == [("grün".encode(), judge.token.encode())]


def test_without_the_token_nobody_looks(window: PageWindow) -> None:
    _, token = addressed(window.url)
    for wrong in ("", "x", token[:-1], token + "x", token.swapcase(), "%00", "%ff"):
        assert refused(window, wrong) == 403
        assert get(window, f"/door?token={wrong}").status == 403
    assert get(window, f"/door?token={token}").status == 200


def test_hosts(window: PageWindow) -> None:
    host, token = addressed(window.url)
    port = host.partition(":")[2]
    for good in (
        f"127.0.0.1:{port}",
        f"localhost:{port}",
        "localhost",
        f"[::1]:{port}",
        "LOCALHOST",
    ):
        assert get(window, "/", {"Host": good}).status == 200
    for evil in (
        "evil.example",
        f"evil.example:{port}",
        "127.0.0.1.evil.example",
        "192.168.0.1",
        "127.0.0.1@evil.example",
        "localhost:1:2",
        "[::1",
        "",
        "evil.example/127.0.0.1",
    ):
        for path in ("/", f"/door?token={token}", "/main.js"):
            assert get(window, path, {"Host": evil}).status in (400, 403), evil
    # A page of a stranger's, whose name has been made to lead here.
    line = socket.create_connection(("127.0.0.1", int(port)), PATIENCE)
    assert refused(window, token, sock=line, origin="http://evil.example") == 403


def test_origins(window: PageWindow) -> None:
    host, token = addressed(window.url)
    port = host.partition(":")[2]
    for evil in (
        "http://evil.example",
        "null",
        f"http://localhost:{port}",
        "http://127.0.0.1:1",
        f"file://{host}",
        f"http://{host}.evil.example",
        f"http://{host}/",
        "",
    ):
        assert refused(window, token, origin=evil) == 403, evil
        assert get(window, "/", {"Origin": evil}).status == 403
    with Page(window.url, origin=f"http://{host}") as page:
        page.hear_until(lambda page: page.pictures)


def test_a_proxy(card: Card, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BGI_WEB_HOSTS", "hub.example, Other.example")
    monkeypatch.setattr("bgi.monitor.web.pagewindow.PAGE_SECONDS", 0)
    window = PageWindow(card)
    try:
        for name in ("hub.example", "hub.example:8000", "other.example"):
            assert get(window, "/", {"Host": name}).status == 200
        answer = get(window, "/", {"Host": "hub.example"})
        policy = answer.headers["Content-Security-Policy"]
        assert "http://hub.example:* https://hub.example:*" in policy
        # One that puts its own name for the host, but leaves the page's origin.
        with Page(window.url, origin="https://hub.example") as page:
            page.hear_until(lambda page: page.pictures)
        assert get(window, "/", {"Host": "third.example"}).status == 403
    finally:
        window.close()


def test_beyond_this_machine_only_by_number_or_name() -> None:
    wide, local = Guard("0.0.0.0"), Guard("127.0.0.1")
    assert (wide.wide, local.wide) == (True, False)
    for name in ("192.168.0.7", "::1", socket.gethostname().lower(), "localhost"):
        assert wide._is_ours(name)
    assert not wide._is_ours("evil.example")
    assert not local._is_ours("192.168.0.7")


def test_it_listens_to_this_machine_only(window: PageWindow) -> None:
    host, _ = addressed(window.url)
    assert host.startswith("127.0.0.1:")
    with pytest.raises(OSError):
        socket.create_connection(("127.0.0.2", int(host.partition(":")[2])), PATIENCE)


def test_another_address_only_when_asked_and_with_a_warning(
    card: Card, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("BGI_WEB_ADDRESS", "127.0.0.2")
    monkeypatch.setattr("bgi.monitor.web.pagewindow.PAGE_SECONDS", 0)
    window = PageWindow(card)
    try:
        assert window.url.startswith("http://127.0.0.2:")
        assert "every machine that reaches 127.0.0.2" in capfd.readouterr().err
        with Page(window.url) as page:
            page.hear_until(lambda page: page.pictures)
    finally:
        window.close()


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("BGI_WEB_PORT", "x", "no page: BGI_WEB_PORT is 'x'; it may be a number from 0 to 65535"),
        ("BGI_WEB_PORT", "65536", "no page: BGI_WEB_PORT is '65536'"),
        ("BGI_WEB_TOKEN", "guess", "no page: BGI_WEB_TOKEN must be 22 to 100 letters"),
        ("BGI_WEB_ADDRESS", "256.0.0.0", "no page: "),
    ],
)
def test_settings_that_make_no_sense(
    card: Card, monkeypatch: pytest.MonkeyPatch, name: str, value: str, reason: str
) -> None:
    monkeypatch.setenv(name, value)
    with pytest.raises(BGIError) as caught:
        PageWindow(card)
    assert str(caught.value).startswith(reason)


# What is answered


def test_the_pages_files(window: PageWindow) -> None:
    _, token = addressed(window.url)
    index = get(window, "/")
    assert index.status == 200
    assert token not in index.body.decode()  # type: ignore[attr-defined]
    for name in ("main.js", "style.css", "icon.svg", "index.html"):
        answer = get(window, f"/{name}")
        assert answer.status == 200
        assert answer.headers["Content-Type"].split(";")[0] in (
            "text/javascript", "text/css", "image/svg+xml", "text/html",
        )  # fmt: skip
    for name in ("none.js", "../guard.py", "%2e%2e/guard.py", "page/main.js", "main.js/", "."):
        assert get(window, f"/{name}").status == 404


@pytest.mark.parametrize("path", ["/", "/main.js", "/none", "/door", "/line"])
@pytest.mark.parametrize("host", ["localhost", "evil.example"])
def test_headers(window: PageWindow, path: str, host: str) -> None:
    headers = get(window, path, {"Host": host}).headers
    assert headers["Cache-Control"] == "no-store"
    assert headers["Referrer-Policy"] == "no-referrer"
    assert headers["X-Content-Type-Options"] == "nosniff"
    assert headers["Content-Security-Policy"].startswith("default-src 'none'")
    assert "unsafe" not in headers["Content-Security-Policy"]
    assert "Server" not in headers


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "OPTIONS"])
def test_other_methods_are_refused(window: PageWindow, method: str) -> None:
    # Before version 17 websockets hangs up.
    with contextlib.suppress(http.client.HTTPException, OSError):
        assert get(window, "/", method=method).status == 405


# What is said


def test_all_that_a_page_says_is_understood() -> None:
    assert understood("shown") == ("shown", [], [])
    assert understood("down 3 KeyA a") == ("down", [3], ["KeyA", "a"])
    assert understood("down 0 Space  ") == ("down", [0], ["Space", " "])
    assert understood("down 63 KeyA 😀") == ("down", [63], ["KeyA", "😀"])
    assert understood("up 0 KeyA") == ("up", [0], ["KeyA"])
    assert understood("mouse 64 4095 0 7") == ("mouse", [64, 4095, 0, 7], [])
    assert understood("wheel -20") == ("wheel", [-20], [])
    assert understood("board 1") == ("board", [1], [])


MALFORMED = [
    "", " ", "shown ", "shown 1", "SHOWN", "closed", "key 97", "ready", "shown\n", "eval x",
    "down 64 KeyA a", "down -1 KeyA a", "down 0 KeyA", "down 0 KeyA ab", "down 0 Key-A a",
    "down 0 KeyA \n", "down 0 KeyA \0", f"down 0 KeyA A{'a' * 30}", "down ٣ KeyA a",
    "down 1e1 KeyA a", "mouse 3 0 0 0", "mouse 1 -1 0 0", "mouse 1 4096 0 0", "mouse 1 0 0 8",
    "mouse 1 0 0", "mouse 1.5 0 0 0", "wheel 21", "wheel 99999", "wheel", "held 255 a",
    "type please", "board", "board 2", "board yes",
]  # fmt: skip


@pytest.mark.parametrize("message", MALFORMED)
def test_what_no_page_says_is_not(message: str) -> None:
    with pytest.raises(ValueError, match=r"no page of ours|out of its range"):
        understood(message)


@given(
    some.text()
    | some.from_regex(r"(down|up|mouse|wheel|board|shown) ?[-0-9]* ?\w* ?.*", fullmatch=True)
)
def test_whatever_is_said_it_is_understood_or_refused(message: str) -> None:
    try:
        word, numbers, texts = understood(message)
    except ValueError:
        return
    assert word == message.partition(" ")[0]
    assert len(numbers) + len(texts) + 1 == len(re.split(r" (?! $)", message))
    assert all(-20 <= number < 4096 for number in numbers)
    assert all(len(text) == 1 or text.isalnum() for text in texts)


@pytest.mark.parametrize("message", [*MALFORMED, b"", b"shown", b"\xff" * 100])
def test_a_page_that_says_it_is_thrown_out(window: PageWindow, message: str | bytes) -> None:
    with Page(window.url) as quiet, Page(window.url) as page:
        page.line.send(message)
        assert page.end() == REFUSED
        quiet.hear_until(lambda page: page.pictures)
    assert not window.key_waiting()


@pytest.mark.parametrize("size", [LONGEST + 1, 1 << 20])
def test_long_messages_are_refused(window: PageWindow, size: int) -> None:
    with Page(window.url) as page:
        page.line.send("down 0 KeyA " + "a" * (size - 12))
        assert page.end() == 1009


def test_random_messages_do_no_harm(card: Card, window: PageWindow) -> None:
    chance = random.Random(1)
    with Page(window.url) as watching:
        for _ in range(200):
            with Page(window.url, compression=None) as page:
                page.say("type")
                try:
                    for _ in range(10):
                        word = chance.choice(
                            ["shown", "down", "up", "mouse", "wheel", "blur", "type", ""]
                        )
                        rest = chance.choice(
                            ["", " 1", " 0 KeyA a", " 1 5 5 0", chance.randbytes(9).hex()]
                        )
                        page.line.send(word + rest)
                    page.line.socket.sendall(chance.randbytes(20))
                    page.line.socket.shutdown(socket.SHUT_RDWR)
                except (ConnectionClosed, OSError):
                    pass
        card.page(0)[7] = 7
        watching.hear_until(lambda page: page.pixels.any())
    window.show()


def test_random_bytes_do_no_harm(window: PageWindow) -> None:
    chance = random.Random(1)
    host, _ = addressed(window.url)
    for length in range(0, 2000, 20):
        line = socket.create_connection(("127.0.0.1", int(host.partition(":")[2])), PATIENCE)
        line.sendall(
            chance.choice([b"", b"GET / HTTP/1.1\r\n", b"GET /"]) + chance.randbytes(length)
        )
        line.close()
    with Page(window.url) as page:
        page.hear_until(lambda page: page.pictures)


# How many


def test_so_many_may_look_and_no_more(window: PageWindow) -> None:
    pages = [Page(window.url) for _ in range(audience.MOST)]
    for page in pages:
        page.hear_until(lambda page: page.pictures)
    with Page(window.url) as late:
        assert late.end() == FULL
    pages.pop().close()
    wait_until(lambda: window._pages == audience.MOST - 1)
    with Page(window.url) as late:
        late.hear_until(lambda page: page.pictures)
    for page in pages:
        page.close()


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_a_hundred_that_come_and_go_leave_nothing(card: Card, window: PageWindow) -> None:
    def files() -> int:
        return len(os.listdir(f"/proc/{window.pid}/fd"))

    with Page(window.url) as page:
        page.hear_until(lambda page: page.pictures)
    wait_until(lambda: window._pages == 0)
    before = files()
    for number in range(1, 101):
        card.page(0)[0] = number
        with Page(window.url) as page:
            page.hear_until(
                lambda page, number=number: page.pixels.any() and page.pixels[0, 0] == number
            )
            assert page.words["typing"] == "yes"
            if number % 2:  # as when a line is cut
                page.line.socket.shutdown(socket.SHUT_RDWR)
        wait_until(lambda: window._pages == 0)
    wait_until(lambda: files() <= before)


def test_the_words_of_the_table_are_those_that_are_understood() -> None:
    table = words.__doc__ or ""
    assert all(f"``{word}" in table for word in words._FORMS)
