# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C while code that is not Python's works."""

import signal
import threading


class Interrupt:
    """Hands Ctrl-C to the handler of before while it is entered. What that raises ends the work,
    and is raised at the exit; where it returns, the work goes on.

    Other threads than the main one get no signals, so there it does nothing. Nor does it replace a
    handler that is not one of Python, such as the one that ignores the signal.
    """

    def __init__(self):
        self._failure = None
        self._before = None

    def is_set(self):
        return self._failure is not None

    def _ask(self, *arguments):
        try:
            self._before(*arguments)
        except BaseException as failure:
            self._failure = failure
        outer = getattr(self._before, "__self__", None)  # of a call whose warning is being shown
        if isinstance(outer, Interrupt):
            self._failure = outer._failure

    def __enter__(self):
        is_main = threading.current_thread() is threading.main_thread()
        handler = signal.getsignal(signal.SIGINT)
        if is_main and callable(handler):
            self._before = signal.signal(signal.SIGINT, self._ask)
        return self

    def __exit__(self, *_):
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)
        failure, self._failure = self._failure, None
        if failure is not None:
            raise failure
