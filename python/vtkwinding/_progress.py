# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bars of progress, as tqdm shows them."""

import contextlib


@contextlib.contextmanager
def bar(wanted, message):
    """Yields a function that shows the share of the work that is done; None without a bar."""
    if not wanted:
        yield None
        return
    try:
        from tqdm import tqdm
    except ImportError as error:
        raise ImportError("install tqdm to see a progress bar (pip install tqdm)") from error
    with tqdm(total=1, desc=message, bar_format="{l_bar}{bar}[{elapsed}<{remaining}]") as shown:
        def show(share):
            shown.update(max(0, share - shown.n))

        yield show
        shown.update(1 - shown.n)
