# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all filters of the plugin have in common: properties by the XML, errors in one line,
warnings, progress and abort."""

import contextlib
import ctypes
import math
import pathlib
import re
import time

import numpy as np
from vtkmodules.util.numpy_support import create_vtk_array, get_vtk_array_type, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

from vtkwinding import _library
from vtkwinding._errors import WindingError, WindingInterrupted, WindingMemoryError
from vtkwinding._library import sentence

from . import declarations
from .ranks import words_of_unexpected

FOLDER = pathlib.Path(__file__).resolve().parent.parent
DECLARED = declarations.properties_of(FOLDER / "xml")
DONE, REFUSED, OUT_OF_MEMORY, ABORTED, NOT_RUN = range(5)
METHODS = ("automatic", "rows", "hierarchical", "direct", "parity")
ESTIMATIONS = ("automatic", "spanning tree", "winding consistent", "viewpoint")
RUN = _library.RUN
_OF_EACH_RANK = ("NumberOfThreads", "LongestExpectedTime", "VerifySamples")


def declared(kind):
    """Gives a class the properties that the XML declares for it, each by Set…() and Get…()."""
    kind.properties = DECLARED[kind.__name__]
    for name in kind.properties:
        _add_property(kind, name)
    return kind


def _add_property(kind, name):
    def setter(self, *values):
        value = values[0] if len(values) == 1 else values
        value = "" if value is None else value
        if self.values[name] != value:
            self.values[name] = value
            self.Modified()

    setattr(kind, f"Set{name}", setter)
    setattr(kind, f"Get{name}", lambda self: self.values[name])


def text_of(value):
    """Returns a number as C++ prints it."""
    return f"{value:.10g}"


def _free_bytes():
    """Returns the memory that is free, where the system says so."""
    try:
        with open("/proc/meminfo", encoding="ascii") as file:
            found = re.search(r"MemAvailable: *(\d+) kB", file.read())
        return 1024 * int(found[1]) if found else math.inf
    except OSError:
        return math.inf


def words_of_memory(count):
    """Returns bytes in words."""
    mebi = count / 2**20
    return f"{mebi / 1024:.3g} GiB" if mebi >= 1000 else f"{mebi:.3g} MiB"


def refuse_beyond_memory(count, what):
    """Refuses what takes more bytes than are free."""
    free = _free_bytes()
    if count > free:
        raise WindingMemoryError(
            f"not enough memory: choose larger voxels (Resolution); {what} needs "
            f"{words_of_memory(count)}, and {words_of_memory(free)} is free")


def new_array(name, dtype, count, components=1):
    """Returns an array of VTK, and NumPy's view of it."""
    size = count * components * np.dtype(dtype).itemsize
    refuse_beyond_memory(size, f"the result of {count} samples")
    try:
        np.empty(size, np.uint8)  # VTK would end the process
    except (MemoryError, ValueError) as error:
        raise WindingMemoryError(
            "not enough memory: choose larger voxels (Resolution)") from error
    array = create_vtk_array(get_vtk_array_type(np.dtype(dtype)))
    array.SetName(name)
    array.SetNumberOfComponents(components)
    array.SetNumberOfTuples(count)
    if count == 0:
        return array, np.empty((0, components) if components > 1 else 0, dtype)
    return array, vtk_to_numpy(array)


def add_text(data, name, text):
    array = vtkStringArray()
    array.SetName(name)
    array.InsertNextValue(text)
    data.GetFieldData().AddArray(array)


def add_number(data, name, value, dtype=np.float64):
    """Adds a number to field data; none for NaN where there is no number."""
    values = np.atleast_1d(np.asarray(value, dtype))
    are_there = not np.isnan(values.astype(float)).any()
    array, view = new_array(name, dtype, int(are_there), len(values))
    if are_there:
        view[...] = values
    data.GetFieldData().AddArray(array)


