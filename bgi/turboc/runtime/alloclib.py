"""alloc.h, and what searches and sorts memory: malloc(), memcpy(), qsort() and their like."""

from __future__ import annotations

from functools import cmp_to_key
from typing import Any

from bgi.turboc.runtime.binding import Function
from bgi.turboc.runtime.memory import MOST_BYTES, Allocated, Pointer, Record, copied
from bgi.turboc.runtime.plaindata import Plain

DECLARATIONS = """
void *malloc(unsigned long n); void *calloc(unsigned long n, unsigned long size);
void *realloc(void *p, unsigned long n); void free(void *p); void *farmalloc(unsigned long n);
void *farcalloc(unsigned long n, unsigned long size); void farfree(void *p);
void *farrealloc(void *p, unsigned long n); unsigned coreleft(void);
unsigned long farcoreleft(void); void *_graphgetmem(unsigned n);
void _graphfreemem(void *p, unsigned n); int heapcheck(void); int farheapcheck(void);
int heapcheckfree(unsigned fill); int heapfillfree(unsigned fill); int heapchecknode(void *node);
void *memset(data to, int c, unsigned n); void *memcpy(data to, data from, unsigned n);
void *memmove(data to, data from, unsigned n); int memcmp(data a, data b, unsigned n);
int memicmp(data a, data b, unsigned n); void *memchr(data p, int c, unsigned n);
void *memccpy(data to, data from, int c, unsigned n); void movmem(data from, data to, unsigned n);
void setmem(data to, unsigned n, char c); void swab(data from, data to, int n);
void *_fmemset(data to, int c, unsigned n); void *_fmemcpy(data to, data from, unsigned n);
void *_fmemmove(data to, data from, unsigned n); int _fmemcmp(data a, data b, unsigned n);
int _fmemicmp(data a, data b, unsigned n); void *_fmemchr(data p, int c, unsigned n);
void *_fmemccpy(data to, data from, int c, unsigned n); void _fmovmem(data f, data to, unsigned n);
void _fsetmem(data to, unsigned n, char c); void *halloc(long n, unsigned size);
void hfree(void *p); void *_fmalloc(unsigned n); void *_nmalloc(unsigned n);
void _ffree(void *p); void _nfree(void *p);
void *alloca(unsigned n); unsigned stackavail(void); unsigned _memavl(void); int _heapmin(void);
void qsort(data base, unsigned n, unsigned size, void *compare);
void *bsearch(void *key, data base, unsigned n, unsigned size, void *compare);
void *lfind(void *key, data base, unsigned *n, unsigned size, void *compare);
void *lsearch(data key, data base, unsigned *n, unsigned size, void *compare);
"""

_HEAP_OK = 1


def malloc(n: int) -> Pointer | None:
    """Bytes that become whatever the program takes them for; None if there are not so many."""
    if not 0 <= n < MOST_BYTES - Allocated.taken:
        return None
    return Pointer(Allocated(n + 16))


def realloc(pointer: Pointer | None, n: int) -> Pointer | None:
    """More bytes, with the old ones copied."""
    if pointer is None:
        return malloc(n)
    old = pointer.memory
    if isinstance(old, bytearray):
        made = malloc(n)
        if made is not None:
            made.memory[: min(n, len(old))] = old[:n]
        return made
    if n < MOST_BYTES:
        old.extend([copied(old[-1]) for _ in range(max(n - len(old), 0))])
    return pointer


def memset(to: Plain, c: int, n: int) -> Pointer:
    """Fill memory with a byte."""
    if n > MOST_BYTES:
        raise IndexError(n)
    to.put(bytes([c & 0xFF]) * n)
    return to.pointer  # type: ignore[no-any-return]


def memcpy(to: Plain, source: Plain, n: int) -> Pointer:
    """Copy memory; objects of a kind are copied whole, with what they point to."""
    target, origin = to.pointer, source.pointer
    alike = not isinstance(target.memory, bytearray) and not isinstance(origin.memory, bytearray)
    count = source.elements(n) if alike and to.layout == source.layout else None
    if count is None:
        to.put(source.get(n))
    else:
        values = [copied(origin.memory[origin.at + place]) for place in range(count)]
        for place, value in enumerate(values, target.at):
            if isinstance(value, Record):
                target.memory[place].assign(value)
            else:
                target.memory[place] = value
    return target  # type: ignore[no-any-return]


def _compared(a: bytes, b: bytes) -> int:
    return int(a > b) - int(a < b)


def memchr(memory: Plain, c: int, n: int) -> Pointer | None:
    """The first of a byte, None if there is none."""
    at = memory.get(n).find(c & 0xFF)
    return memory.pointer + at if at >= 0 else None


