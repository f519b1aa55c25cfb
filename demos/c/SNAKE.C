/* SNAKE.C: a snake that grows with what it eats, on the text screen.

   What it shows: conio.h draws with characters of code page 437. kbhit()
   asks for a key without waiting; an arrow is two codes, 0 and its scan
   code. The snake is a ring of places: only head and tail are drawn anew.

   The arrows steer, P pauses, Esc ends. */

#include <conio.h>
#include <stdlib.h>
#include <dos.h>

#define LEFT    2
#define RIGHT   79
#define TOP     3
#define BOTTOM  24
#define LONGEST 400
#define ESC     27

#define WALL  '\xB2'
#define BODY  '\xDB'
#define APPLE '\x03'

typedef struct { int x, y; } place;

place snake[LONGEST];           /* a ring: from tail to head */
int   head, tail, length;
int   dx, dy;
place apple;
int   score;

void put(place at, char what, int color)
{
    textcolor(color);
    gotoxy(at.x, at.y);
    putch(what);
}

int is_snake(place at)
{
    int i, n;

    for (i = tail, n = 0; n < length; n++, i = (i + 1) % LONGEST)
        if (snake[i].x == at.x && snake[i].y == at.y)
            return 1;
    return 0;
}

void new_apple(void)
{
    do {
        apple.x = LEFT + random(RIGHT - LEFT + 1);
        apple.y = TOP + random(BOTTOM - TOP + 1);
    } while (is_snake(apple));
    put(apple, APPLE, LIGHTRED);
}

void write_score(void)
{
    textcolor(YELLOW);
    gotoxy(2, 1);
    cprintf("Snake   apples: %d   length: %d", score, length);
}

void walls(void)
{
    int   i;
    place at;

    for (i = LEFT - 1; i <= RIGHT + 1; i++) {
        at.x = i;
        at.y = TOP - 1;
        put(at, WALL, BLUE);
        at.y = BOTTOM + 1;
        if (i <= RIGHT)                 /* the last cell would scroll the screen */
            put(at, WALL, BLUE);
    }
    for (i = TOP; i <= BOTTOM; i++) {
        at.y = i;
        at.x = LEFT - 1;
        put(at, WALL, BLUE);
        at.x = RIGHT + 1;
        put(at, WALL, BLUE);
    }
}

void begin(void)
{
    int i;

    textmode(C80);
    textbackground(BLACK);
    clrscr();
    _setcursortype(_NOCURSOR);
    walls();
    length = 5;
    tail = 0;
    head = length - 1;
    dx = 1;
    dy = 0;
    score = 0;
    for (i = 0; i < length; i++) {
        snake[i].x = 30 + i;
        snake[i].y = 12;
        put(snake[i], BODY, LIGHTGREEN);
    }
    new_apple();
    write_score();
}

void turn(int newx, int newy)
{
    if (newx != -dx || newy != -dy) {   /* it cannot go back into itself */
        dx = newx;
        dy = newy;
    }
}

/* Returns 0 when the player has had enough. */
int steer(void)
{
    int key = getch();

    if (key == ESC)
        return 0;
    if (key == 'p' || key == 'P')
        getch();
    if (key == 0)
        switch (getch()) {
        case 72: turn(0, -1); break;
        case 80: turn(0, 1);  break;
        case 75: turn(-1, 0); break;
        case 77: turn(1, 0);  break;
        }
    return 1;
}

void eat(void)
{
    score++;
    if (length < LONGEST)
        length++;
    write_score();
    sound(880);
    delay(30);
    nosound();
    new_apple();
}

/* Returns 0 when the snake has hit something. */
int step(void)
{
    place next = snake[head];

    next.x += dx;
    next.y += dy;
    if (next.x < LEFT || next.x > RIGHT || next.y < TOP || next.y > BOTTOM || is_snake(next))
        return 0;
    put(snake[head], BODY, GREEN);
    head = (head + 1) % LONGEST;
    snake[head] = next;
    put(next, BODY, LIGHTGREEN);
    if (next.x == apple.x && next.y == apple.y)
        eat();
    else {
        put(snake[tail], ' ', BLACK);
        tail = (tail + 1) % LONGEST;
    }
    return 1;
}

void main(void)
{
    int playing = 1;

    randomize();
    begin();
    while (playing) {
        delay(dx ? 70 : 110);           /* a character is higher than it is wide */
        if (kbhit())
            playing = steer();
        if (playing)
            playing = step();
    }
    textcolor(WHITE);
    gotoxy(34, 13);
    cprintf(" The end: %d ", score);
    while (kbhit())
        getch();
    getch();
    _setcursortype(_NORMALCURSOR);
    textattr(LIGHTGRAY);
    clrscr();
}
