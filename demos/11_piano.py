"""A piano of two octaves, for the speaker.

    python demos/11_piano.py

What it shows: sound() of `bgi.dos` plays a pitch until nosound() or the next one. The letters a to
k play the white keys, w e t y u the black ones; the mouse plays any, as long as its button is held.
Space plays a tune, Esc ends.
"""

from dataclasses import dataclass

from bgi import *
from bgi import dos, mouse

MODE = (VGA, VGAHI)
ESC, SPACE = 27, 32
LEFT, TOP, WIDTH, HEIGHT = 26, 150, 42, 240
BLACK_WIDTH, BLACK_HEIGHT = 26, 150
LOWEST = 261.63  # middle C, in hertz; every key is a twelfth of an octave above the one before
MILLISECONDS = 180  # that a key of the keyboard sounds

BLACK_KEYS = (1, 3, 6, 8, 10)  # half tones above C
LETTERS = "awsedftgyhujk"  # half tone by half tone, from C to C
TUNE = "d d f g g f d s a a s d d:3 s:1 s:4"  # letters; a number is a length, which is else 2
LEFT_HELD = 1  # in the sum that mouse.buttons() returns


@dataclass(frozen=True)
class Key:
    """A key of the piano: its half tone, its place, and the letter that plays it."""

    tone: int
    left: int
    black: bool
    letter: str

    @property
    def hertz(self) -> float:
        """Its pitch."""
        return float(LOWEST * 2 ** (self.tone / 12))

    def holds(self, x: int, y: int) -> bool:
        """Whether a point is on it."""
        width, height = (BLACK_WIDTH, BLACK_HEIGHT) if self.black else (WIDTH, HEIGHT)
        return self.left <= x < self.left + width and TOP <= y < TOP + height

    def draw(self, down: bool = False) -> None:
        """The key, lit while it sounds."""
        if self.black:
            color, right, bottom = BLACK, self.left + BLACK_WIDTH - 1, TOP + BLACK_HEIGHT - 1
        else:
            color, right, bottom = WHITE, self.left + WIDTH - 2, TOP + HEIGHT - 1
        setfillstyle(SOLID_FILL, LIGHTRED if down else color)
        bar(self.left, TOP, right, bottom)
        setcolor(DARKGRAY)
        rectangle(self.left, TOP, right, bottom)
        setcolor(LIGHTGRAY if self.black else BLUE)
        outtextxy((self.left + right) // 2 - 3, bottom - 16, self.letter)


def keyboard() -> list[Key]:
    """Two octaves, black keys last: they lie on top."""
    whites: list[Key] = []
    blacks: list[Key] = []
    for tone in range(24):
        letter = LETTERS[tone] if tone < len(LETTERS) else ""
        edge = LEFT + WIDTH * len(whites)  # the right edge of the white keys so far
        if tone % 12 in BLACK_KEYS:
            blacks.append(Key(tone, edge - BLACK_WIDTH // 2, True, letter))
        else:
            whites.append(Key(tone, edge, False, letter))
    return whites + blacks


KEYS = keyboard()
BY_LETTER = {key.letter: key for key in KEYS if key.letter}


def press(key: Key | None) -> None:
    """Draw the keys with one of them down, or none; a white one has to leave the black ones."""
    for each in KEYS:
        each.draw(each is key)


def play(key: Key, milliseconds: float) -> None:
    """Sound a key so long."""
    press(key)
    dos.sound(key.hertz)
    delay(milliseconds)
    dos.nosound()
    press(None)


def tune() -> None:
    """A melody, until a key is pressed."""
    for note in TUNE.split():
        letter, _, length = note.partition(":")
        play(BY_LETTER[letter], 110 * int(length or 2))
        delay(20)
        if kbhit():
            return


def key_at(x: int, y: int) -> Key | None:
    """The key at a point."""
    for key in reversed(KEYS):  # the black ones first: they lie on top
        if key.holds(x, y):
            return key
    return None


def follow_mouse() -> None:
    """Play what the mouse holds down, until it lets go."""
    held = None
    while mouse.buttons() & LEFT_HELD:
        key = key_at(*mouse.position())
        if key != held:
            press(key)
            dos.sound(key.hertz if key else 0)
            held = key
        delay(5)
    if held is not None:
        dos.nosound()
        press(None)


def scene() -> None:
    """The piano's wood, and its keys."""
    cleardevice()
    setfillstyle(SOLID_FILL, BROWN)
    bar(LEFT - 16, TOP - 60, LEFT + 14 * WIDTH + 14, TOP + HEIGHT + 16)
    setfillstyle(SOLID_FILL, BLACK)
    bar(LEFT - 2, TOP - 4, LEFT + 14 * WIDTH, TOP + HEIGHT)
    setcolor(YELLOW)
    outtextxy(LEFT, TOP - 36, "P C   S P E A K E R")
    setcolor(LIGHTCYAN)
    outtextxy(LEFT, 24, "letters or mouse: play   space: a tune   Esc: end")
    press(None)


def draw() -> None:
    """The piano, with one key down."""
    scene()
    press(BY_LETTER["g"])


def main() -> None:
    """Play until Esc comes."""
    initgraph(*MODE)
    scene()
    mouse.reset()
    mouse.show()
    code = 0
    while code != ESC:
        while not kbhit():
            follow_mouse()
            delay(5)
        code = getch()
        letter = chr(code)
        if code == SPACE:
            tune()
        elif letter in BY_LETTER:
            play(BY_LETTER[letter], MILLISECONDS)
    mouse.reset()


if __name__ == "__main__":
    main()
