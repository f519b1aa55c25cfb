/* Palettes, drivers and settings of graphics.h. */
#include <graphics.h>
#include <stdio.h>
#include <conio.h>

int main(void)
{
	struct palettetype pal, *first;
	struct text_info info;
	int gd = DETECT, gm, i, lo, hi;
	gettextinfo(&info);
	printf("%d %d %d\n", info.screenwidth, info.screenheight, info.curx);
	initgraph(&gd, &gm, "");
	getpalette(&pal);
	for (i = 0; i < pal.size; i++)
		printf("%d ", pal.colors[i]);
	for (i = 0; i < pal.size; i++)
		pal.colors[i] = i == 3 ? -1 : 63 - i;
	setallpalette(&pal);
	getpalette(&pal);
	printf("%d %d %d\n", pal.colors[2], pal.colors[3], pal.colors[4]);
	first = getdefaultpalette();
	printf("%d %d %d\n", first->size, first->colors[6], first->colors[15]);
	getmoderange(VGA, &lo, &hi);
	setpalette(1, EGA_RED);
	outtextxy(lo, hi, getmodename(getgraphmode()));
	getch();
	closegraph();
	return 0;
}
