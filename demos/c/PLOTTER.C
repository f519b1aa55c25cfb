/* PLOTTER.C: surfaces z = f(x, y), by the map of "A Very Simple Approach
   for 3-D to 2-D Mapping".

   What it shows: two lines of C bring three dimensions to the screen.
   Each patch of the surface is a polygon; they are drawn from the back to
   the front, so what is near hides what is far.

   1 2 3 4 choose the function, left and right turn the x axis, up and down
   change the height, M draws a mesh or colours, Esc ends. */

#include <graphics.h>
#include <stdlib.h>
#include <stdio.h>
#include <conio.h>
#include <math.h>

#define STEPS  40               /* patches along each axis */
#define SIZE   260              /* pixels along the y axis */
#define ESC    27
#define LEFT   75
#define RIGHT  77
#define UP     72
#define DOWN   80

typedef double (*SURFACE)(double x, double y);

double waves(double x, double y)   { return sin(x + y); }
double ripples(double x, double y) { return sin(x * x + y * y); }

double ridge(double x, double y)
{
    double sum = x + y;

    return fabs(sum) < 1e-6 ? 1.0 : sin(sum) / sum;
}

double eggbox(double x, double y)
{
    return sin((x - y) / 1.5) * cos((x + y) / 1.5);
}

struct figure {
    char   *name;
    SURFACE f;
    double  range;              /* x and y go from -range to range */
    double  height;             /* pixels for z = 1 */
} figures[] = {
    { "sin(x+y)",                    waves,   5.0,  40.0 },
    { "sin(x*x+y*y)",                ripples, 2.5,  50.0 },
    { "sin(x+y)/(x+y)",              ridge,   10.0, 110.0 },
    { "sin((x-y)/1.5)cos((x+y)/1.5)", eggbox, 5.0,  50.0 }
};

/* From low to high. */
int ramp[] = { BLUE, LIGHTBLUE, CYAN, GREEN, LIGHTGREEN, YELLOW, LIGHTRED, WHITE };

#define COLORS (sizeof(ramp) / sizeof(ramp[0]))

double theta = M_PI / 4;        /* between the x and the z axis */
double rho = 1.0;               /* how much of z is seen */
int    colored = 0;
int    xs[STEPS + 1][STEPS + 1], ys[STEPS + 1][STEPS + 1];
double zs[STEPS + 1][STEPS + 1];

/* The paper's map: x' = x0 + y - x sin(theta), y' = y0 - rho z + x cos(theta). */
void map(double x, double y, double z, int *px, int *py)
{
    *px = getmaxx() / 2 + floor(y - x * sin(theta) + 0.5);
    *py = getmaxy() / 2 + floor(-rho * z + x * cos(theta) + 0.5);
}

void compute(struct figure *what)
{
    int    i, j;
    double x, y, unit = SIZE / 2 / what->range;

    for (i = 0; i <= STEPS; i++)
        for (j = 0; j <= STEPS; j++) {
            x = what->range * (2.0 * i / STEPS - 1);
            y = what->range * (2.0 * j / STEPS - 1);
            zs[i][j] = what->f(x, y);
            map(x * unit, y * unit, zs[i][j] * what->height, &xs[i][j], &ys[i][j]);
        }
}

void axis(double x, double y, double z, char *name)
{
    int fromx, fromy, tox, toy;

    map(0, 0, 0, &fromx, &fromy);
    map(x, y, z, &tox, &toy);
    line(fromx, fromy, tox, toy);
    outtextxy(tox + 6, toy - 4, name);
}

void axes(void)
{
    setcolor(LIGHTGRAY);
    axis(SIZE, 0, 0, "x");
    axis(0, SIZE, 0, "y");
    axis(0, 0, SIZE * 0.7, "z");
}

void patch(int i, int j)
{
    int    corners[8], level;
    double z = (zs[i][j] + zs[i + 1][j] + zs[i + 1][j + 1] + zs[i][j + 1]) / 4;

    corners[0] = xs[i][j];          corners[1] = ys[i][j];
    corners[2] = xs[i + 1][j];      corners[3] = ys[i + 1][j];
    corners[4] = xs[i + 1][j + 1];  corners[5] = ys[i + 1][j + 1];
    corners[6] = xs[i][j + 1];      corners[7] = ys[i][j + 1];
    level = (z + 1) / 2 * COLORS;
    if (level < 0)
        level = 0;
    if (level >= COLORS)
        level = COLORS - 1;
    if (colored) {
        setcolor(DARKGRAY);
        setfillstyle(SOLID_FILL, ramp[level]);
    } else {
        setcolor(ramp[level]);
        setfillstyle(SOLID_FILL, BLACK);
    }
    fillpoly(4, corners);
}

void plot(struct figure *what)
{
    int  i, j;
    char text[80];

    compute(what);
    cleardevice();
    axes();
    for (i = 0; i < STEPS; i++)         /* x and y grow towards the eye */
        for (j = 0; j < STEPS; j++)
            patch(i, j);
    setcolor(WHITE);
    settextstyle(TRIPLEX_FONT, HORIZ_DIR, 2);
    outtextxy(10, 4, what->name);
    settextstyle(DEFAULT_FONT, HORIZ_DIR, 1);
    sprintf(text, "theta = %.0f degrees, rho = %.1f", theta * 180 / M_PI, rho);
    outtextxy(10, 40, text);
    setcolor(LIGHTGRAY);
    outtextxy(10, getmaxy() - 12, "1 2 3 4  function    arrows  theta, rho    M  mesh    Esc  end");
}

void turn(int scan)
{
    switch (scan) {
    case LEFT:  theta -= M_PI / 36; break;
    case RIGHT: theta += M_PI / 36; break;
    case UP:    rho += 0.1;         break;
    case DOWN:  rho -= 0.1;         break;
    }
    if (theta < M_PI / 36)
        theta = M_PI / 36;
    if (theta > M_PI * 17 / 36)
        theta = M_PI * 17 / 36;
    if (rho < 0.1)
        rho = 0.1;
    if (rho > 1.0)
        rho = 1.0;
}

void main(void)
{
    int gdriver = DETECT, gmode, error, key, which = 1;

    initgraph(&gdriver, &gmode, "C:\\TC\\BGI");
    error = graphresult();
    if (error != grOk) {
        printf("Graphics error: %s\n", grapherrormsg(error));
        exit(1);
    }
    do {
        plot(&figures[which]);
        key = getch();
        if (key >= '1' && key <= '4')
            which = key - '1';
        else if (key == 'm' || key == 'M')
            colored = !colored;
        else if (key == 0)
            turn(getch());
    } while (key != ESC);
    closegraph();
}
