# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C while code that is not Python's works."""

import signal
import threading


class Interrupt:
    """Notes Ctrl-C while it is entered, and hands it to the handler of before at the exit.

    Other threads than the main one get no signals, so there it does nothing. Nor does it replace a
    handler that is not one of Python, such as the one that ignores the signal.
    """

    def __init__(self):
        self._signal = None
        self._before = None

    def is_set(self):
        return self._signal is not None

    def _note(self, *arguments):
        self._signal = arguments

    def __enter__(self):
        is_main = threading.current_thread() is threading.main_thread()
        handler = signal.getsignal(signal.SIGINT)
        if is_main and callable(handler):
            self._before = signal.signal(signal.SIGINT, self._note)
        return self

    def __exit__(self, *_):
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)
        if self.is_set():
            self._before(*self._signal)
            raise KeyboardInterrupt
