# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong, and what may have gone otherwise than it was meant."""

import os
import sys

_PACKAGE = os.path.dirname(os.path.abspath(__file__))


class WindingError(RuntimeError):
    """Input was refused, or work could not be finished, in one line that says what to do."""


class WindingMemoryError(WindingError):
    """There is not enough memory for the work."""


class WindingInterrupted(WindingError):
    """The work was to end before it was done."""


class WindingWarning(RuntimeWarning):
    """Work is done, with a result that may not be the one that was meant."""


def levels_above_package():
    """Returns the stacklevel of the first caller outside this package, as warnings counts it."""
    frame, level = sys._getframe(1), 1
    while frame.f_back and os.path.dirname(frame.f_code.co_filename) == _PACKAGE:
        frame, level = frame.f_back, level + 1
    return level
