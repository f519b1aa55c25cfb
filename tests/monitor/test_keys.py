"""DOS key codes against Borland's table, the queue, and keys written as words."""

import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bgi.errors import BGIError
from bgi.memory.sdl import pygame
from bgi.monitor.keycodes import KEYSTROKES, bios_code, encode, key_named, name_of, shift_flags
from bgi.monitor.keyqueue import BIOS_BUFFER, KeyQueue
from bgi.monitor.script import LONGEST, Press, parse_script, parse_time

NONE, SHIFT, CTRL, ALT = 0, pygame.KMOD_LSHIFT, pygame.KMOD_LCTRL, pygame.KMOD_LALT
F = [getattr(pygame, f"K_F{n}") for n in range(1, 13)]


def keys(text: str) -> list[int]:
    return [ord(character) for character in text]


# Scan codes after a 0, row by row of Borland's table.
EXTENDED = [
    (NONE, F, [*range(59, 69), 133, 134]),
    (SHIFT, F[:10], range(84, 94)),
    (CTRL, F[:10], range(94, 104)),
    (ALT, F[:10], range(104, 114)),
    (ALT, keys("1234567890-="), range(120, 132)),
    (ALT, keys("qwertyuiop"), range(16, 26)),
    (ALT, keys("asdfghjkl"), range(30, 39)),
    (ALT, keys("zxcvbnm"), range(44, 51)),
    (NONE, [pygame.K_HOME, pygame.K_UP, pygame.K_PAGEUP], (71, 72, 73)),
    (NONE, [pygame.K_LEFT, pygame.K_KP5, pygame.K_RIGHT], (75, 76, 77)),
    (NONE, [pygame.K_END, pygame.K_DOWN, pygame.K_PAGEDOWN], (79, 80, 81)),
    (NONE, [pygame.K_INSERT, pygame.K_DELETE], (82, 83)),
    (CTRL, [pygame.K_LEFT, pygame.K_RIGHT], (115, 116)),
    (CTRL, [pygame.K_END, pygame.K_PAGEDOWN, pygame.K_HOME, pygame.K_PAGEUP], (117, 118, 119, 132)),
    (SHIFT, [pygame.K_TAB], [15]),
    (CTRL, [pygame.K_PRINTSCREEN, pygame.K_2], (114, 3)),
    (CTRL | SHIFT, [pygame.K_2], [3]),
    (SHIFT, [pygame.K_LEFT, pygame.K_DELETE], (75, 83)),
]


@pytest.mark.parametrize(
    ("mods", "key", "code"),
    [(mods, *pair) for mods, row, codes in EXTENDED for pair in zip(row, codes, strict=True)],
)
def test_extended_keys(mods: int, key: int, code: int) -> None:
    assert encode(key, mods, "") == bytes((0, code))
    # Locks change nothing.
    assert encode(key, mods | pygame.KMOD_NUM | pygame.KMOD_CAPS, "") == bytes((0, code))


@pytest.mark.parametrize(
    ("key", "mods", "unicode", "code"),
    [
        (pygame.K_RETURN, NONE, "\r", 13),
        (pygame.K_KP_ENTER, NONE, "\r", 13),
        (pygame.K_RETURN, SHIFT, "\r", 13),
        (pygame.K_RETURN, CTRL, "\r", 10),
        (pygame.K_ESCAPE, NONE, "\x1b", 27),
        (pygame.K_TAB, NONE, "\t", 9),
        (pygame.K_BACKSPACE, NONE, "\b", 8),
        (pygame.K_BACKSPACE, CTRL, "\b", 127),
        (pygame.K_SPACE, NONE, " ", 32),
        (pygame.K_SPACE, CTRL, "\0", 32),
        (pygame.K_LEFTBRACKET, CTRL, "\x1b", 27),
        (pygame.K_a, NONE, "a", 97),
        (pygame.K_a, SHIFT, "A", 65),
        (pygame.K_2, SHIFT, "@", 64),
        (pygame.K_KP8, pygame.KMOD_NUM, "8", 56),
        (pygame.K_KP_PLUS, NONE, "+", 43),
    ],
)
def test_plain_keys(key: int, mods: int, unicode: str, code: int) -> None:
    assert encode(key, mods, unicode) == bytes((code,))


