/* Files of stdio.h: texts, records and numbers that are written and read again. */
#include <stdio.h>
#include <string.h>

struct point { int x, y; };
struct entry { char name[12]; int score; float share; char grade; struct point place; long when; };

void texts(void)
{
	FILE *f = fopen("LINES.TXT", "w");
	char line[40];
	int c, n, total = 0, count;
	fprintf(f, "first line\n%d %d %d\n", 10, -20, 30);
	fputs("a word\n", f);
	fputc('x', f);
	putc('\n', f);
	fclose(f);
	f = fopen("LINES.TXT", "r");
	printf("%s", fgets(line, 40, f));
	while (fscanf(f, "%d", &n) == 1)
		total += n;
	printf("total %d\n", total);
	fscanf(f, "%s", line);
	c = fgetc(f);
	printf("[%s][%c]", line, c);
	ungetc('<', f);
	for (count = 0; (c = getc(f)) != EOF; count++)
		putchar(c);
	printf("%d more, end %d\n", count, feof(f) != 0);
	clearerr(f);
	printf("%d %d\n", feof(f), ferror(f));
	fclose(f);
	f = fopen("LINES.TXT", "a");
	fprintf(f, "the end");
	fclose(f);
	f = fopen("LINES.TXT", "rt");
	while (fgets(line, sizeof(line), f) != NULL)
		printf("(%s)", line);
	fclose(f);
	if ((f = fopen("NOTHING.TXT", "r")) == NULL)
		puts("there is no such file");
}

void records(void)
{
	struct entry all[3], one;
	int i, numbers[5] = { 1, -2, 300, 32767, -32768 }, back[5];
	double d = 2.5, e = 0;
	FILE *f = fopen("SCORES.DAT", "wb+");
	for (i = 0; i < 3; i++) {
		sprintf(all[i].name, "player %d", i);
		all[i].score = 1000 * i - 5;
		all[i].share = i / 2.0;
		all[i].grade = 'A' + i;
		all[i].place.x = i; all[i].place.y = -i;
		all[i].when = 100000L * i;
	}
	printf("%u\n", (unsigned)fwrite(all, sizeof(struct entry), 3, f));
	fseek(f, (long)sizeof(struct entry), SEEK_SET);
	printf("%u ", (unsigned)fread(&one, sizeof(one), 1, f));
	printf("%s %d %.2f %c %d %d %ld\n", one.name, one.score, one.share, one.grade, one.place.x,
		one.place.y, one.when);
	one.score = 77;
	fseek(f, -(long)sizeof(one), SEEK_CUR);
	fwrite(&one, sizeof(one), 1, f);
	rewind(f);
	i = 0;
	while (fread(&one, sizeof(one), 1, f) == 1)
		printf("%d: %s %d\n", i++, one.name, one.score);
	fclose(f);
	f = fopen("NUMBERS.DAT", "w+b");
	fwrite(numbers, sizeof(numbers), 1, f);
	fwrite(&d, sizeof(double), 1, f);
	putw(-7, f);
	fseek(f, 0L, SEEK_SET);
	fread(back, 2, 5, f);
	fread(&e, sizeof e, 1, f);
	printf("%d %d %d %d %d %.1f %d\n", back[0], back[1], back[2], back[3], back[4], e, getw(f));
	printf("at %ld\n", ftell(f));
	fclose(f);
}

int main(void)
{
	texts();
	records();
	return 0;
}