def memccpy(to: Plain, source: Plain, c: int, n: int) -> Pointer | None:
    """Copy up to a byte; what is behind it is the answer."""
    data = source.get(n)
    end = data.find(c & 0xFF) + 1
    to.put(data[:end] if end else data)
    return to.pointer + end if end else None


def _swapped(source: Plain, to: Plain, n: int) -> None:
    """Copy pairs of bytes, each turned round."""
    data = bytearray(source.get(n & ~1))
    data[0::2], data[1::2] = data[1::2], data[0::2]
    to.put(bytes(data))


def _stride(base: Plain, size: int) -> int:
    """How many elements of its memory one of `size` bytes is."""
    return base.elements(size) or 1


def _elements(base: Plain, n: int, size: int) -> list[Pointer]:
    """Pointers to the elements of an array."""
    stride = _stride(base, size)
    return [base.pointer + place * stride for place in range(n)]


def qsort(base: Plain, n: int, size: int, compare: Any) -> None:
    """Sort by a function of the program."""
    memory, at, stride = base.pointer.memory, base.pointer.at, _stride(base, size)
    parts = [memory[at + i * stride : at + (i + 1) * stride] for i in range(n)]
    key = cmp_to_key(lambda a, b: compare(Pointer(a), Pointer(b)))
    parts.sort(key=key)
    memory[at : at + n * stride] = [one for part in parts for one in part]


def lfind(key: Pointer, base: Plain, n: Pointer, size: int, compare: Any) -> Pointer | None:
    """The first element that is like a key."""
    every = _elements(base, n.memory[n.at], size)
    return next((one for one in every if compare(key, one) == 0), None)


def bsearch(key: Pointer, base: Plain, n: int, size: int, compare: Any) -> Pointer | None:
    """The element of a sorted array that is like a key."""
    every = _elements(base, n, size)
    low, high = 0, n
    while low < high:
        middle = (low + high) // 2
        order = compare(key, every[middle])
        if order == 0:
            return every[middle]
        low, high = (low, middle) if order < 0 else (middle + 1, high)
    return None


def lsearch(key: Plain, base: Plain, n: Pointer, size: int, compare: Any) -> Pointer:
    """The first element that is like a key, which is added if there is none."""
    found = lfind(key.pointer, base, n, size, compare)
    if found is None:
        found = base.pointer + n.memory[n.at] * _stride(base, size)
        n.memory[n.at] += 1
        Plain(found, base.layout).put(key.get(size))
    return found


_ALLOCATING = "malloc farmalloc _graphgetmem _fmalloc _nmalloc alloca"
_FREEING = "free farfree _graphfreemem hfree _ffree _nfree"

_FUNCTIONS: dict[str, Function] = {
    **dict.fromkeys(
        ("malloc", "farmalloc", "_graphgetmem", "_fmalloc", "_nmalloc", "alloca"), malloc
    ),
    **dict.fromkeys(("calloc", "farcalloc", "halloc"), lambda n, size: malloc(n * size)),
    **dict.fromkeys(("realloc", "farrealloc"), realloc),
    **dict.fromkeys(_FREEING.split(), lambda *given: None),
    **{"coreleft": lambda: 60000, "farcoreleft": lambda: 400000},
    **dict.fromkeys(("heapcheck", "farheapcheck"), lambda: _HEAP_OK),
    **dict.fromkeys(("heapcheckfree", "heapfillfree", "heapchecknode"), lambda one: _HEAP_OK),
    **dict.fromkeys(("memset", "_fmemset"), memset),
    **dict.fromkeys(("memcpy", "memmove", "_fmemcpy", "_fmemmove"), memcpy),
    **dict.fromkeys(("memcmp", "_fmemcmp"), lambda a, b, n: _compared(a.get(n), b.get(n))),
    **dict.fromkeys(("stackavail", "_memavl"), lambda: 60000),
    **{"_heapmin": lambda: 0},
    "memicmp": lambda a, b, n: _compared(a.get(n).lower(), b.get(n).lower()),
    **{"memchr": memchr, "memccpy": memccpy, "swab": _swapped},
    "movmem": lambda source, to, n: (memcpy(to, source, n), None)[1],
    "setmem": lambda to, n, c: (memset(to, c, n), None)[1],
    **{"qsort": qsort, "bsearch": bsearch, "lfind": lfind, "lsearch": lsearch},
}

_FAR = "memicmp memchr memccpy movmem setmem"
FUNCTIONS = {**_FUNCTIONS, **{f"_f{name}": _FUNCTIONS[name] for name in _FAR.split()}}
