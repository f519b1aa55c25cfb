"""The skeleton of EURO and BOLD: square letters with round corners, drawn for this project.

One letter a line, in the language of `rounded_drawing`, in EURO's units: capitals 42 high, small
letters 30, descenders 10 deep. A point followed by `r` is a corner to be rounded, `z` closes a
path.
"""

import math

from tools.fonts.strokes import Glyph, Path, mirrored, rounded

RADIUS = 9
_STEPS = 4  # lines in a rounded corner

_LETTERS = """
! 0,42 0,12; 0,0 0,3
" 0,42 0,33; 8,42 8,33
# 6,4 6,38; 15,4 15,38; 0,14 21,14; 0,28 21,28
$ 26,32 26,42r 0,42r 0,22r 26,22r 26,0r 0,0r 0,10; 13,47 13,42; 13,0 13,-5
% 0,24r 0,42r 16,42r 16,24r z; 32,0r 32,18r 48,18r 48,0r z; 40,42 8,0
& 34,0 7,31 7,42r 23,42r 23,28r 0,17r 0,0r 25,0r 32,18
' 0,42 0,33
( 8,46 0,37r 0,-1r 8,-10
) 0,46 8,37r 8,-1r 0,-10
* 9,42 9,22; 0,37 18,27; 18,37 0,27
+ 0,20 26,20; 13,33 13,7
, 4,3 4,0 0,-8
- 2,20 24,20
. 0,0 0,3 3,3 3,0 z
/ 0,-4 13,46
0 0,0r 0,42r 26,42r 26,0r z
1 5,33 16,42 16,0
2 0,33 0,42r 26,42r 26,22r 0,22r 0,0 26,0
3 0,34 0,42r 25,42r 25,22r 7,22; 19,22 26,22r 26,0r 0,0r 0,8
4 20,0 20,42 0,12 27,12
5 25,42 2,42 0,24 26,24r 26,0r 0,0r 0,8
6 25,34 25,42r 0,42r 0,0r 26,0r 26,24r 0,24
7 0,42 26,42 9,0
8 1,22r 1,42r 25,42r 25,22r z; 0,0r 0,22r 26,22r 26,0r z
9 1,8 1,0r 26,0r 26,42r 0,42r 0,18r 26,18
: 0,3 0,0; 0,25 0,22
; 4,25 4,22; 4,3 4,0 0,-8
< 22,35 0,20 22,5
= 0,26 22,26; 0,14 22,14
> 0,35 22,20 0,5
? 0,33 0,42r 24,42r 24,24r 12,24r 12,11; 12,3 12,0
@ 18,28 7,28r 7,13r 18,13; 18,28 18,13 25,13 25,42r 0,42r 0,0r 25,0
A 0,0 15,42 30,0; 5,14 25,14
B 0,22 0,42 24,42r 24,22r 0,22; 0,22 26,22r 26,0r 0,0 0,22
C 28,31 28,42r 0,42r 0,0r 28,0r 28,11
D 0,0 0,42 29,42r 29,0r z
E 24,42 0,42 0,0 24,0; 0,22 20,22
F 23,42 0,42 0,0; 0,22 19,22
G 29,32 29,42r 0,42r 0,0r 29,0r 29,21 17,21
H 0,0 0,42; 27,0 27,42; 0,22 27,22
I 0,0 0,42
J 21,42 21,0r 0,0r 0,12
K 0,0 0,42; 26,42 0,18; 8,25 26,0
L 0,42 0,0 21,0
M 0,0 0,42 18,10 36,42 36,0
N 0,0 0,42 28,0 28,42
O 0,0r 0,42r 30,42r 30,0r z
P 0,0 0,42 26,42r 26,20r 0,20
Q 0,0r 0,42r 30,42r 30,0r z; 16,15 33,-6
R 0,0 0,42 25,42r 25,20r 0,20; 13,20 26,0
S 26,32 26,42r 0,42r 0,22r 26,22r 26,0r 0,0r 0,10
T 0,42 26,42; 13,42 13,0
U 0,42 0,0r 27,0r 27,42
V 0,42 14,0 28,42
W 0,42 11,0 23,42 35,0 46,42
X 0,0 28,42; 0,42 28,0
Y 0,42 14,20 28,42; 14,20 14,0
Z 0,42 27,42 0,0 27,0
[ 8,45 0,45 0,-9 8,-9
\\ 0,46 13,-4
] 0,45 8,45 8,-9 0,-9
^ 0,31 9,42 18,31
_ 0,-7 32,-7
` 6,44 13,35
a 1,30 20,30r 20,0 0,0r 0,17r 20,17
b 0,42 0,0 21,0r 21,30r 0,30
c 20,22 20,30r 0,30r 0,0r 20,0r 20,8
d 21,42 21,0 0,0r 0,30r 21,30
e 0,15 21,15 21,30r 0,30r 0,0r 20,0
f 15,42 5,42r 5,0; 0,30 13,30
g 21,0 0,0r 0,30r 21,30 21,-10r 2,-10
h 0,42 0,0; 0,30 20,30r 20,0
i 0,0 0,30; 0,42 0,39
j 5,30 5,-10r 0,-10; 5,42 5,39
k 0,42 0,0; 18,30 0,13; 6,19 18,0
l 0,42 0,0
m 0,0 0,30 34,30r 34,0; 17,30 17,0
n 0,0 0,30 20,30r 20,0
o 0,0r 0,30r 21,30r 21,0r z
p 0,-10 0,30 21,30r 21,0r 0,0
q 21,-10 21,30 0,30r 0,0r 21,0
r 0,0 0,30 17,30r 17,22
s 19,30 0,30r 0,16r 20,16r 20,0r 0,0
t 6,40 6,0r 19,0; 0,30 18,30
u 0,30 0,0r 20,0; 20,30 20,0
v 0,30 11,0 22,30
w 0,30 8,0 16,30 24,0 32,30
x 0,0 21,30; 0,30 21,0
y 0,30 0,0r 20,0; 20,30 20,-10r 1,-10
z 0,30 19,30 0,0 19,0
{ 8,45 4,45r 4,22r 0,18 4,14r 4,-9r 8,-9
| 0,45 0,-10
~ 0,16 0,23r 12,23r 13,16r 25,16r 25,23
"""

