"""What is typed and clicked on a page arrives as from the window."""

import string
from collections.abc import Iterator

import pytest

from bgi.memory.card import Card
from bgi.monitor import PageWindow, sdlkeys
from bgi.monitor.keycodes import _CODES, encode, name_of
from bgi.monitor.pointer import LEFT, MIDDLE, RIGHT, pressed, released
from bgi.monitor.web.browserkeys import ALT, ALTGR, CAPS, CTRL, NUM, SHIFT, translated
from tests.monitor.web.page import Page
from tests.processes import wait_until

NAMED = {
    "Enter": sdlkeys.K_RETURN,
    "Escape": sdlkeys.K_ESCAPE,
    "Tab": sdlkeys.K_TAB,
    "Backspace": sdlkeys.K_BACKSPACE,
    "Home": sdlkeys.K_HOME,
    "ArrowUp": sdlkeys.K_UP,
    "PageUp": sdlkeys.K_PAGEUP,
    "ArrowLeft": sdlkeys.K_LEFT,
    "Clear": sdlkeys.K_KP5,
    "ArrowRight": sdlkeys.K_RIGHT,
    "End": sdlkeys.K_END,
    "ArrowDown": sdlkeys.K_DOWN,
    "PageDown": sdlkeys.K_PAGEDOWN,
    "Insert": sdlkeys.K_INSERT,
    "Delete": sdlkeys.K_DELETE,
    "PrintScreen": sdlkeys.K_PRINTSCREEN,
    **{f"F{number}": sdlkeys.K_F1 + number - 1 for number in range(1, 13)},
}
CHARACTERS = {
    **{letter: f"Key{letter.upper()}" for letter in string.ascii_lowercase},
    **{digit: f"Digit{digit}" for digit in string.digits},
    **{"-": "Minus", "=": "Equal", " ": "Space"},
}
MODS = {0: 0, SHIFT: sdlkeys.KMOD_LSHIFT, CTRL: sdlkeys.KMOD_LCTRL, ALT: sdlkeys.KMOD_LALT}


def typed(mods: int, code: str, key: str) -> bytes:
    return encode(*translated(mods, code, key))


@pytest.mark.parametrize("mods", MODS)
def test_every_code_of_the_window_can_be_typed(mods: int) -> None:
    names = {number: name for name, number in NAMED.items()} | {sdlkeys.K_KP_ENTER: "Enter"}
    for key, expected in _CODES[[*MODS].index(mods)].items():
        if key == sdlkeys.K_AT:  # where @ has a key of its own
            assert typed(mods, "Digit2", "@") == expected
        elif key in names:
            assert typed(mods, names[key], names[key]) == expected
        else:
            assert typed(mods, CHARACTERS[chr(key)], chr(key)) == expected


@pytest.mark.parametrize(
    ("mods", "code", "key", "expected"),
    [
        (0, "KeyA", "a", b"a"),
        (SHIFT, "KeyA", "A", b"A"),
        (CAPS, "KeyA", "A", b"A"),
        (0, "KeyA", "q", b"q"),  # a French keyboard
        (CTRL, "KeyA", "q", b"\x11"),
        (0, "BracketLeft", "ü", b"\x81"),
        (0, "KeyA", "ф", b"?"),
        (CTRL, "KeyA", "ф", b"\x01"),
        (CTRL, "BracketLeft", "[", b"\x1b"),
        (CTRL, "Digit6", "6", b"\x1e"),
        (CTRL | SHIFT, "Digit2", "@", b"\0\x03"),
        (ALTGR | CTRL | ALT, "KeyQ", "@", b"@"),  # as Windows has it
        (ALTGR, "KeyE", "€", b"?"),
        (ALT, "KeyL", "¬", b"\0\x26"),  # a Mac
        (NUM, "Numpad8", "8", b"8"),
        (0, "Numpad8", "ArrowUp", b"\0H"),
        (0, "NumpadAdd", "+", b"+"),
        (ALT, "NumpadSubtract", "-", b""),
        (CTRL, "Tab", "Tab", b"\t"),
        (CTRL, "KeyC", "c", b"\x03"),
        (0, "ShiftLeft", "Shift", b""),
        (0, "Unidentified", "Dead", b""),
        (0, "AudioVolumeUp", "AudioVolumeUp", b""),
    ],
)
def test_a_browsers_key_types_what_it_types_at_the_window(
    mods: int, code: str, key: str, expected: bytes
) -> None:
    assert typed(mods, code, key) == expected


@pytest.mark.parametrize(
    ("code", "key", "name"),
    [
        ("KeyA", "A", "a"),
        ("Digit1", "!", "1"),
        ("ArrowUp", "ArrowUp", "up"),
        ("Numpad4", "ArrowLeft", "left"),
        ("Numpad4", "4", "4"),
        ("NumpadAdd", "+", "+"),
        ("NumpadEnter", "Enter", "enter"),
        ("ShiftRight", "Shift", "shift"),
        ("ControlLeft", "Control", "ctrl"),
        ("Space", " ", "space"),
        ("F1", "F1", "f1"),
        ("BrowserBack", "BrowserBack", ""),
    ],
)
def test_a_key_is_called_as_at_the_window(code: str, key: str, name: str) -> None:
    found = translated(0, code, key)
    assert name_of(found.key, found.unicode) == name


