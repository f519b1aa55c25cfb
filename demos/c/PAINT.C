/* PAINT.C: a picture painted with the mouse.

   What it shows: the mouse's driver is asked through interrupt 33h. Function
   0 looks for a mouse, 1 and 2 show and hide the pointer, 3 tells the
   buttons and the place; the pointer is hidden while something is drawn.

   The left button paints, and takes a colour or a tool below the picture;
   the right one fills an area. Esc ends. */

#include <graphics.h>
#include <stdlib.h>
#include <stdio.h>
#include <conio.h>
#include <dos.h>

#define ESC    27
#define BOX    32               /* each of the boxes below the picture */
#define BORDER (480 - BOX - 8)  /* where the picture ends */
#define LEFT_BUTTON  1
#define RIGHT_BUTTON 2

enum tool { BRUSH, LINES, BOXES, TOOLS };

static char *names[TOOLS] = { "brush", "line", "box" };

int color = WHITE;
enum tool tool = BRUSH;

/* Ask the mouse driver; what it answers comes back in the registers. */
void mouse(int function, union REGS *r)
{
    r->x.ax = function;
    int86(0x33, r, r);
}

int look(int *x, int *y)
{
    static union REGS r;

    mouse(3, &r);
    *x = r.x.cx;
    *y = r.x.dx;
    return r.x.bx;
}

void show_pointer(int visible)
{
    static union REGS r;

    mouse(visible ? 1 : 2, &r);
}

void draw_boxes(void)
{
    int i, left, top = BORDER + 6;

    setcolor(WHITE);
    line(0, BORDER, getmaxx(), BORDER);
    settextjustify(CENTER_TEXT, CENTER_TEXT);
    for (i = 0; i < 16; i++) {
        left = 4 + i * BOX;
        setfillstyle(SOLID_FILL, i);
        bar(left + 2, top + 2, left + BOX - 4, top + BOX - 4);
        setcolor(i == color ? YELLOW : DARKGRAY);
        rectangle(left, top, left + BOX - 2, top + BOX - 2);
    }
    for (i = 0; i < TOOLS; i++) {
        left = 520 + i * 40;
        setfillstyle(SOLID_FILL, i == tool ? BLUE : BLACK);
        bar(left, top, left + 37, top + BOX - 2);
        setcolor(i == tool ? YELLOW : LIGHTGRAY);
        rectangle(left, top, left + 37, top + BOX - 2);
        settextstyle(SMALL_FONT, HORIZ_DIR, 4);
        outtextxy(left + 19, top + BOX / 2 - 3, names[i]);
    }
}

void choose(int x)
{
    if (x >= 520)
        tool = (enum tool)((x - 520) / 40 % TOOLS);
    else if (x >= 4 && (x - 4) / BOX < 16)
        color = (x - 4) / BOX;
    show_pointer(0);
    draw_boxes();
    show_pointer(1);
}

void outline(int x1, int y1, int x2, int y2)
{
    if (tool == LINES)
        line(x1, y1, x2, y2);
    else
        rectangle(x1, y1, x2, y2);
}

/* A line or a box follows the mouse, in XOR, until the button is let go. */
void stretch(int x, int y)
{
    int tox = x, toy = y, newx, newy;

    setcolor(WHITE);
    setwritemode(XOR_PUT);
    outline(x, y, tox, toy);
    while (look(&newx, &newy) & LEFT_BUTTON) {
        if (newx != tox || newy != toy) {
            outline(x, y, tox, toy);
            tox = newx;
            toy = newy;
            outline(x, y, tox, toy);
        }
        delay(10);
    }
    outline(x, y, tox, toy);
    setwritemode(COPY_PUT);
    setcolor(color);
    outline(x, y, tox, toy);
}

void brush(int x, int y)
{
    int newx, newy;

    setcolor(color);
    setlinestyle(SOLID_LINE, 0, THICK_WIDTH);
    do {
        if (look(&newx, &newy) == 0)
            break;
        show_pointer(0);
        line(x, y, newx, newy);
        show_pointer(1);
        x = newx;
        y = newy;
        delay(10);
    } while (1);
    setlinestyle(SOLID_LINE, 0, NORM_WIDTH);
}

void press(int buttons, int x, int y)
{
    if (y >= BORDER) {
        choose(x);
        return;
    }
    show_pointer(0);
    setviewport(0, 0, getmaxx(), BORDER - 1, 1);
    if (buttons & RIGHT_BUTTON) {
        setfillstyle(SOLID_FILL, color);
        floodfill(x, y, color);
    } else if (tool == BRUSH)
        brush(x, y);
    else
        stretch(x, y);
    setviewport(0, 0, getmaxx(), getmaxy(), 1);
    show_pointer(1);
}

void main(void)
{
    int        gdriver = VGA, gmode = VGAHI, error, buttons, x, y, key = 0;
    static union REGS r;

    mouse(0, &r);
    if (r.x.ax == 0) {
        printf("This program needs a mouse.\n");
        exit(1);
    }
    initgraph(&gdriver, &gmode, "");
    error = graphresult();
    if (error != grOk) {
        printf("Graphics error: %s\n", grapherrormsg(error));
        exit(1);
    }
    draw_boxes();
    show_pointer(1);
    while (key != ESC) {
        buttons = look(&x, &y);
        if (buttons)
            press(buttons, x, y);
        if (kbhit())
            key = getch();
        delay(10);
    }
    closegraph();
}