# What would look pieced together if it were composed of letters, by code of page 437.
_LIGATURES = """
145 1,30 17,30r 17,0 0,0r 0,17r 17,17; 17,15 34,15 34,30r 17,30; 17,0 33,0
146 0,0 18,42 43,42; 22,42 22,0 43,0; 22,22 39,22; 6,14 22,14
155 20,22 20,30r 0,30r 0,0r 20,0r 20,8; 10,36 10,30; 10,0 10,-6
157 0,42 14,22 28,42; 14,22 14,0; 4,18 24,18; 4,9 24,9
158 0,0 0,42 22,42r 22,22r 0,22; 34,36 34,0r 44,0; 28,26 44,26
"""


def rounded_drawing(text: str, most: float) -> Glyph:
    """Read a glyph written as `x,y x,yr ...; ... z`: `r` rounds a corner, `z` closes a path."""
    return [_path(part.split(), most) for part in text.split(";")]


def _path(words: list[str], most: float) -> Path:
    closed = words[-1] == "z"
    corners = [word.rstrip("r").split(",") for word in words[: -1 if closed else None]]
    points = [(int(x), int(y)) for x, y in corners]
    soft = [word.endswith("r") for word in words]
    path: Path = []
    for place, point in enumerate(points):
        if soft[place]:
            before, after = place - 1, (place + 1) % len(points)
            radius = min(
                most,
                math.dist(points[before], point) / (1 + soft[before]),
                math.dist(point, points[after]) / (1 + soft[after]),
            )
            path += _corner(points[before], point, points[after], radius)
        else:
            path.append(point)
    return path + path[:1] if closed else path


def _corner(
    before: tuple[int, int], point: tuple[int, int], after: tuple[int, int], radius: float
) -> Path:
    """A quarter of an ellipse in place of a corner."""
    (ax, ay), (bx, by) = (_toward(point, end, radius) for end in (before, after))
    path: Path = []
    for step in range(_STEPS + 1):
        angle = math.pi / 2 * step / _STEPS
        a, b = 1 - math.sin(angle), 1 - math.cos(angle)
        x = point[0] + (ax - point[0]) * a + (bx - point[0]) * b
        y = point[1] + (ay - point[1]) * a + (by - point[1]) * b
        path.append((rounded(x), rounded(y)))
    return path


def _toward(point: tuple[int, int], end: tuple[int, int], way: float) -> tuple[float, float]:
    part = way / math.dist(point, end)
    return point[0] + (end[0] - point[0]) * part, point[1] + (end[1] - point[1]) * part


def letters(radius: float = RADIUS) -> dict[int, Glyph]:
    """The skeletons of codes 33..126, their corners rounded by at most `radius`."""
    lines = (line.split(" ", 1) for line in _LETTERS.strip().splitlines())
    found = {ord(character): rounded_drawing(text, radius) for character, text in lines}
    found[ord("}")] = mirrored(found[ord("{")])
    return found


def ligatures(radius: float = RADIUS) -> dict[int, Glyph]:
    """ae, AE, cent, yen, peseta."""
    lines = (line.split(" ", 1) for line in _LIGATURES.strip().splitlines())
    return {int(code): rounded_drawing(text, radius) for code, text in lines}