def test_ctrl_letters_are_1_to_26_whatever_text_they_make() -> None:
    for number, key in enumerate(keys("abcdefghijklmnopqrstuvwxyz"), 1):
        for unicode in ("", chr(number), chr(key)):
            assert encode(key, CTRL, unicode) == bytes((number,))


def test_delete_is_a_scan_code_though_pygame_gives_it_a_character() -> None:
    assert encode(pygame.K_DELETE, NONE, "\x7f") == b"\0S"


def test_the_keypad_without_numlock() -> None:
    pad = [getattr(pygame, f"K_KP{n}") for n in (7, 8, 9, 4, 5, 6, 1, 2, 3, 0)]
    assert [encode(key, NONE, "")[1] for key in pad] == [71, 72, 73, 75, 76, 77, 79, 80, 81, 82]
    assert encode(pygame.K_KP_PERIOD, NONE, "") == b"\0S"


@pytest.mark.parametrize(("unicode", "code"), [("é", 0x82), ("ñ", 0xA4), ("ß", 0xE1), ("█", 0xDB)])
def test_beyond_ascii_comes_code_page_437(unicode: str, code: int) -> None:
    assert encode(ord(unicode), NONE, unicode) == bytes((code,))


def test_what_the_code_page_lacks_is_a_question_mark() -> None:
    assert encode(ord("я"), NONE, "я") == b"?"


def test_altgr_writes_characters() -> None:
    right = pygame.KMOD_RALT
    assert encode(pygame.K_q, right, "@") == b"@"
    assert encode(pygame.K_q, right | CTRL, "@") == b"@"  # as Windows reports AltGr
    assert encode(pygame.K_q, pygame.KMOD_MODE, "@") == b"@"  # as X11 does
    assert encode(pygame.K_q, right, "q") == b"\0\x10"  # a keyboard without AltGr


@pytest.mark.parametrize(
    ("key", "mods", "unicode"),
    [
        (pygame.K_LSHIFT, SHIFT, ""),
        (pygame.K_CAPSLOCK, NONE, ""),
        (pygame.K_UP, CTRL, ""),
        (pygame.K_1, CTRL, "1"),
        (pygame.K_SPACE, ALT, " "),
        (pygame.K_q, pygame.KMOD_LMETA, "q"),
    ],
)
def test_keys_that_dos_does_not_know_are_dropped(key: int, mods: int, unicode: str) -> None:
    assert encode(key, mods, unicode) == b""


@given(
    key=st.integers(0, 2**31),
    mods=st.integers(0, 0xFFFF),
    unicode=st.sampled_from(["", "a", "\0", "é", "я", "\r"]),
)
def test_a_keystroke_is_empty_or_one_byte_or_0_and_a_code(
    key: int, mods: int, unicode: str
) -> None:
    keystroke = encode(key, mods, unicode)
    assert keystroke == b"" or (len(keystroke) == 2) == (keystroke[0] == 0)
    assert len(keystroke) <= 2


def nobody() -> None:
    raise BGIError("nobody is there")


def test_the_queue_gives_bytes_in_order() -> None:
    queue = KeyQueue()
    for keystroke in (b"a", b"\0H", b"", b"b"):
        queue.put(keystroke)
    assert queue.waiting()
    assert [queue.get(nobody) for _ in range(4)] == [97, 0, 72, 98]
    assert not queue.waiting()


def test_half_a_keystroke_is_still_waiting() -> None:
    queue = KeyQueue()
    queue.put(b"\0H")
    assert queue.get(nobody) == 0
    assert queue.waiting()
    assert queue.get(nobody) == 72