@pytest.fixture
def page(window: PageWindow) -> Iterator[Page]:
    with Page(window.url) as page:
        page.hear_until(lambda page: page.pictures and page.words.get("typing") == "yes")
        yield page


def test_keys_arrive(window: PageWindow, page: Page) -> None:
    for code, key in (("KeyA", "a"), ("ArrowUp", "ArrowUp"), ("Enter", "Enter")):
        page.say("down", 0, code, key)
        page.say("up", 0, code)
    assert [window.read_key() for _ in range(4)] == [97, 0, 72, 13]
    assert not window.key_waiting()


def test_the_program_knows_what_is_down(window: PageWindow, page: Page) -> None:
    page.say("down", SHIFT, "ShiftRight", "Shift")
    page.say("down", SHIFT, "KeyA", "A")
    wait_until(lambda: window.keys.held == {"shift", "a"} and window.keys.shifts == 1)
    page.say("up", SHIFT, "KeyA")
    page.say("up", 0, "ShiftRight")
    wait_until(lambda: not window.keys.held and not window.keys.shifts)
    page.say("down", NUM | CTRL, "ControlLeft", "Control")
    wait_until(lambda: window.keys.held == {"ctrl"} and window.keys.shifts == 0x24)
    page.say("blur")  # the user looks elsewhere
    wait_until(lambda: not window.keys.held and not window.keys.shifts)


def test_whoever_goes_lets_go(window: PageWindow) -> None:
    with Page(window.url) as page:
        page.hear_until(lambda page: page.pictures)
        page.say("down", 0, "KeyA", "a")
        page.say("mouse", pressed(RIGHT), 5, 6, 2)
        wait_until(lambda: bool(window.keys.held) and window.mouse.buttons == 2)
    wait_until(lambda: not window.keys.held and window.mouse.buttons == 0)
    assert window.mouse.take_count(released(RIGHT)) == (1, 5, 6)


def test_the_mouse(card: Card, window: PageWindow, page: Page) -> None:
    page.say("mouse", 1, 100, 50, 0)
    wait_until(lambda: (window.mouse.x, window.mouse.y) == (100, 50))
    for button in (LEFT, RIGHT, MIDDLE):
        page.say("mouse", pressed(button), 20 + button, 30, 1 << button)
        page.say("mouse", released(button), 40, 50 + button, 0)
    page.say("wheel", -3)
    wait_until(lambda: window.mouse.take_wheel() == -3)
    for button in (LEFT, RIGHT, MIDDLE):
        assert window.mouse.take_count(pressed(button)) == (1, 20 + button, 30)
        assert window.mouse.take_count(released(button)) == (1, 40, 50 + button)
    page.say("mouse", 1, 4095, 4095, 0)  # beyond the picture
    wait_until(lambda: (window.mouse.x, window.mouse.y) == (639, 479))
    window.mouse.limit(10, 20, 100, 200)
    page.hear_until(lambda page: page.words.get("limits") == "10 20 100 200")
    page.say("mouse", 1, 0, 300, 0)
    wait_until(lambda: (window.mouse.x, window.mouse.y) == (10, 200))


def test_others_see_where_the_pointer_is(window: PageWindow, page: Page) -> None:
    with Page(window.url) as other:
        page.say("mouse", 1, 7, 8, 0)
        other.hear_until(lambda page: page.words.get("move") == "7 8")
        assert "move" not in page.words


def test_one_types(window: PageWindow) -> None:
    """Of ten that look; and another, when it asks."""
    pages = [Page(window.url) for _ in range(10)]
    first, second, *others = pages
    first.hear_until(lambda page: page.words.get("typing") == "yes")
    for page in (second, *others):
        page.hear_until(lambda page: page.words.get("typing") == "no" and page.pictures)
    for page in pages:
        page.say("down", 0, "KeyA", "a" if page is first else "b")
        page.say("mouse", 1, 7 if page is first else 9, 9, 0)
        page.say("close" if page is not first else "blur")
        page.line.ping().wait(30)  # it has been heard
    assert window.read_key() == ord("a")
    assert not window.key_waiting()
    assert window.mouse.x == 7
    second.say("type")
    second.hear_until(lambda page: page.words["typing"] == "yes")
    first.hear_until(lambda page: page.words["typing"] == "no")
    second.say("down", 0, "KeyC", "c")
    assert window.read_key() == ord("c")
    second.close()  # then the next that comes types
    wait_until(lambda: window._pages == 9)
    with Page(window.url) as next_one:
        next_one.hear_until(lambda page: page.words.get("typing") == "yes")
    for page in pages:
        page.close()
    wait_until(lambda: window._pages == 0)
