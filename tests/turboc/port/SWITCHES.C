/* What falls through, jumps out and walks: the ways of C that Python has not. */

#include <stdio.h>
#include <conio.h>

/* Whoever gets a prize gets those below it, too. */
void prizes(int place)
{
    switch (place) {
    case 1:
        printf("gold ");
    case 2:
        printf("silver ");
    case 3:
        printf("bronze");
        break;
    default:
        if (place < 0)
            break;
        printf("nothing");
    }
    printf("\n");
}

/* In C of 16 bits, 300 times 300 is 24,464. */
int area(int width, int height)
{
    int pixels = width * height;

    if (pixels < 0)
        goto wrong;
    return pixels;
wrong:
    printf("too large\n");
    return 0;
}

void ask(void)
{
    char c;
    unsigned wait;

again:
    for (wait = 0; wait < 30000; wait++)
        ;
    printf("again? ");
    c = getch();
    if (c != 13)
        goto again;
    printf("\n");
}

int sum(int *from, int *to)
{
    int total = 0;

    while (from < to)
        total += *from++;
    return total;
}

int count(char *text, char letter)
{
    int n = 0;

    while (*text) {
        if (*text == letter)
            n++;
        text++;
    }
    return n;
}

void main(void)
{
    static int calls;
    int numbers[] = { 3, 1, 4, 1, 5, 9, 2, 6 };
    int i, c;

    for (i = -1; i < 5; i++)
        prizes(i);
    printf("%d %d\n", sum(numbers, numbers + 8), sum(&numbers[2], &numbers[5]));
    printf("%d\n", count("a banana", 'a'));
    for (i = 0; i < 8 && numbers[i] != 9; i++)
        ;
    printf("the 9 is at %d, %d / 2 = %d\n", i, -7, -7 / 2);
    while ((c = getch()) != 27)
        calls++;
    printf("%d keys, %d\n", calls, area(300, 300) + area(200, 200));
    ask();
}
