"""JUMPS.C: a jump out of a switch to the end of a turn, and remainders of numbers of any sign."""

from math import fmod

from bgi.stdio import printf
from bgi.stdlib import rand, random


def main():
    lives = 3
    x = -8

    for turn in range(12):
        if x % 2 == 0:
            printf("even ")
        while True:
            choice = rand() % 3
            if choice == 0:
                x -= 1
                if x < 0:
                    break
            elif choice == 1:
                x += random(5) % 4
            printf("%d ", int(fmod(x, 4)))
            if x % 5 or turn == 3 or turn == 5:
                lives += 1
            break
        if x < 0:
            lives -= 1
            printf("hit %d\n", lives)
        if turn in (3, 5, 7):
            lives += 2
    printf("%d lives\n", lives)


if __name__ == "__main__":
    main()
