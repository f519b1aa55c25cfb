/* stdarg.h. */
#include <stdio.h>
#include <stdarg.h>
#include <graphics.h>

int sum(int count, ...)
{
	va_list list;
	int total = 0;
	va_start(list, count);
	while (count-- > 0)
		total += va_arg(list, int);
	va_end(list);
	return total;
}

void mixed(char *kinds, ...)
{
	va_list list;
	va_start(list, kinds);
	for (; *kinds; kinds++)
		switch (*kinds) {
		case 'i': printf("%d ", va_arg(list, int)); break;
		case 'd': printf("%.2f ", va_arg(list, double)); break;
		case 'l': printf("%ld ", va_arg(list, long)); break;
		case 's': printf("%s ", va_arg(list, char *)); break;
		}
	va_end(list);
	putchar('\n');
}

void gprintf(int x, int y, char *format, ...)
{
	char text[80];
	va_list list;
	va_start(list, format);
	vsprintf(text, format, list);
	va_end(list);
	outtextxy(x, y, text);
}

void say(char *format, ...)
{
	va_list list;
	va_start(list, format);
	vprintf(format, list);
	va_end(list);
}

int main(void)
{
	int gd = DETECT, gm;
	printf("%d %d\n", sum(3, 1, 2, 3), sum(0));
	mixed("idsl", 42, 2.5, "text", 100000L);
	say("%s has %d\n", "she", 3);
	initgraph(&gd, &gm, "");
	gprintf(10, 20, "%d,%d %s", 1, 2, "drawn");
	closegraph();
	return 0;
}
