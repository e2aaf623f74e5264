# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ranks of a parallel server, which share what they have of a source."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from vtkwinding._errors import WindingError, WindingInterrupted, WindingMemoryError

_KINDS = (None, WindingError, WindingMemoryError, WindingInterrupted)


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
        lengths = self._gathered(np.array([own.size], float), self.count)
        everything = self._gathered(own.ravel().astype(float), int(lengths.sum()))
        ends = np.cumsum(lengths).astype(int)
        return [part.astype(own.dtype).reshape(-1, *own.shape[1:])
                for part in np.split(everything, ends[:-1])]

    def _gathered(self, own, total):
        found = vtkDoubleArray()
        found.SetNumberOfTuples(total)
        self._controller.AllGatherV(numpy_to_vtk(own), found)
        return vtk_to_numpy(found).copy() if total else np.empty(0)

    def agree(self, work):
        """Does work, and fails on all ranks where it fails on one. Returns what it returns."""
        if self.are_alone:
            return work()
        result, kind, text = None, 0, ""
        try:
            result = work()
        except WindingError as error:
            kind, text = max(_KINDS.index(type(error)), 1), str(error)
        except MemoryError:
            kind, text = 2, "not enough memory"
        except Exception as error:  # the other ranks wait
            kind, text = 1, f"unexpected: {error!r}"
        kinds = np.concatenate(self.gather(np.array([kind])))
        texts = self.gather(np.frombuffer(text.encode(), np.uint8))
        if kinds.any():
            first = int(np.flatnonzero(kinds)[0])
            raise _KINDS[kinds[first]](
                f"{texts[first].tobytes().decode(errors='replace')} "
                f"(rank {first} of {self.count})")
        return result

    def texts(self, own):
        """Returns the texts of all ranks, rank by rank."""
        own = list(own)
        if self.are_alone:
            return own
        letters = "".join(f"{text}\0" for text in own).encode()
        every = np.concatenate(self.gather(np.frombuffer(letters, np.uint8)))
        return every.tobytes().decode(errors="replace").split("\0")[:-1]

    def same(self, number):
        """Returns whether a number is the same on all ranks."""
        numbers = np.concatenate(self.gather(np.array([number], np.int64)))
        return bool((numbers == numbers[0]).all())
