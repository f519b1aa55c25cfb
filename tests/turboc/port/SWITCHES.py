"""What falls through, jumps out and walks: the ways of C that Python has not.

Loops that did nothing but wait are busy() here; delay() would say how long.

Where int16() stands, C may have cut a number off at 32,767.

Pointers that walk through arrays are a class here, Pointer.
"""

from time import sleep

from bgi import getch
from bgi.stdio import printf


def int16(number):
    """A number as an int of 16 bits holds it: 32,768 is -32,768."""
    return (number + 0x8000) % 0x10000 - 0x8000


def busy(turns):
    """Wait as long as a PC of 1990 took for an empty loop of so many turns."""
    sleep(max(turns, 0) * 8 / 33e6)


def char_at(string, index):
    """The code of a character; 0 behind the last one, as in C."""
    return ord(string[index]) if index < len(string) else 0


class Pointer:
    """A place in a list, as a pointer of C: p + 1 is the next one."""

    def __init__(self, items, at=0):
        self.items = items
        self.at = at

    def __getitem__(self, index):
        return self.items[self.at + index]

    def __setitem__(self, index, value):
        self.items[self.at + index] = value

    def __add__(self, count):
        return Pointer(self.items, self.at + count)

    def __sub__(self, other):
        if isinstance(other, Pointer):
            return self.at - other.at
        return Pointer(self.items, self.at - other)

    def __eq__(self, other):
        return other is not None and self.items is other.items and self.at == other.at

    def __lt__(self, other):
        return self.at < other.at

    def __le__(self, other):
        return self.at <= other.at

    def __gt__(self, other):
        return self.at > other.at

    def __ge__(self, other):
        return self.at >= other.at


# Whoever gets a prize gets those below it, too.
def prizes(place):
    if place == 1:
        printf("gold ")
        printf("silver ")
        printf("bronze")
    elif place == 2:
        printf("silver ")
        printf("bronze")
    elif place == 3:
        printf("bronze")
    else:
        if not place < 0:
            printf("nothing")
    printf("\n")


# In C of 16 bits, 300 times 300 is 24,464.
def area(width, height):
    pixels = int16(width * height)

    if pixels < 0:
        printf("too large\n")
        return 0
    return pixels


def ask():
    while True:
        busy(30000)
        printf("again? ")
        c = getch()
        if c == 13:
            break
    printf("\n")


def sum_2(from_, to):
    total = 0

    while from_ < to:
        total += from_[0]
        from_ += 1
    return total


def count(text, letter):
    n = 0

    while text:
        if char_at(text, 0) == letter:
            n += 1
        text = text[1:]
    return n


calls = 0


def main():
    global calls
    numbers = [3, 1, 4, 1, 5, 9, 2, 6]

    for i in range(-1, 5):
        prizes(i)
    value = sum_2(Pointer(numbers, 2), Pointer(numbers, 5))
    printf("%d %d\n", sum_2(Pointer(numbers), Pointer(numbers, 8)), value)
    printf("%d\n", count("a banana", ord("a")))
    i = 0
    while i < 8 and numbers[i] != 9:
        i += 1
    printf("the 9 is at %d, %d / 2 = %d\n", i, -7, int(-7 / 2))
    while (c := getch()) != 27:
        calls += 1
    printf("%d keys, %d\n", calls, area(300, 300) + area(200, 200))
    ask()


if __name__ == "__main__":
    main()
