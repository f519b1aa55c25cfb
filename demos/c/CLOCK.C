/* CLOCK.C: a clock with hands, that ticks.

   What it shows: gettime() and getdate() of dos.h ask the PC's clock. The
   hands are polygons that are painted over in the colour of the dial; the
   second hand is drawn with XOR_PUT, which the same call takes away again.

   Any key ends. */

#include <graphics.h>
#include <stdlib.h>
#include <stdio.h>
#include <conio.h>
#include <math.h>
#include <dos.h>

#define RADIUS 180

static char *months[] = {
    "January", "February", "March", "April", "May", "June", "July",
    "August", "September", "October", "November", "December"
};

int midx, midy;

/* A point at a minute of the dial, so far from the middle. */
void place(double minute, int distance, int *x, int *y)
{
    double angle = minute * M_PI / 30;

    *x = midx + (int)(distance * sin(angle) + (sin(angle) < 0 ? -0.5 : 0.5));
    *y = midy - (int)(distance * cos(angle) + (cos(angle) < 0 ? -0.5 : 0.5));
}

void dial(void)
{
    int  hour, minute, x, y;
    char text[3];

    setcolor(WHITE);
    setfillstyle(SOLID_FILL, BLUE);
    fillellipse(midx, midy, RADIUS + 30, RADIUS + 30);
    setlinestyle(SOLID_LINE, 0, THICK_WIDTH);
    circle(midx, midy, RADIUS + 30);
    setlinestyle(SOLID_LINE, 0, NORM_WIDTH);
    for (minute = 0; minute < 60; minute++) {
        place(minute, RADIUS - 4, &x, &y);
        setfillstyle(SOLID_FILL, minute % 5 ? LIGHTGRAY : YELLOW);
        setcolor(minute % 5 ? LIGHTGRAY : YELLOW);
        fillellipse(x, y, minute % 5 ? 1 : 4, minute % 5 ? 1 : 4);
    }
    setcolor(WHITE);
    settextstyle(TRIPLEX_FONT, HORIZ_DIR, 2);
    settextjustify(CENTER_TEXT, CENTER_TEXT);
    for (hour = 1; hour <= 12; hour++) {
        place(hour * 5, RADIUS + 15, &x, &y);
        itoa(hour, text, 10);
        outtextxy(x, y - 3, text);
    }
}

/* A hand with a broad end in the middle. */
void hand(double minute, int length, int color)
{
    int corners[8];

    place(minute, length, &corners[0], &corners[1]);
    place(minute + 15, 7, &corners[2], &corners[3]);
    place(minute + 30, 20, &corners[4], &corners[5]);
    place(minute + 45, 7, &corners[6], &corners[7]);
    setcolor(color);
    setfillstyle(SOLID_FILL, color);
    fillpoly(4, corners);
}

void hands(struct time *t, int hour_color, int minute_color)
{
    hand(t->ti_hour % 12 * 5 + t->ti_min / 12.0, 110, hour_color);
    hand(t->ti_min, 160, minute_color);
}

void second_hand(int second)
{
    int x, y;

    place(second, 165, &x, &y);
    setcolor(LIGHTRED ^ BLUE);          /* on the blue dial it comes out red */
    setwritemode(XOR_PUT);
    line(midx, midy, x, y);
    setwritemode(COPY_PUT);
}

void write_time(struct time *t)
{
    struct date d;
    char        text[60];

    getdate(&d);
    sprintf(text, "%d %s %d   %02d:%02d:%02d", d.da_day, months[d.da_mon - 1],
            d.da_year, t->ti_hour, t->ti_min, t->ti_sec);
    settextstyle(DEFAULT_FONT, HORIZ_DIR, 1);
    settextjustify(CENTER_TEXT, TOP_TEXT);
    setfillstyle(SOLID_FILL, BLACK);
    bar(midx - 160, getmaxy() - 14, midx + 160, getmaxy());
    setcolor(LIGHTGRAY);
    outtextxy(midx, getmaxy() - 12, text);
}

void tick(void)
{
    sound(2000);
    delay(3);
    nosound();
}

void main(void)
{
    int         gdriver = VGA, gmode = VGAHI, error;
    struct time now, shown;

    initgraph(&gdriver, &gmode, "");
    error = graphresult();
    if (error != grOk) {
        printf("Graphics error: %s\n", grapherrormsg(error));
        exit(1);
    }
    midx = getmaxx() / 2;
    midy = getmaxy() / 2 - 10;
    dial();
    gettime(&shown);
    hands(&shown, LIGHTCYAN, WHITE);
    second_hand(shown.ti_sec);
    write_time(&shown);
    while (!kbhit()) {
        delay(20);
        gettime(&now);
        if (now.ti_sec == shown.ti_sec)
            continue;
        second_hand(shown.ti_sec);
        if (now.ti_min != shown.ti_min)
            hands(&shown, BLUE, BLUE);
        hands(&now, LIGHTCYAN, WHITE);
        second_hand(now.ti_sec);
        write_time(&now);
        tick();
        shown = now;
    }
    getch();
    closegraph();
}
