/* io.h and dir.h. */
#include <stdio.h>
#include <io.h>
#include <fcntl.h>
#include <string.h>
#include <dir.h>

int main(void)
{
	char buffer[20], drive[4], dir[70], name[10], ext[6];
	struct ffblk found;
	int h = open("RAW.BIN", O_CREAT | O_RDWR | O_BINARY, 0600);
	printf("%d\n", write(h, "hello, handle", 13));
	printf("%ld %ld\n", tell(h), filelength(h));
	lseek(h, 7L, SEEK_SET);
	memset(buffer, 0, sizeof buffer);
	printf("%d %s %d\n", read(h, buffer, 10), buffer, eof(h));
	printf("%d %d\n", close(h), close(h));
	printf("%d %d\n", access("RAW.BIN", 0), access("NONE.BIN", 0));
	h = open("NONE.BIN", O_RDONLY);
	printf("%d\n", h);
	printf("%d\n", findfirst("*.DAT", &found, 0));
	printf("%d\n", remove("NONE.BIN"));
	fnsplit("NAME.EXT", drive, dir, name, ext);
	printf("%s %s\n", name, ext);
	puts(getcwd(NULL, 80));
	return 0;
}
