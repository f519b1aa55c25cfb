"""QUEUE.CPP: people wait; whoever came first is served first."""

from math import fmod

from bgi import getch
from bgi.stdio import printf, scanf

MOST = 4


class Person:
    def __init__(self, aname, anage):
        self.age = anage
        self.name = aname

    def destroy(self):
        printf("%s goes home\n", self.name)

    def older(self, other):
        return int(self.age > other.age)

    # What everybody says.
    def greet(self):
        printf("I am %s, %d.\n", self.name, self.age)


class Child(Person):
    # in metres
    def __init__(self, aname, asize):
        super().__init__(aname, 9)
        self.size = asize

    def greet(self):
        super().greet()
        printf("I am %g m tall.\n", self.size)


class Queue:
    served = 0

    def __init__(self):
        self.places = [None] * 4
        self.first = self.count = 0

    @staticmethod
    def total():
        return Queue.served

    # Returns 0 if the queue is full.
    def add_in_place(self, one):
        if self.count == MOST:
            return 0
        self.count += 1
        self.places[int(fmod(self.first + (self.count - 1), MOST))] = one
        return 1

    def next(self):
        if self.count == 0:
            return None
        one = self.places[self.first]
        self.first = (self.first + 1) % MOST
        self.count -= 1
        Queue.served += 1
        return one


def grow(size, by):
    size += by
    return size


def main():
    queue = Queue()
    before = None

    queue.add_in_place(Person("Ada", 30))
    queue.add_in_place(Child("Bob", 1.25))
    queue.add_in_place(Person("Eve", 61))
    while (one := queue.next()) is not None:
        one.greet()
        if before is not None and one.older(before):
            printf("older!\n")
        if before is not None:
            before.destroy()
        before = one
    before.destroy()

    printf("How many more? ")
    n = scanf("%d")
    size = Queue.total()
    size = grow(size, n)
    printf("Then it is %d\n", size)
    getch()


if __name__ == "__main__":
    main()
