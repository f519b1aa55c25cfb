/* SCORES.C: points are kept in a file, and read again letter by letter. */

#include <stdio.h>
#include <conio.h>

#define NAME "SCORES.TXT"

FILE *fp;

void keep(char *name, int points)
{
    fp = fopen(NAME, "a");
    fprintf(fp, "%s %d\n", name, points);
    fputc('*', fp);
    fputs("\n", fp);
    fclose(fp);
}

int main()
{
    FILE *in;
    int c, lines = 0;

    if ((in = fopen(NAME, "r")) == NULL)
        printf("No scores yet.\n");
    else
        fclose(in);
    keep("Ada", 500);
    keep("Charles", 320);
    in = fopen(NAME, "rt");
    if (!in)
        return 1;
    while ((c = getc(in)) != EOF) {
        putchar(c);
        if (c == '\n')
            lines++;
    }
    rewind(in);
    printf("%d lines, the first letter is %c\n", lines, fgetc(in));
    fclose(in);
    return 0;
}
