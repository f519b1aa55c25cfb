/* JUMPS.C: a jump out of a switch to the end of a turn, and remainders of numbers of any sign. */

#include <stdio.h>
#include <stdlib.h>

void main()
{
    int turn = 0, lives = 3, x = -8;

    for (turn = 0; turn < 12; turn++) {
        if (x % 2 == 0)
            printf("even ");
        switch (rand() % 3) {
        case 0:
            x = x - 1;
            if (x < 0)
                goto hit;
            break;
        case 1:
            x += random(5) % 4;
        }
        printf("%d ", x % 4);
        if (x % 5 || turn == 3 || turn == 5)
            lives++;
hit:
        if (x < 0)
            printf("hit %d\n", --lives);
        if (turn == 3 || turn == 5 || turn == 7)
            lives += 2;
    }
    printf("%d lives\n", lives);
}
