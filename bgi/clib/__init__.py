"""C's library as Turbo C++ 3.0 computed it: pure functions, which know no screen and no keyboard.

Python's whole numbers stay what they are: `%d` shows 70000, where an int of 16 bits was 4464. Bits
count only where a program asks for them: `%u`, `%x` and `%o` of a negative number, `%hd`, and the
functions that are called after a type of C's, such as atoi().
"""
