/* Interrupts: all registers at once, the mouse, the keyboard, DOS. */
#include <dos.h>
#include <stdio.h>
#include <string.h>
#include <bios.h>
#include <conio.h>

int main(void)
{
	union REGS in, out;
	struct REGPACK pack;
	int i;
	in.x.ax = 0;
	int86(0x33, &in, &out);
	printf("%d %d\n", (int)out.x.ax, out.x.bx);
	for (i = 0; i < 6; i++) {
		in.x.ax = 3;
		int86(0x33, &in, &out);
	}
	printf("%d %d %d\n", out.x.bx, out.x.cx, out.x.dx);
	memset(&pack, 0, sizeof(pack));
	pack.r_ax = 3;
	intr(0x33, &pack);
	printf("%d %d\n", pack.r_cx, pack.r_dx);
	in.h.ah = 0x2A;
	intdos(&in, &out);
	printf("%d %d %d\n", out.x.cx, out.h.dh, out.h.dl);
	in.h.ah = 0;
	int86(0x16, &in, &out);
	printf("%x %x\n", out.h.ah, out.h.al);
	_AX = 3;
	geninterrupt(0x33);
	printf("%d %d\n", _CX, _DX);
	printf("%x\n", bioskey(0));
	while (!kbhit())
		;
	printf("%d %d\n", getch(), getch());
	return 0;
}
