"""The types of arrays, named for what is in them."""

import numpy as np
from numpy.typing import NDArray

Doubles = NDArray[np.float64]
"""Numbers of space and of the screen."""
Singles = NDArray[np.float32]
"""The same at half the size, where there is one for every pixel or crossing."""
Ints = NDArray[np.int64]
"""Pixels, colours and places in other arrays."""
Ints32 = NDArray[np.int32]
"""The same at half the size."""
Bools = NDArray[np.bool_]
"""Answers, one for each of something."""

Box = tuple[Doubles, Doubles]
"""The lowest and the highest corner of a box in space, (3,) each."""