def test_a_full_queue_drops_whole_keystrokes() -> None:
    queue = KeyQueue()
    for _ in range(BIOS_BUFFER):
        queue.put(b"\0H")
    queue.put(b"\0P")
    queue.put(b"x")
    assert [queue.get(nobody) for _ in range(2 * BIOS_BUFFER)] == [0, 72] * BIOS_BUFFER
    with pytest.raises(BGIError, match="nobody"):
        queue.get(nobody)


def test_get_waits_for_a_key() -> None:
    queue = KeyQueue()
    typist = threading.Timer(0.05, queue.put, [b"k"])
    typist.start()
    assert queue.get(lambda: None) == ord("k")
    typist.join()


def test_whoever_waits_can_be_woken() -> None:
    queue = KeyQueue()
    ended = threading.Event()

    def check() -> None:
        if ended.is_set():
            nobody()

    def end() -> None:
        ended.set()
        queue.wake()

    closer = threading.Timer(0.05, end)
    closer.start()
    for _ in range(2):
        with pytest.raises(BGIError, match="nobody"):
            queue.get(check)
    closer.join()


def test_one_byte_can_be_put_back() -> None:
    queue = KeyQueue()
    queue.put(b"\0H")
    assert queue.put_back(7)
    assert not queue.put_back(8)
    assert queue.waiting()
    assert (queue.get(nobody), queue.get(nobody)) == (7, 0)
    assert queue.half()
    assert not queue.put_back(9)  # half a keystroke waits in the same place
    assert queue.get(nobody) == 72
    assert queue.put_back(9)
    assert queue.get(nobody) == 9
    assert not queue.waiting()


def test_a_keystroke_can_be_looked_at_and_taken_whole() -> None:
    queue = KeyQueue()
    assert queue.peek() is None
    queue.put(b"\0H")
    queue.put_back(7)  # the BIOS knows nothing of it
    assert (queue.peek(), queue.take(nobody), queue.peek()) == (b"\0H", b"\0H", None)
    assert queue.get(nobody) == 7


def test_a_script_may_be_longer_than_the_buffer() -> None:
    queue = KeyQueue()
    queue.load([b"x"] * 100)
    queue.put(b"y")
    assert [queue.get(nobody) for _ in range(100)] == [ord("x")] * 100
    assert not queue.waiting()


def test_wait_ends_with_a_key() -> None:
    queue = KeyQueue()
    queue.wait(0)
    typist = threading.Timer(0.05, queue.put, [b"k"])
    typist.start()
    queue.wait(1000)
    assert queue.waiting()
    typist.join()


@pytest.mark.parametrize(
    ("keystroke", "code"),
    [
        (b"\0H", 0x4800),
        (b"\0P", 0x5000),
        (b"\0K", 0x4B00),
        (b"\0M", 0x4D00),
        (b"\0;", 0x3B00),
        (b"\x1b", 0x011B),
        (b"\r", 0x1C0D),
        (b"\n", 0x1C0A),
        (b"\t", 0x0F09),
        (b"\b", 0x0E08),
        (b"\x7f", 0x0E7F),
        (b" ", 0x3920),
        (b"a", 0x1E61),
        (b"A", 0x1E41),
        (b"\x01", 0x1E01),
        (b"1", 0x0231),
        (b"!", 0x0221),
        (b"=", 0x0D3D),
        (b"z", 0x2C7A),
        (b"?", 0x353F),
        (b"~", 0x297E),
        (b"|", 0x2B7C),
        (b"\x82", 0x0082),
    ],
)
def test_codes_of_the_bios(keystroke: bytes, code: int) -> None:
    assert bios_code(keystroke) == code


def test_every_character_of_ascii_has_a_scan_code() -> None:
    assert all(bios_code(bytes((code,))) >> 8 for code in range(32, 128))
    assert all(bios_code(bytes((code,))) >> 8 for code in range(1, 27))


def test_shift_flags() -> None:
    k = pygame
    assert shift_flags(0) == 0
    assert shift_flags(k.KMOD_RSHIFT) == 1
    assert shift_flags(k.KMOD_LSHIFT | k.KMOD_RCTRL) == 6
    assert shift_flags(k.KMOD_LALT | k.KMOD_NUM | k.KMOD_CAPS) == 0x68


