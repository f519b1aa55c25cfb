/* time.h and the clock of dos.h and bios.h. */
#include <stdio.h>
#include <time.h>
#include <dos.h>
#include <bios.h>

int main(void)
{
	time_t now, later;
	struct tm *t, made;
	struct time clk;
	struct date day;
	struct dostime_t dt;
	struct dosdate_t dd;
	char text[40];
	now = time(NULL);
	t = localtime(&now);
	printf("%d-%02d-%02d %02d:%02d:%02d %d %d\n", t->tm_year + 1900, t->tm_mon + 1, t->tm_mday,
		t->tm_hour, t->tm_min, t->tm_sec, t->tm_wday, t->tm_yday);
	printf("%s%s", asctime(t), ctime(&now));
	strftime(text, 40, "%A, %d %B %Y, %H:%M", t);
	puts(text);
	made = *t;
	made.tm_mday += 20;
	later = mktime(&made);
	printf("%.0f %d %d\n", difftime(later, now), made.tm_mon, made.tm_mday);
	delay(1500);
	gettime(&clk);
	printf("%d:%d:%d.%d\n", clk.ti_hour, clk.ti_min, clk.ti_sec, clk.ti_hund);
	getdate(&day);
	printf("%d %d %d\n", day.da_year, day.da_mon, day.da_day);
	_dos_gettime(&dt);
	_dos_getdate(&dd);
	printf("%d %d %d %d\n", dt.hour, dt.second, dd.year, dd.dayofweek);
	sleep(2);
	printf("%ld %ld\n", biostime(0, 0L), (long)(clock() / CLK_TCK));
	return 0;
}
