/* string.h, ctype.h and mem.h. */
#include <stdio.h>
#include <string.h>
#include <ctype.h>
#include <mem.h>
#include <stdlib.h>

int up(const void *a, const void *b) { return *(int *)a - *(int *)b; }
int words(const void *a, const void *b) { return strcmp((char *)a, (char *)b); }

struct pair { int key; char name[8]; };
int keys(const void *a, const void *b)
{
	return ((struct pair *)a)->key - ((struct pair *)b)->key;
}

int main(void)
{
	char a[40], b[40], *p;
	int n[6] = { 5, -3, 9, 0, 7, 2 }, m[6], key = 7, i, *found;
	char list[4][8] = { "pear", "apple", "fig", "kiwi" };
	struct pair pairs[3] = { { 3, "c" }, { 1, "a" }, { 2, "b" } };
	strcpy(a, "Turbo");
	strcat(a, " C");
	strncat(a, "++ 3.0", 2);
	printf("%s %u\n", a, (unsigned)strlen(a));
	printf("%d %d %d\n", strcmp(a, "Turbo"), strcmpi("ABC", "abc"), strncmp("abcd", "abxx", 2));
	printf("%d %d\n", stricmp("abd", "ABC"), strnicmp("ABCx", "abcy", 3));
	strncpy(b, "0123456789", 4);
	b[4] = 0;
	printf("%s %s %s\n", b, strrev(b), strset(strcpy(b, "xyz"), '-'));
	printf("%s %s\n", strupr(strcpy(b, "Shout")), strlwr(strcpy(a, "QUIET")));
	strcpy(a, "one, two;three");
	for (p = strtok(a, ",; "); p; p = strtok(NULL, ",; "))
		printf("<%s>", p);
	strcpy(a, "hello world");
	printf("\n%s %s %s %s\n", strchr(a, 'o'), strrchr(a, 'o'), strstr(a, "wor"), strpbrk(a, "wx"));
	printf("%u %u %d\n", (unsigned)strspn(a, "ehl"), (unsigned)strcspn(a, "w"), strchr(a, 'z') == NULL);
	p = strdup("copy");
	printf("%s %s\n", p, strnset(p, '*', 2));
	memset(b, '=', 5);
	b[5] = 0;
	printf("%s %d\n", b, memcmp("abc", "abd", 3) < 0);
	memcpy(m, n, sizeof(n));
	printf("%d %d %d\n", m[0], m[1], m[5]);
	memmove(n + 1, n, 4);
	printf("%d %d %d %d\n", n[0], n[1], n[2], n[3]);
	setmem(m, sizeof(m), 0);
	movmem(n, m, 4);
	printf("%d %d %d\n", m[0], m[1], m[2]);
	memset(m, 0xFF, 4);
	printf("%d %d %d\n", m[0], m[1], m[2]);
	qsort(n, 6, sizeof(int), up);
	for (i = 0; i < 6; i++)
		printf("%d ", n[i]);
	found = (int *)bsearch(&key, n, 6, sizeof(int), up);
	printf("%d\n", found ? *found : -1);
	qsort(list, 4, 8, words);
	printf("%s %s %s %s\n", list[0], list[1], list[2], list[3]);
	qsort(pairs, 3, sizeof(pairs[0]), keys);
	printf("%s%s%s\n", pairs[0].name, pairs[1].name, pairs[2].name);
	printf("%d%d%d%d%d%d\n", isalpha('x') != 0, isdigit('x') != 0, isspace('\t') != 0,
		isupper('A') != 0, ispunct('!') != 0, isxdigit('g') != 0);
	printf("%c%c%d\n", toupper('q'), tolower('Q'), toascii(200));
	return 0;
}
