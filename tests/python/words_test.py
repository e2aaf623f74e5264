# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages name options by the keywords of this package, in the words of tests/messages."""

import pathlib
import sys
import unittest
import warnings

import numpy as np

from vtkwinding_native.vtkIOWinding import vtkWindingNumberReader

import vtkwinding
from vtkwinding import _sources

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from messages import FOLDER, messages_of  # noqa: E402


def mesh(name):
    """Vertices and triangles of a file of quadrilaterals."""
    lines = [line.split() for line in (FOLDER / name).read_text().splitlines()]
    points = np.array([[float(word) for word in line] for line in lines[2:10]])
    faces = np.array([[int(word) for word in line[1:]] for line in lines[10:]])
    return points, np.concatenate([faces[:, :3], faces[:, [0, 2, 3]]])


def field_of(name):
    """Evaluates the field of the data object that is in a file."""
    reader = vtkWindingNumberReader()
    reader.SetFileName(str(FOLDER / name))
    reader.Update()
    source = _sources.source_of(reader.GetOutput())
    for note in source.notes():
        warnings.warn(note, vtkwinding.WindingWarning, stacklevel=2)
    _sources.SourceField(source).field(resolution=4)


def message_of(call, *arguments, **options):
    """What a call says, as an error or a warning."""
    with warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        try:
            call(*arguments, **options)
        except (vtkwinding.WindingError, ValueError) as error:
            return str(error)
    return str(notes[0].message)


class WordsTest(unittest.TestCase):
    maxDiff = None

    def test_are_those_of_the_list(self):
        place = np.loadtxt(FOLDER / "place.xyz")
        cloud = {"normals": place[:, 3:]}
        cube, inward = mesh("cube.off"), mesh("inward.off")
        field = vtkwinding.field
        found = {
            "bounds of a single point": message_of(field, place[:, :3], resolution=4, **cloud),
            "a method that points do not have": message_of(
                field, place[:, :3], method="parity", bounds=[0, 1] * 3, **cloud),
            "a number out of range": message_of(field, *cube, padding=-1),
            "mirror planes at an angle": message_of(field, *cube, mirror="y=0; 1 1 0 = 0"),
            "too many voxels": message_of(field, *cube, spacing=1e-12),
            "faces that look inward": message_of(field, *inward, resolution=4),
            "faces that are turned": message_of(vtkwinding.surface, *inward, resolution=4),
            "a solid that is closed at the border": message_of(
                vtkwinding.surface, *cube, resolution=4, bounds=[0.4, 0.6] * 3),
            "a grid within the solid": message_of(
                vtkwinding.surface, *cube, resolution=4, bounds=[0.4, 0.6] * 3, mend_source=False),
        }
        octahedron = np.loadtxt(FOLDER / "octahedron.xyz")
        found["normals where others are wanted"] = message_of(
            field, octahedron[:, :3], normals=octahedron[:, 3:], estimate_normals=True,
            resolution=4)
        equal = np.loadtxt(FOLDER / "equal.xyz")
        found["normals that are equal"] = message_of(
            field, equal[:, :3], normals=equal[:, 3:], resolution=4)
        zeros = np.loadtxt(FOLDER / "zeros.xyz")
        found["normals of length 0"] = message_of(
            field, zeros[:, :3], normals=zeros[:, 3:], resolution=4)
        # Functions of arrays say themselves that points have no normals, and take no lines.
        found["points without normals"] = message_of(field_of, "bare.xyz")
        found["lines next to faces"] = message_of(field_of, "loose.off")
        found["columns of colours"] = message_of(vtkwinding.read, FOLDER / "colours.xyz")
        found["the report on faces that look inward"] = vtkwinding.report(*inward)["advice"]
        self.assertEqual(found, messages_of("Python"))


if __name__ == "__main__":
    unittest.main()
