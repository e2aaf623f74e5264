# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ranks of a parallel server, which share what they have of a source."""

import contextlib
import pathlib
import traceback

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from vtkwinding._errors import WindingError, WindingInterrupted, WindingMemoryError

_KINDS = (None, WindingError, WindingMemoryError, WindingInterrupted)


def words_of_unexpected(error):
    """Returns a line about an error that nothing is known of."""
    place = traceback.extract_tb(error.__traceback__)[-1]
    return (f"unexpected, please report it: {error!r} at line {place.lineno} of "
            f"{pathlib.Path(place.filename).name}")


def _kind_and_text(error):
    if isinstance(error, MemoryError):
        return _KINDS.index(WindingMemoryError), "not enough memory"
    kind = type(error) if type(error) in _KINDS else WindingError
    return _KINDS.index(kind), (
        str(error) if isinstance(error, WindingError) else words_of_unexpected(error))


class Ranks:
    """The ranks of this process's controller. All of them call each function together."""

    def __init__(self):
        self._controller = vtkMultiProcessController.GetGlobalController()
        self.rank, self.count = 0, 1
        if self._controller is not None:
            self.rank = self._controller.GetLocalProcessId()
            self.count = self._controller.GetNumberOfProcesses()

    @property
    def are_alone(self):
        return self.count == 1

    def gather(self, array):
        """Returns the arrays of all ranks, of any lengths. A double must hold their numbers."""
        own = np.ascontiguousarray(array)
        if self.are_alone:
            return [own]
        lengths = self._exchange(own.size)
        with self.agreeing():
            numbers = own.ravel().astype(float)
            np.empty(lengths.sum())  # VTK would end the process
        everything = self._gathered(numbers, lengths.sum())
        return [part.astype(own.dtype).reshape(-1, *own.shape[1:])
                for part in np.split(everything, np.cumsum(lengths)[:-1])]

    def _gathered(self, own, total):
        found = vtkDoubleArray()
        found.SetNumberOfTuples(int(total))
        self._controller.AllGatherV(numpy_to_vtk(own), found)
        return vtk_to_numpy(found).copy() if total else np.empty(0)

    def _exchange(self, own, text=""):
        """Returns the lengths that ranks have. A rank that fails gives a kind of error as a number
        less than 0, and a text. Then all ranks raise the error of the first of these."""
        lengths = self._gathered(np.array([own], float), self.count).astype(int)
        if (lengths >= 0).all():
            return lengths
        letters = np.frombuffer(text.encode(errors="replace"), np.uint8).astype(float)
        sizes = self._gathered(np.array([len(letters)], float), self.count).astype(int)
        texts = np.split(self._gathered(letters, sizes.sum()).astype(np.uint8),
                         np.cumsum(sizes)[:-1])
        first = int(np.flatnonzero(lengths < 0)[0])
        error = _KINDS[-lengths[first]](f"{texts[first].tobytes().decode(errors='replace')} "
                                        f"(rank {first} of {self.count})")
        error.is_of_all_ranks = True
        raise error

    @contextlib.contextmanager
    def agreeing(self):
        """Fails on all ranks where the work within fails on one. There the others may wait for this
        rank within as well as at the end."""
        if self.are_alone:
            yield
            return
        kind, text = 0, ""
        try:
            yield
        except Exception as error:
            if getattr(error, "is_of_all_ranks", False):
                raise
            kind, text = _kind_and_text(error)
        self._exchange(-kind, text)

    def texts(self, own):
        """Returns the texts of all ranks, rank by rank."""
        own = list(own)
        if self.are_alone:
            return own
        letters = "".join(f"{text}\0" for text in own).encode()
        every = np.concatenate(self.gather(np.frombuffer(letters, np.uint8)))
        return every.tobytes().decode(errors="replace").split("\0")[:-1]

    def require_same(self, value, text):
        """Refuses a value that differs among ranks, with a text."""
        if len(set(self.texts([repr(value)]))) > 1:
            raise WindingError(text)

    def same(self, number):
        """Returns whether a number is the same on all ranks."""
        numbers = np.concatenate(self.gather(np.array([number], np.int64)))
        return bool((numbers == numbers[0]).all())