def copied(name, values, components=1):
    """Returns an array of VTK with the numbers of an array of NumPy."""
    array, view = new_array(name, values.dtype, len(values), components)
    view[...] = values
    return array


def legend_of(facts, values="LabelValues", names="LabelNames"):
    """Returns a line for each name in an array of field data, with its number, which is in another
    array, or counts from 0 where that is None."""
    numbers = facts.GetArray(values) if values else None
    texts = facts.GetAbstractArray(names)
    count = texts.GetNumberOfValues() if texts and (numbers or not values) else 0
    return "".join(f"{numbers.GetTuple1(n) if numbers else n:.0f}\t{texts.GetValue(n)}\n"
                   for n in range(count))


def pointer(array):
    return ctypes.c_void_p(array.ctypes.data)


class Algorithm(VTKPythonAlgorithmBase):
    """A filter with the properties of its proxy in the XML."""

    properties = {}

    def __init__(self, **ports):
        super().__init__(**ports)
        self.values = {name: found.default for name, found in self.properties.items()}
        self.status = NOT_RUN
        self._told = None
        self._share = self._turn = (0.0, 1.0)
        self._kept_warnings = None
        self._turns = 0

    def GetStatus(self):
        return self.status

    def ProcessRequest(self, request, inputs, outputs):
        """Answers the pipeline. There is no result until it gives data, which may fail upstream."""
        answer = super().ProcessRequest(request, inputs, outputs)
        if self.status == DONE and not request.Has(Pipeline.REQUEST_DATA()):
            self.status = NOT_RUN
        return answer

    def value(self, name):
        """Returns the value of a property, which must be one that it may have."""
        found, declared_as = self.values[name], self.properties[name]
        values = found if isinstance(found, (tuple, list)) else [found]
        choices = [number for _, number in declared_as.choices]
        if choices and found not in choices:
            words = [f"{entry} ({number})" for entry, number in declared_as.choices]
            raise WindingError(f"{declared_as.label} is {found}; it must be "
                               f"{', '.join(words[:-1])} or {words[-1]}")
        for value in values:
            lowest, highest = declared_as.lowest, declared_as.highest
            is_number = isinstance(value, (int, float))
            if is_number and not (math.isfinite(value) and lowest <= value <= highest):
                raise WindingError(
                    f"{declared_as.label} is {text_of(value)}; it must be " + (
                        "" if math.isfinite(value) else "a finite number, ") +
                    text_of(lowest) + (f" to {highest}" if highest < math.inf else " or more"))
        return found

    def check(self):
        """Refuses values that properties may not have."""
        for name in self.values:
            self.value(name)

    @contextlib.contextmanager
    def reporting(self, *outputs, ranks=None):
        """Reports what is raised as one line, and keeps how the work ended as the status. Where it
        fails, the outputs become empty. What fails on one of `ranks` fails on all of them."""
        self.status = DONE
        try:
            with ranks.agreeing() if ranks else contextlib.nullcontext():
                yield
            self._told = None
        except WindingInterrupted:
            self.status = ABORTED
        except WindingMemoryError as error:
            self.status = OUT_OF_MEMORY
            self._refuse(str(error))
        except MemoryError:
            self.status = OUT_OF_MEMORY
            self._refuse("not enough memory for this source and result")
        except WindingError as error:
            self.status = REFUSED
            self._refuse(str(error))
        except Exception as error:
            self.status = REFUSED
            self._refuse(words_of_unexpected(error))
        if self.status != DONE:
            for output in outputs:
                output.Initialize()

    def more_properties(self):
        """Returns what a filter has been set to by calls that no property makes."""
        return ()

    def require_same_properties(self, ranks):
        """Refuses properties that differ among ranks, as scripts on each rank may set them."""
        own = sorted((name, value) for name, value in self.values.items()
                     if name not in _OF_EACH_RANK)
        ranks.require_same((own, self.more_properties()), sentence("otherPropertiesOnRanks"))

    def _refuse(self, text):
        """Reports an error, once for each change of the pipeline."""
        pipeline = self.GetExecutive()
        now = (text, pipeline.GetPipelineMTime() if pipeline else self.GetMTime())
        if now != self._told:
            self._told = now
            self._tell("ErrorEvent", "ERROR", text)

    def warn(self, text):
        if self._kept_warnings is None:
            self._tell("WarningEvent", "Warning", text)
            return
        parts = text.split("'")  # names in quotation marks keep their numbers
        parts[::2] = [re.sub(r"[0-9]", "", part) for part in parts[::2]]
        kept = self._kept_warnings.setdefault("'".join(parts), (text, set()))
        kept[1].add(self._turn)

    @contextlib.contextmanager
    def distinct_warnings(self):
        """Keeps the warnings of several turns back. At the end each comes once, with how many of
        the turns it came at unless that is all of them."""
        self._kept_warnings = {}
        try:
            yield
        finally:
            kept, self._kept_warnings = self._kept_warnings, None
            self._turn = (0.0, 1.0)
            for text, turns in kept.values():
                often = f"at {len(turns)} of {self._turns} times"
                self.warn(text if len(turns) == self._turns else
                          text + (", " if "; " in text else "; ") + often)

    def _tell(self, event, kind, text):
        """Tells observers of the filter, or else ParaView's window of messages, as C++ does."""
        line = f"{type(self).__name__} ({self.GetAddressAsString('')[5:]}): {text}"
        full = f"{kind}: In winding_paraview, line 0\n{line}\n\n"
        if self.HasObserver(event):
            self.InvokeEvent(event, full)
        elif kind == "ERROR":
            vtkOutputWindow.GetInstance().DisplayErrorText(full)
        else:
            vtkOutputWindow.GetInstance().DisplayWarningText(full)

    def take_turn(self, number, count):
        """Shows the progress of what follows as one of several turns."""
        self._turn, self._turns = (number / count, (number + 1) / count), number + 1
        self.between(0, 1)

    def between(self, first, last):
        """Shows the progress of the next calls as this share of the filter's, or of its turn."""
        begin, end = self._turn
        self._share = (begin + (end - begin) * first, begin + (end - begin) * last)

    def is_aborted(self):
        is_asked = hasattr(self, "CheckAbort") and self.CheckAbort()
        return bool(is_asked or self.GetAbortExecute())

    def call(self, name, *arguments, note=None):
        """Calls the library in the words of ParaView, with progress, and ends where the filter is
        to abort."""
        start = time.perf_counter()

        def show(share):
            first, last = self._share
            self.UpdateProgress(first + (last - first) * share)
            elapsed = time.perf_counter() - start
            self.note_progress(elapsed, share)
            return self.is_aborted()

        longest = self.value("LongestExpectedTime") if "LongestExpectedTime" in self.values else 0
        threads = self.value("NumberOfThreads") if "NumberOfThreads" in self.values else 0
        free = _free_bytes()
        _library.call(name, *arguments, threads=threads, longest_expected_time=longest,
                      free_memory=0 if math.isinf(free) else free,
                      words=_library.PARAVIEW_WORDS, show=show, note=note or self.warn)

    def note_progress(self, elapsed, share):
        """Takes note of how long a call has taken for a share of its work."""

    def FillOutputPortInformation(self, port, info):
        info.Set(vtkDataObject.DATA_TYPE_NAME(), self.OutputType)
        return 1

    def RequestInformation(self, request, inputs, outputs):
        return 1

    def RequestUpdateExtent(self, request, inputs, outputs):
        return 1


def replace_leaves(data, output, made):
    """Gives composite data the structure of other data, and for each of its leaves made(leaf)."""
    output.CopyStructure(data)
    output.GetFieldData().PassData(data.GetFieldData())
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        output.SetDataSet(iterator, made(iterator.GetCurrentDataObject()))
        iterator.GoToNextItem()
