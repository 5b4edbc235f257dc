"""Arrays by what they hold, for type checkers."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]
Numbers = npt.NDArray[np.float64]
Bytes = npt.NDArray[np.uint8]