def strokes(script: str) -> list[bytes]:
    return [press.keystroke for press in parse_script(script)]


def test_scripts() -> None:
    assert strokes("1 w Left esc") == [b"1", b"w", b"\0K", b"\x1b"]
    assert strokes("Enter Space Tab Backspace") == [b"\r", b" ", b"\t", b"\b"]
    assert strokes("HOME end PgUp PGDN Ins Del up Down right") == [
        bytes((0, code)) for code in (71, 79, 73, 81, 82, 83, 72, 80, 77)
    ]
    assert strokes(" ".join(f"F{n}" for n in range(1, 13))) == [
        bytes((0, code)) for code in (*range(59, 69), 133, 134)
    ]
    assert strokes("é A =") == [b"\x82", b"A", b"="]
    assert strokes("  \n ") == []


@pytest.mark.parametrize("word", ["Escape", "F13", "Ctrl-C", "ab", "Wait"])
def test_a_script_with_an_unknown_word(word: str) -> None:
    with pytest.raises(ValueError, match=f"'{word}' is not a key: write a single character, Esc,"):
        parse_script(f"a {word} b")


def test_a_script_waits_and_holds() -> None:
    none: frozenset[str] = frozenset()
    left, both = frozenset({"left"}), frozenset({"left", "x"})
    script = "a Wait2s +Left wait500ms +X -left WAIT1 -x B - + Wait0.5 ++"
    assert parse_script(script) == [
        Press(0, b"a", none),
        Press(2, b"\0K", left),
        Press(2.5, b"X", both),
        Press(2.5, b"", frozenset({"x"})),
        Press(3.5, b"", none),
        Press(3.5, b"B", none),
        Press(3.5, b"-", none),
        Press(3.5, b"+", none),
        Press(4, b"+", frozenset({"+"})),
    ]


@pytest.mark.parametrize("word", ["Waits", "Wait-1s", "Waitnan", "Wait1e10s", "waiting"])
def test_a_script_with_a_wrong_time(word: str) -> None:
    with pytest.raises(ValueError, match="is not a time: write 2s"):
        parse_script(word)


def test_times() -> None:
    assert [parse_time(text) for text in ("2s", "2.5", "500ms")] == [2, 2.5, 0.5]
    assert parse_time(f"{LONGEST}ms") == LONGEST / 1000
    with pytest.raises(ValueError, match="at most 24 days"):
        parse_time("2147484s")


# What is down


def test_the_names_of_keys() -> None:
    k = pygame
    assert [name_of(key, "") for key in (k.K_LEFT, k.K_SPACE, k.K_F12, k.K_DELETE, k.K_RCTRL)] == [
        "left",
        "space",
        "f12",
        "del",
        "ctrl",
    ]
    assert (name_of(k.K_a, "A"), name_of(k.K_a, "\1"), name_of(ord("ü"), "Ü")) == ("a", "a", "ü")
    assert (name_of(k.K_KP4, ""), name_of(k.K_KP4, "4"), name_of(k.K_KP_ENTER, "\r")) == (
        "left",
        "4",
        "enter",
    )
    assert name_of(k.K_PAUSE, "") == name_of(0, "") == ""
    assert [key_named(word) for word in ("A", "ESC", "Left", " ", "\r")] == [
        "a",
        "esc",
        "left",
        "space",
        "enter",
    ]
    assert all(key_named(name) == name for name in KEYSTROKES)


def test_what_is_down_is_down_in_any_window() -> None:
    queue = KeyQueue()
    queue.hold("one", 2, frozenset({"left"}))
    queue.hold("other", 4, frozenset({"x"}))
    assert (queue.shifts, queue.held) == (6, {"left", "x"})
    queue.hold("one", 0, frozenset())
    assert (queue.shifts, queue.held) == (4, {"x"})
