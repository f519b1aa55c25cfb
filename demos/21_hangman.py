"""Hangman: guess a word, letter by letter, on the text screen.

    python demos/21_hangman.py

What it shows: the text screen of `bgi.conio`. window() confines what is written to a box, in whose
rows and columns gotoxy() counts; textcolor() and textbackground() colour it. A box is drawn with
the characters that the PC has for it. Any letter is a guess, Esc ends.
"""

from bgi.conio import *
from bgi.dos import random, randomize

WORDS = [
    *("pixel", "adapter", "bitmap", "cursor", "floodfill", "keyboard", "monitor", "palette"),
    *("polygon", "viewport", "graphics", "register"),
]
ESC, CHANCES = 27, 6
GALLOWS = [
    "  ╔════╗ ",
    "  ║    │ ",
    "  ║      ",
    "  ║      ",
    "  ║      ",
    "  ║      ",
    "══╩══════",
]
PARTS = [(7, 3, "☻"), (7, 4, "║"), (6, 4, "/"), (8, 4, "\\"), (6, 5, "/"), (8, 5, "\\")]


def box(left: int, top: int, right: int, bottom: int, title: str) -> None:
    """Draw a box with a title, and write in it from now on."""
    window(1, 1, 80, 25)
    across = right - left - 1
    for row in range(top, bottom + 1):
        ends, middle = ("╔╗", "═") if row == top else ("╚╝", "═") if row == bottom else ("║║", " ")
        gotoxy(left, row)
        cputs(ends[0] + middle * across + ends[1])
    gotoxy(left + 2, top)
    cprintf(" %s ", title)
    window(left + 1, top + 1, right - 1, bottom - 1)


def picture(wrong: int) -> None:
    """The gallows, and as much of the man as there were wrong guesses."""
    textcolor(YELLOW)
    box(48, 6, 72, 16, "Hangman")
    for row, beams in enumerate(GALLOWS, 2):
        gotoxy(7, row)
        cputs(beams)
    textcolor(LIGHTRED)
    for x, y, part in PARTS[:wrong]:
        gotoxy(x + 6, y + 1)
        cputs(part)


def letters(word: str, guessed: str) -> None:
    """The word as far as it is known, and the letters that have been tried."""
    textcolor(WHITE)
    box(8, 6, 44, 11, "The word")
    gotoxy(4, 2)
    cputs(" ".join(letter if letter in guessed else "_" for letter in word))
    textcolor(LIGHTCYAN)
    box(8, 13, 44, 16, "Tried")
    gotoxy(4, 1)
    cputs(" ".join(sorted(guessed)))


def say(words: str) -> None:
    """A line at the bottom."""
    window(1, 25, 80, 25)
    textbackground(LIGHTGRAY)
    textcolor(BLACK)
    clrscr()
    cputs(f"  {words}")
    textbackground(BLUE)


textmode(C80)
_setcursortype(_NOCURSOR)
textbackground(BLUE)
clrscr()
randomize()
word, guessed, key = WORDS[0], "", 0
while key != ESC:
    wrong = sum(letter not in word for letter in guessed)
    found = all(letter in guessed for letter in word)
    picture(wrong)
    letters(word, guessed)
    if found or wrong == CHANCES:
        say(f"{'Well done!' if found else 'The word was ' + word + '.'} Any key: another word")
        word, guessed = WORDS[random(len(WORDS))], ""
        key = getch()
        continue
    say(f"Guess a letter; {CHANCES - wrong} chances are left. Esc ends.")
    key = getch()
    letter = chr(key).lower()
    if "a" <= letter <= "z" and letter not in guessed:
        guessed += letter
textmode(C80)
