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

_REASONS = {
    "cannot be: a function that has ended cannot go on": "setjmp longjmp",
    "cannot be: the program may not see the disks": """absread abswrite getfat getfatd getdfree
        _dos_getdiskfree _dos_commit""",
    "cannot be: there are no blocks of DOS memory; use farmalloc()": """allocmem freemem setblock
        brk sbrk _dos_allocmem _dos_freemem _dos_setblock""",
    "cannot be: the heap has no nodes to walk over": """farheapwalk heapwalk farheapchecknode
        farheapfillfree farheapcheckfree _expand _heapadd _heapchk _heapset _heapwalk _msize""",
    "cannot be: there is no DOS beneath the program": """getdta setdta getpsp randbrd randbwr
        parsfnm getswitchar dosexterr _dos_keep _OvrInitEms _OvrInitExt""",
    "cannot be: no other program is started": "cwait wait _popen _pclose _pipe",
    "cannot be: members do not lie one behind the other in memory here": "offsetof",
    "is not here; complex.h has abs() for complex numbers": "cabs cabsl",
    "is not here: what a function of math.h cannot compute is inf or nan": """matherr matherrl
        _matherr _matherrl""",
    "is not here: there are no decimal numbers; double is near": "bcd",
    "is not here: files have neither locks nor marks": """ioctl lock unlock locking getftime
        setftime umask stat fstat utime _dos_getftime _dos_setftime""",
    "is not here: there is one language, C's own": """localeconv country mblen mbtowc wctomb
        mbstowcs wcstombs""",
}

REFUSED = {name: why for why, names in _REASONS.items() for name in names.split()}
"""Names of the headers that are not here, and why."""
