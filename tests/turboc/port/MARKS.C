/* MARKS.C: the marks of a class, read, sorted, and drawn as bars. */

#include <stdio.h>
#include <string.h>
#include <conio.h>
#include <graphics.h>

#define MOST 5

typedef struct {
    char  name[20];
    int   marks[3];
    float mean;
} pupil;

pupil class[MOST];
char *subjects[3] = { "maths", "art", "sport" };

void swap(pupil *a, pupil *b)
{
    pupil t = *a;

    *a = *b;
    *b = t;
}

float mean(int values[], int n)
{
    int i, sum = 0;

    for (i = 0; i < n; i++)
        sum += values[i];
    return (float)sum / n;
}

/* The smallest and the largest. */
void range(int *values, int n, int *low, int *high)
{
    *low = *high = values[0];
    while (n-- > 1) {
        if (values[n] < *low) *low = values[n];
        if (values[n] > *high) *high = values[n];
    }
}

int read_class(void)
{
    int n, i, j;

    do {
        printf("How many pupils (1 to %d)? ", MOST);
        scanf("%d", &n);
    } while (n < 1 || n > MOST);
    for (i = 0; i < n; i++) {
        sprintf(class[i].name, "pupil %c", 'A' + i);
        for (j = 0; j < 3; j++) {
            printf("%s in %s: ", class[i].name, subjects[j]);
            scanf("%d", &class[i].marks[j]);
        }
        class[i].mean = mean(class[i].marks, 3);
    }
    return n;
}

void sort(int n)
{
    int i, j;

    for (i = n - 1; i > 0; i--)
        for (j = 0; j < i; j++)
            if (class[j].mean < class[j + 1].mean)
                swap(&class[j], &class[j + 1]);
}

int main()
{
    int gd = VGA, gm = VGAHI, n, i, low, high;
    char line[60];

    n = read_class();
    sort(n);
    initgraph(&gd, &gm, "");
    for (i = 0; i < n; i++) {
        range(class[i].marks, 3, &low, &high);
        setfillstyle(SOLID_FILL, i % 2 ? BLUE : GREEN);
        bar(40 + i * 110, getmaxy() - 40 - (int)class[i].mean, 120 + i * 110, getmaxy() - 40);
        strcpy(line, class[i].name);
        if (strcmp(line, "pupil A") == 0)
            strcat(line, "!");
        outtextxy(40 + i * 110, getmaxy() - 30, line);
        sprintf(line, "%d to %d", low, high);
        outtextxy(40 + i * 110, getmaxy() - 18, line);
    }
    getch();
    closegraph();
    return 0;
}
