/* math.h and stdlib.h. */
#include <stdio.h>
#include <stdlib.h>
#include <math.h>
#include <limits.h>
#include <float.h>

int main(void)
{
	char s[40], *end;
	double whole, c[3] = { 1, 2, 3 };
	int e, point, sign;
	long l;
	printf("%s %s %s\n", itoa(-255, s, 16), itoa(255, s, 2), itoa(-12, s, 10));
	printf("%s ", ltoa(100000L, s, 10));
	printf("%s\n", ultoa(4000000000UL, s, 16));
	printf("%d %ld %.2f %d\n", atoi("12abc"), atol("-70000"), atof("2.5e1x"), atoi("x"));
	l = strtol("ff zz", &end, 16);
	printf("%ld [%s] ", l, end);
	printf("%.3f ", strtod("3.25rest", &end)); puts(end);
	printf("%s ", gcvt(3.14159, 4, s));
	printf("%s ", ecvt(12.345, 4, &point, &sign));
	printf("%d %d ", point, sign);
	printf("%s ", fcvt(-0.5, 2, &point, &sign)); printf("%d\n", sign);
	printf("%.4f %.4f %.4f %.4f\n", sin(1.0), cos(1.0), tan(1.0), atan2(1.0, -1.0));
	printf("%.4f %.4f %.4f %.4f\n", exp(1.0), log(10.0), log10(1000.0), pow(2.0, 0.5));
	printf("%.1f %.1f %.1f %.1f\n", floor(-1.5), ceil(-1.5), fabs(-2.5), fmod(7.5, 2.0));
	printf("%.2f ", modf(3.75, &whole));
	printf("%.1f ", whole);
	printf("%.3f ", frexp(10.0, &e));
	printf("%d %.1f %.1f %.1f\n", e, ldexp(0.5, 4), hypot(3.0, 4.0), poly(2.0, 2, c));
	printf("%.1f %.4f %.4f %d %ld\n", pow10(3), sinh(1.0), asin(0.5), abs(-5), labs(-70000L));
	srand(5);
	printf("%d %d ", rand(), rand());
	printf("%d %d\n", random(10), random(1000));
	printf("%d %d %ld %u\n", INT_MAX, INT_MIN, LONG_MAX, UINT_MAX);
	printf("%.3e\n", FLT_MAX);
	printf("%d %d\n", max(3, 4), min(3, 4));
	printf("%u %u\n", _rotl(0x8001, 1), _rotr(1, 1));
	printf("[%5d][%-5d][%05d][%+d][%x][%X][%o][%#x]\n", 42, 42, 42, 42, 255, 255, 8, 255);
	printf("[%8.3f][%-8.2f][%e][%g][%g][%c][%5s][%.2s][%%]\n", 3.14159, 2.5, 12345.678, 0.0001,
		1e10, 'x', "ab", "abcdef");
	printf("[%ld][%lu][%u][%*d][%.*f]\n", -100000L, 4000000000UL, 65535u, 6, 7, 2, 1.005);
	return 0;
}
