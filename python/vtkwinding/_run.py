"""Runs a filter as Python functions run: with exceptions, warnings, progress and Ctrl-C."""

import contextlib
import os
import re
import threading
import warnings

from vtkmodules.vtkCommonCore import vtkObject

from ._errors import WindingError, WindingWarning, levels_above_package
from ._interrupt import Interrupt
from vtkwinding_native.vtkFiltersWinding import vtkWindingNumberAlgorithm as Filter


def run(algorithm, *, progress_bar=False, message=""):
    """Updates a filter and returns it.

    What it reports as an error is raised as WindingError, what it reports as a warning is warned of
    as WindingWarning. In the main thread Ctrl-C ends the filter within a fraction of a second, and
    raises KeyboardInterrupt. With progress_bar, tqdm shows how far the filter is.
    """
    with contextlib.ExitStack() as stack:
        stack.enter_context(_errors_reported())
        _threads.are_started = True
        errors = _Messages(stack, algorithm, "ErrorEvent")
        notes = _Messages(stack, algorithm, "WarningEvent")
        # The executive speaks of what is wrong before the filter runs, and repeats its failures.
        failures = _Messages(stack, algorithm.GetExecutive(), "ErrorEvent")
        interrupt = stack.enter_context(Interrupt())
        bar = stack.enter_context(_bar(message)) if progress_bar else None
        watch = _Watch(stack, algorithm, interrupt, bar)
        algorithm.Update()
    if watch.failure is not None:
        raise watch.failure
    for error in errors.texts or failures.texts:
        raise WindingError(error)
    for note in notes.texts:
        warnings.warn(note, WindingWarning, stacklevel=levels_above_package())
    return algorithm


@contextlib.contextmanager
def _errors_reported():
    """Has VTK report errors and warnings, which it keeps to itself where its display is off, and
    filters name options by keywords.

    Display and names are those of the whole process: they are as before when the last of several
    threads is through. Messages of filters go to their observers, so nothing is shown.
    """
    with _display.lock:
        if _display.users == 0:
            _display.before = vtkObject.GetGlobalWarningDisplay()
            _display.names_before = Filter.GetNamesInMessages()
            vtkObject.GlobalWarningDisplayOn()
            Filter.SetNamesInMessages(Filter.PYTHON_NAMES)
        _display.users += 1
    try:
        yield
    finally:
        with _display.lock:
            _display.users -= 1
            if _display.users == 0:
                vtkObject.SetGlobalWarningDisplay(_display.before)
                Filter.SetNamesInMessages(_display.names_before)


class _Display:
    def __init__(self):
        self.lock = threading.Lock()
        self.users = 0
        self.before = 1
        self.names_before = Filter.CXX_NAMES


_display = _Display()


class _Threads:
    """Has filters work in one thread in a child of os.fork(), where VTK's threads are gone.

    VTK would wait for them without end. Filters ask this variable of the environment which backend
    of vtkSMPTools was chosen; that of VTK's wheels is Sequential, which they pass over otherwise.
    """

    def __init__(self):
        self.are_started = False
        if hasattr(os, "register_at_fork"):
            os.register_at_fork(after_in_child=self._note_fork)

    def _note_fork(self):
        if self.are_started:
            os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"


_threads = _Threads()


def _observe(stack, reporter, event, callback):
    tag = reporter.AddObserver(event, callback)
    stack.callback(reporter.RemoveObserver, tag)


class _Messages:
    """The texts of the errors or warnings that an object of VTK reports."""

    # VTK puts the file, the class and the address before the text.
    _text = re.compile(r"\(0x[0-9a-fA-F]+\): (.*)", re.DOTALL)

    def __init__(self, stack, reporter, event):
        self.texts = []

        def note(_reporter, _event, text):
            found = self._text.search(text)
            self.texts.append((found[1] if found else text).strip())

        note.CallDataType = "string0"
        _observe(stack, reporter, event, note)


class _Watch:
    """Looks at a filter whenever it tells its progress, and stops it when it is to stop.

    VTK ends the process for some exceptions that leave an observer, so none does.
    """

    def __init__(self, stack, algorithm, interrupt, bar):
        self.failure = None

        def look(_algorithm, _event):
            try:
                if interrupt.is_set():
                    algorithm.SetAbortExecute(1)
                elif bar is not None:
                    bar.update(algorithm.GetProgress() - bar.n)
            except Exception as failure:
                self.failure = failure
                algorithm.SetAbortExecute(1)

        _observe(stack, algorithm, "ProgressEvent", look)


@contextlib.contextmanager
def _bar(message):
    try:
        from tqdm import tqdm
    except ImportError as error:
        raise ImportError("install tqdm to see a progress bar (pip install tqdm)") from error
    with tqdm(total=1, desc=message, bar_format="{l_bar}{bar}[{elapsed}<{remaining}]") as bar:
        yield bar
        bar.update(1 - bar.n)
