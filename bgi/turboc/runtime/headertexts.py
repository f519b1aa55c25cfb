"""Headers that are C themselves: macros, and classes that are written in the language."""

_COMPLEX = """
class complex {
    double re, im;
public:
    complex(double r = 0, double i = 0) { re = r; im = i; }
    double re_() { return re; }
    double im_() { return im; }
    complex operator-() { return complex(-re, -im); }
    complex operator+() { return *this; }
    complex &operator+=(complex z) { re += z.re; im += z.im; return *this; }
    complex &operator-=(complex z) { re -= z.re; im -= z.im; return *this; }
    complex &operator*=(complex z)
    { double r = re * z.re - im * z.im; im = re * z.im + im * z.re; re = r; return *this; }
    complex &operator/=(complex z)
    { double n = z.re * z.re + z.im * z.im, r = (re * z.re + im * z.im) / n;
      im = (im * z.re - re * z.im) / n; re = r; return *this; }
};
double real(complex z) { return z.re_(); }
double imag(complex z) { return z.im_(); }
double norm(complex z) { return z.re_() * z.re_() + z.im_() * z.im_(); }
double abs(complex z) { return sqrt(norm(z)); }
double arg(complex z) { return atan2(z.im_(), z.re_()); }
complex conj(complex z) { return complex(z.re_(), -z.im_()); }
complex polar(double size, double angle = 0)
{ return complex(size * cos(angle), size * sin(angle)); }
complex operator+(complex a, complex b) { a += b; return a; }
complex operator-(complex a, complex b) { a -= b; return a; }
complex operator*(complex a, complex b) { a *= b; return a; }
complex operator/(complex a, complex b) { a /= b; return a; }
int operator==(complex a, complex b) { return a.re_() == b.re_() && a.im_() == b.im_(); }
int operator!=(complex a, complex b) { return !(a == b); }
complex exp(complex z) { return polar(exp(z.re_()), z.im_()); }
complex log(complex z) { return complex(log(abs(z)), arg(z)); }
complex sqrt(complex z) { return polar(sqrt(abs(z)), arg(z) / 2); }
complex pow(complex z, complex power) { return abs(z) == 0 ? complex(0) : exp(power * log(z)); }
complex pow(complex z, double power) { return pow(z, complex(power)); }
complex sin(complex z)
{ return complex(sin(z.re_()) * cosh(z.im_()), cos(z.re_()) * sinh(z.im_())); }
complex cos(complex z)
{ return complex(cos(z.re_()) * cosh(z.im_()), -sin(z.re_()) * sinh(z.im_())); }
ostream &operator<<(ostream &out, complex z)
{ return out << "(" << z.re_() << ", " << z.im_() << ")"; }
"""

TEXTS = {
    "stdarg.h": """
        #define va_start(list, last) (list = _va_begin(_more))
        #define va_arg(list, type) (*(type *)_va_next(list))
        #define va_end(list) ((void)0)
        """,
    "stdlib.h": """
        #ifndef __cplusplus
        #define max(a, b) (((a) > (b)) ? (a) : (b))
        #define min(a, b) (((a) < (b)) ? (a) : (b))
        #endif
        """,
    "assert.h": """
        #ifdef NDEBUG
        #define assert(condition) ((void)0)
        #else
        #define assert(condition) ((condition) || _assertion(#condition, __FILE__, __LINE__))
        #endif
        """,
    "signal.h": """
        #define SIG_DFL ((void *)0)
        #define SIG_IGN ((void *)0)
        #define SIG_ERR ((void *)0)
        #define raise(number) _raise(number)
        """,
    "complex.h": _COMPLEX,
}
"""What stands in a header, besides the functions, constants and types of the library."""

REFUSED = {
    **dict.fromkeys(
        ("setjmp", "longjmp", "jmp_buf"), "cannot be: a function that has ended cannot go on"
    ),
    **dict.fromkeys(
        ("absread", "abswrite", "biosdisk_", "getfat", "getfatd", "getdfree", "_dos_getdiskfree"),
        "cannot be: the program may not see the disks",
    ),
    **dict.fromkeys(
        ("allocmem", "freemem", "setblock", "brk", "sbrk", "_dos_allocmem", "_dos_freemem"),
        "cannot be: there are no blocks of DOS memory; use farmalloc()",
    ),
    **dict.fromkeys(
        ("farheapwalk", "heapwalk", "farheapchecknode", "farheapfillfree", "farheapcheckfree"),
        "cannot be: the heap has no nodes to walk over",
    ),
    **dict.fromkeys(
        ("getdta", "setdta", "getpsp", "randbrd", "randbwr", "parsfnm", "getswitchar", "dosexterr"),
        "cannot be: there is no DOS beneath the program",
    ),
    **dict.fromkeys(("_OvrInitEms", "_OvrInitExt", "_overlay"), "cannot be: there are no overlays"),
    **dict.fromkeys(
        ("offsetof",), "cannot be: members do not lie one behind the other in memory here"
    ),
    **dict.fromkeys(("cabs", "matherr"), "is not here; complex.h has abs() for complex numbers"),
    **dict.fromkeys(("bcd",), "cannot be: there are no decimal numbers here; double is near"),
    **dict.fromkeys(
        ("ioctl", "lock", "unlock", "locking", "getftime", "setftime", "umask", "stat", "fstat"),
        "is not here: files have neither locks nor marks",
    ),
    **dict.fromkeys(
        ("localeconv", "country", "mblen", "mbtowc", "wctomb", "mbstowcs", "wcstombs"),
        "is not here: there is one language, C's own",
    ),
}
"""Names of the headers that are not here, and why."""
