"""MARKS.C: the marks of a class, read, sorted, and drawn as bars."""

from copy import deepcopy

from bgi import (
    BLUE, GREEN, SOLID_FILL, VGA, VGAHI, bar, closegraph, getch, getmaxy, initgraph, outtextxy,
    setfillstyle,
)
from bgi.stdio import printf, scanf

MOST = 5


class Pupil:
    def __init__(self, name="", mean=0.0):
        self.name = name
        self.marks = [0] * 3
        self.mean = mean


class_ = [Pupil() for _ in range(MOST)]
subjects = ["maths", "art", "sport"]


def swap(a, b):
    t = deepcopy(a)

    vars(a).update(vars(deepcopy(b)))
    vars(b).update(vars(deepcopy(t)))


def mean(values, n):
    sum_ = 0

    for i in range(n):
        sum_ += values[i]
    return sum_ / n


# The smallest and the largest.
def range_2(values, n):
    low = high = values[0]
    while n > 1:
        n -= 1
        if values[n] < low:
            low = values[n]
        if values[n] > high:
            high = values[n]
    return low, high


def read_class():
    while True:
        printf("How many pupils (1 to %d)? ", MOST)
        n = scanf("%d")
        if 1 <= n <= MOST:
            break
    for i in range(n):
        class_[i].name = f"pupil {chr(ord('A') + i)}"
        for j in range(3):
            printf("%s in %s: ", class_[i].name, subjects[j])
            class_[i].marks[j] = scanf("%d")
        class_[i].mean = mean(class_[i].marks, 3)
    return n


def sort(n):
    for i in range(n - 1, 0, -1):
        for j in range(i):
            if class_[j].mean < class_[j + 1].mean:
                swap(class_[j], class_[j + 1])


def main():
    gd = VGA
    gm = VGAHI

    n = read_class()
    sort(n)
    gd, gm = initgraph(gd, gm, "")
    for i in range(n):
        low, high = range_2(class_[i].marks, 3)
        setfillstyle(SOLID_FILL, BLUE if i % 2 else GREEN)
        bottom = getmaxy() - 40
        bar(40 + i * 110, getmaxy() - 40 - int(class_[i].mean), 120 + i * 110, bottom)
        line = class_[i].name
        if line == "pupil A":
            line = line + "!"
        outtextxy(40 + i * 110, getmaxy() - 30, line)
        line = f"{low} to {high}"
        outtextxy(40 + i * 110, getmaxy() - 18, line)
    getch()
    closegraph()


if __name__ == "__main__":
    main()
