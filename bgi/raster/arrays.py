"""What numpy does otherwise on a machine of 32 bits, such as WebAssembly's."""

from typing import Any

import numpy as np
from numpy.typing import NDArray


def repeat(values: NDArray[Any], counts: NDArray[np.integer[Any]]) -> NDArray[Any]:
    """Each element as often as its count says; counts of any whole numbers.

    numpy takes no int64 for counts where an address has 32 bits.
    """
    return np.repeat(values, counts.astype(np.intp, copy=False))
