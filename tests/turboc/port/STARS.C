/* STARS.C: stars that fly towards the eye.

   Plus and minus change the speed, Esc ends. */

#include <graphics.h>
#include <stdlib.h>
#include <stdio.h>
#include <conio.h>
#include <dos.h>

#define STARS 40
#define FAR   (STARS * 5)     /* where they begin */
#define ESC   27

struct star {
    int x, y;                 /* from the middle */
    int z;                    /* how far away */
};

struct star sky[STARS];
int speed = 2, middle_x, middle_y;

/* A new place for a star. */
void begin(struct star *s)
{
    s->x = random(400) - 200;
    s->y = random(300) - 150;
    s->z = FAR;
}

/* Where it is seen; 0 if it is out of sight. */
int seen(struct star *s, int *px, int *py)
{
    *px = middle_x + s->x * 40 / s->z;
    *py = middle_y + s->y * 40 / s->z;
    return *px >= 0 && *px <= getmaxx() && *py >= 0 && *py <= getmaxy();
}

void draw(struct star *s, int color)
{
    int x, y;

    if (seen(s, &x, &y))
        putpixel(x, y, color);
}

void move(int count)
{
    int i;

    for (i = 0; i < count; i++) {
        draw(&sky[i], BLACK);
        sky[i].z -= speed;
        if (sky[i].z < 1)
            begin(&sky[i]);   // it flew past us
        draw(&sky[i], sky[i].z < FAR / 3 ? WHITE : DARKGRAY);
    }
}

void main(void)
{
    int gd = DETECT, gm, key = 0, i;
    char text[40];

    initgraph(&gd, &gm, "C:\\TC\\BGI");
    if (graphresult() != grOk) {
        printf("There is no graphics mode.\n");
        exit(1);
    }
    middle_x = getmaxx() / 2;
    middle_y = getmaxy() / 2;

    for (i = 0; i < STARS; i++)
        begin(&sky[i]);

    while (key != ESC) {
        move(STARS);
        if (kbhit()) {
            key = getch();
            switch (key) {
            case '+':
            case '=':
                speed++;
                break;
            case '-':
                if (speed > 1)
                    speed--;
                break;
            case 0:
                getch();      /* an arrow, or F1 */
            }
            sprintf(text, "speed %d", speed);
            outtextxy(8, 8, text);
        }
        delay(20);
    }
    closegraph();
}
