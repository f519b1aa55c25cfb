/* BALLS.C: balls that bounce in a room, without flicker.

   What it shows: while one page of the card is seen, the next picture is
   drawn on the other; then they change places. VGAMED is the VGA's mode
   with two pages.

   Space throws the balls again, any other key ends. */

#include <graphics.h>
#include <stdlib.h>
#include <stdio.h>
#include <conio.h>
#include <dos.h>

#define BALLS   6
#define FLOOR   320
#define GRAVITY 0.5

struct ball {
    float x, y, dx, dy;         /* where it is, and how it moves */
    int   radius, color;
};

void throw_balls(struct ball *balls, int number)
{
    struct ball *b;

    for (b = balls; b < balls + number; b++) {
        b->radius = 14 + random(20);
        b->x = 100 + random(440);
        b->y = 40 + random(120);
        b->dx = (random(2) ? 1 : -1) * (2 + random(40) / 10.0);
        b->dy = 0;
        b->color = LIGHTBLUE + (b - balls) % 6;
    }
}

void move(struct ball *b)
{
    int bottom = FLOOR - b->radius * 3 / 4;

    b->dy += GRAVITY;
    b->x += b->dx;
    b->y += b->dy;
    if (b->x < 20 + b->radius || b->x > getmaxx() - 20 - b->radius) {
        b->dx = -b->dx;
        b->x += b->dx;
    }
    if (b->y > bottom) {
        b->y = bottom;
        b->dy = -b->dy * 0.96;
    }
}

/* The mode's pixels are higher than they are wide: a circle of 4 : 3. */
void draw_ball(struct ball *b)
{
    int x = b->x, y = b->y, flat = b->radius * 3 / 4;

    setcolor(b->color - 8);
    setfillstyle(SOLID_FILL, b->color);
    fillellipse(x, y, b->radius, flat);
    setcolor(WHITE);
    setfillstyle(SOLID_FILL, WHITE);
    fillellipse(x - b->radius / 3, y - flat / 3, b->radius / 5, flat / 5);
}

void shadow(struct ball *b)
{
    int width = b->radius - (FLOOR - (int)b->y) / 12;

    if (width < 4)
        width = 4;
    setcolor(BLACK);
    setfillstyle(SOLID_FILL, BLACK);
    fillellipse((int)b->x, FLOOR + 6, width, width / 4);
}

void room(void)
{
    int x;

    setfillstyle(SOLID_FILL, BLUE);
    bar(0, 0, getmaxx(), FLOOR - 20);
    setfillstyle(SOLID_FILL, BROWN);
    bar(0, FLOOR - 20, getmaxx(), getmaxy());
    setcolor(YELLOW);
    for (x = -600; x <= 1240; x += 80)
        line(getmaxx() / 2 + (x - getmaxx() / 2) / 2, FLOOR - 20, x, getmaxy());
    setcolor(WHITE);
    outtextxy(8, 8, "Space  again     any other key  end");
}

void main(void)
{
    int         gdriver = VGA, gmode = VGAMED, error, page = 0, i, key = ' ';
    struct ball balls[BALLS];

    initgraph(&gdriver, &gmode, "");
    error = graphresult();
    if (error != grOk) {
        printf("Graphics error: %s\n", grapherrormsg(error));
        exit(1);
    }
    do {
        throw_balls(balls, BALLS);
        while (!kbhit()) {
            setactivepage(page);
            room();
            for (i = 0; i < BALLS; i++)
                shadow(&balls[i]);
            for (i = 0; i < BALLS; i++) {
                move(&balls[i]);
                draw_ball(&balls[i]);
            }
            setvisualpage(page);
            page = !page;
            delay(20);
        }
        key = getch();
    } while (key == ' ');
    closegraph();
}
