# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each keyword of filters/Options.def reaches the library, from every function that takes it.

All that the library is given is noted down, with the result: a keyword that is not handed on leaves
both as they are.
"""

import ctypes
import hashlib
import inspect
import pathlib
import sys
import tempfile
import unittest
import warnings

import numpy as np

import vtkwinding
from vtkwinding import _library

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from options import options_in  # noqa: E402

try:
    import pyvista as pv
except ImportError:  # the build tree's Python has NumPy alone
    pv = None

# A value of each keyword that is not its default.
VALUES = {
    "method": "direct", "tolerance": 0.0231, "regularization": 1.25, "n_threads": 1,
    "longest_expected_time": 77.0, "as_points": True, "surface_cells": True, "orient_faces": True,
    "ignore_open_parts": True, "mirror": "x=-3", "flat_base": "down", "sheet_side": "up",
    "weld_tolerance": 0.0017, "normals_array": "OtherNormals", "estimate_normals": True,
    "normal_estimation": "consistent", "toward": "up", "point_area": 0.0191,
    "areas_array": "OtherAreas", "n_neighbors": 11, "resolution": 7, "spacing": 0.31,
    "dimensions": (5, 6, 7), "bounds": (-0.2, 1.1, -0.3, 1.2, -0.4, 1.3), "padding": 0.21,
    "association": "cell", "threshold": 0.37, "rule": "odd", "inside_out": True, "coverage": "any",
    "inside": True, "signed_distance": True, "fraction": True, "distance_band": 1.75,
    "dtype": np.float64, "features": "sharp", "close_border": True, "fill_cavities": True,
    "gap_width": 0.043, "offset": 0.083, "shell": 0.071, "shell_side": "centered",
    "compute_normals": False, "mend_source": False,
    "distance_to_input": True, "transfer_attributes": True, "nearest_cells": True,
    "overlap": "last", "columns": {"x": "b", "y": "a", "z": "c"}}
# Keywords of another meaning, or that choose among functions of the library.
OTHERS = {("mesh.winding.estimate_areas", "estimate_normals"): True,
          ("mesh.winding.estimate_areas", "method"): "constant"}
# What a source must be for a keyword to be of use, if not a surface.
SOURCES = {"normals_array": "cloud", "areas_array": "cloud", "estimate_normals": "cloud",
           "surface_cells": "mixed"}
# What else must be said for a keyword to be of use.
WITH = {("mesh.winding.estimate_areas", "point_area"): {"method": "constant"}}
# What says how voxels are to be, of which a function takes but one.
OF_VOXELS = ("resolution", "spacing", "dimensions")


def cube():
    """Vertices and triangles of the unit cube."""
    points = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    quads = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2],
                      [1, 3, 7, 5]])
    return points, np.concatenate([quads[:, :3], quads[:, [0, 2, 3]]])


def cloud():
    """Points of a sphere of radius 0.5 around the middle of the cube, and their normals."""
    index = np.arange(120)
    height = 1 - (2 * index + 1) / len(index)
    turn = index * np.pi * (3 - 5 ** 0.5)
    normals = np.stack([np.cos(turn), np.sin(turn), height], 1)
    normals[:, :2] *= np.sqrt(1 - height ** 2)[:, None]
    return 0.5 + 0.5 * normals, normals


def noted(value, name=""):
    """What the library is given, as names and values without addresses."""
    value = getattr(value, "_obj", value)  # of ctypes.byref()
    if isinstance(value, _library.Array):
        if not value.data or not value.rows:
            return [(name, None)]
        size = {1: 4, 2: 8, 3: 4, 4: 8, 5: 1, 6: 2}[value.type]
        data = ctypes.string_at(value.data, size * ((value.rows - 1) * value.stride + 1))
        return [(name, (value.rows, value.type, hashlib.sha1(data).hexdigest()))]
    if isinstance(value, ctypes.Structure):
        return [one for member, _ in value._fields_
                for one in noted(getattr(value, member), member)]
    if isinstance(value, ctypes.Array):
        if isinstance(value[0], ctypes.Structure):
            return [one for item in value for one in noted(item)]
        is_plain = isinstance(value[0], (int, float))
        return [(name, tuple(value) if is_plain else len(value))]
    if isinstance(value, (int, float, bytes, str)) and not isinstance(value, bool):
        # Addresses are large, and counts of these tests are not.
        return [(name, "address" if isinstance(value, int) and value > 2 ** 32 else value)]
    if isinstance(value, (ctypes.c_size_t, ctypes.c_double, ctypes.c_int64)):
        return [(name, value.value)]
    return [(name, value is None)]


class Listener:
    """The library, which notes down what it is given."""

    def __init__(self, library, notes):
        self._library, self._notes = library, notes

    def __getattr__(self, name):
        function = getattr(self._library, name)
        if name.endswith(("_init", "_free", "_show")):
            return function

        def called(*arguments):
            self._notes.append((name, [one for argument in arguments for one in noted(argument)]))
            return function(*arguments)

        return called


def digest(result):
    """A text that tells results apart."""
    if isinstance(result, np.ndarray):
        content = hashlib.sha1(np.ascontiguousarray(result)).hexdigest()
        return f"{result.dtype} {result.shape} {content}"
    if isinstance(result, (tuple, list)):
        return " ".join(map(digest, result))
    if pv is not None and isinstance(result, pv.DataSet):
        attributes = [f"{name} {digest(np.asarray(array))}" for part in (
            result.point_data, result.cell_data, result.field_data)
            for name, array in sorted(part.items())]
        return " ".join([str(result.n_cells), digest(np.asarray(result.points)), *attributes])
    return repr(result)


class KeywordsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.options = {option.keyword: option for option in options_in() if option.keyword}
        cls.functions = cls.functions_of_arrays()
        if pv is not None:
            cls.functions += cls.functions_of_meshes()

    @staticmethod
    def functions_of_arrays():
        """Kinds of sources, names, functions and their arguments."""
        mesh, (points, normals) = cube(), cloud()
        places = points[::7] * 0.9
        solids = [vtkwinding.Field(*mesh), vtkwinding.Field(mesh[0] + 0.4, mesh[1])]
        found = [("surface", function.__name__, function, arguments) for function, arguments in (
            (vtkwinding.winding_number, (places, *mesh)), (vtkwinding.contains, (places, *mesh)),
            (vtkwinding.signed_distance, (places, *mesh)), (vtkwinding.field, mesh),
            (vtkwinding.surface, mesh), (vtkwinding.labels, (solids,)),
            (vtkwinding.boolean, (solids,)), (vtkwinding.report, mesh),
            (vtkwinding.fix_orientation, mesh), (vtkwinding.estimate_normals, (points,)),
            (vtkwinding.point_areas, (points, normals)))]
        found += [("surface", f"Field.{name}", getattr(solids[0], name), arguments)
                  for name, arguments in (
                      ("winding_number", (places,)), ("contains", (places,)),
                      ("signed_distance", (places,)), ("field", ()), ("mask", ()),
                      ("surface", ()))]

        def read(*, columns=None):
            with tempfile.TemporaryDirectory() as folder:
                table = pathlib.Path(folder) / "table.csv"
                table.write_text("a,b,c,x,y,z\n1,2,3,4,5,6\n")
                return vtkwinding.read(table, columns=columns).vertices

        return found + [("surface", "read", read, ())]

    @staticmethod
    def functions_of_meshes():
        """The same for methods of meshes, each with a source of every kind."""
        points, triangles = cube()

        def mesh_of(kind, move):
            if kind == "mixed":
                corners = pv.CellType.HEXAHEDRON, pv.CellType.QUAD
                return pv.UnstructuredGrid(
                    np.array([8, 0, 1, 3, 2, 4, 5, 7, 6, 4, 0, 1, 7, 6]), corners, points + move)
            mesh = pv.PolyData.from_regular_faces(points + move, triangles)
            if kind == "cloud":
                places, normals = cloud()
                mesh = pv.PolyData(places + move)
                mesh["OtherNormals"] = 2 * normals
                mesh["OtherAreas"] = np.full(len(places), 0.02)
            else:
                mesh.cell_data["Cell"] = np.arange(mesh.n_cells)
            return mesh

        places = pv.ImageData(
            dimensions=(4, 4, 4), spacing=(0.3,) * 3).cast_to_unstructured_grid()
        found = []
        for kind in ("surface", "cloud", "mixed"):
            mesh, other = mesh_of(kind, 0), mesh_of(kind, 0.4)
            for name in ("field", "surface", "voxelize_binary_mask", "voxelize", "labels", "report",
                         "fix_orientation", "estimate_areas"):
                # Points alone have no bodies.
                source = pv.MultiBlock([mesh]) if (kind, name) == ("cloud", "labels") else mesh
                found.append((kind, name, getattr(source.winding, name), ()))
            for name in ("boolean_union", "boolean_intersection", "boolean_difference"):
                found.append((kind, name, getattr(mesh.winding, name), (other,)))
            for name in ("select_interior_points", "extract_interior", "clip", "signed_distance",
                         "sample"):
                found.append((kind, name, getattr(places.winding, name), (mesh,)))
        return [(kind, f"mesh.winding.{name}", *rest) for kind, name, *rest in found]

    def outcome(self, function, arguments, keywords):
        notes = []
        before = _library._library
        _library._library = Listener(before, notes)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                result = digest(function(*arguments, **keywords))
        except (vtkwinding.WindingError, RuntimeError) as error:
            result = str(error)
        finally:
            _library._library = before
        return notes, result

    def test_each_reaches_the_library_from_every_function(self):
        taken, arrived = set(), 0
        for kind, name, function, arguments in self.functions:
            parameters = inspect.signature(function).parameters
            for keyword in sorted(self.options.keys() & parameters.keys()):
                wanted = SOURCES.get(keyword, "surface") if "mesh." in name else kind
                if kind != wanted:
                    continue
                with self.subTest(function=name, keyword=keyword):
                    taken.add(keyword)
                    base = dict(WITH.get((name, keyword), {}))
                    if "resolution" in parameters and keyword not in OF_VOXELS:
                        base["resolution"] = 12
                    if keyword == "areas_array":
                        base["normals_array"] = "OtherNormals"
                    without = self.outcome(function, arguments, base)
                    value = OTHERS.get((name, keyword), VALUES[keyword])
                    found = self.outcome(function, arguments, {**base, keyword: value})
                    self.assertTrue(without != found, "nothing changes")
                    if (name, keyword) not in OTHERS:
                        arrived += self.check_member(keyword, value, found[0])
        everything = self.options.keys() if pv is not None else taken
        self.assertEqual(everything - taken, set())
        # Of those that a struct of the library has by name.
        self.assertGreaterEqual(arrived, 164 if pv is None else 463)

    def check_member(self, keyword, value, notes):
        """Whether a struct has a member of the name of the keyword's property. It has the value."""
        option = self.options[keyword]
        member = "".join(f"_{letter.lower()}" if letter.isupper() else letter
                         for letter in option.property).lstrip("_")
        given = [found for _, values in notes for name, found in values if name == member]
        if not given:
            return 0
        numbers = {names[2]: int(number) for number, names in option.choices.items()}
        expected = numbers[value] if option.choices else value
        expected = value.encode() if option.kind == "text" else expected
        self.assertIn(expected, given, member)
        return 1

    def test_those_of_a_source_reach_the_search_for_nearest_cells_too(self):
        count = 0
        for kind, name, function, arguments in self.functions:
            if "nearest_cells" in inspect.signature(function).parameters and kind == "surface":
                for keyword in ("mirror", "weld_tolerance", "n_threads"):
                    with self.subTest(function=name, keyword=keyword):
                        base = {"nearest_cells": True, keyword: VALUES[keyword]}
                        if "sample" not in name:
                            base["resolution"] = 12
                        notes, _ = self.outcome(function, arguments, base)
                        notes = [note for note in notes if note[0] == "winding_nearest"]
                        count += self.check_member(keyword, VALUES[keyword], notes)
        self.assertEqual(count, 0 if pv is None else 18)

    def bounds_of_grid(self, function, arguments, **options):
        notes, _ = self.outcome(function, arguments, {"resolution": 12, **options})
        requests = [dict(values) for name, values in notes if name == "winding_lay_out_grid"]
        self.assertEqual(len(requests), 1)
        return np.array(requests[0]["sampling_bounds"])

    def test_grids_hold_what_shapes_reach(self):
        functions = {name: (function, arguments) for kind, name, function, arguments
                     in self.functions if kind == "surface"}
        for name in ("surface", "Field.surface", "mesh.winding.surface"):
            if name not in functions:
                continue
            for options, reach in (
                    ({}, 0), ({"offset": 0.3}, 0.3), ({"offset": -0.3}, 0), ({"shell": 0.4}, 0),
                    ({"shell": 0.4, "shell_side": "outward"}, 0.4),
                    ({"shell": 0.4, "shell_side": "centered"}, 0.2),
                    ({"shell": 0.4, "shell_side": "centered", "offset": -0.1}, 0.1),
                    ({"shell": 0.4, "shell_side": "outward", "offset": -0.5}, 0)):
                with self.subTest(function=name, **options):
                    np.testing.assert_allclose(
                        self.bounds_of_grid(*functions[name], **options),
                        [-reach, 1 + reach] * 3, atol=1e-12)

    def test_grids_of_booleans_hold_what_the_result_reaches(self):
        points, triangles = cube()

        def solids(**options):
            return [vtkwinding.Field(points, triangles),
                    vtkwinding.Field(points + 0.4, triangles, **options)],

        first, both, all_of = [0, 1] * 3, [0.4, 1] * 3, [0, 1.4] * 3
        for operation, options, expected in (
                ("union", {}, all_of), ("xor", {}, all_of), ("difference", {}, first),
                ("intersection", {}, both), ("intersection", {"threshold": 0.49}, first),
                ("intersection", {"threshold": 0.5}, both),
                ("intersection", {"threshold": 0.3, "rule": "odd"}, both),
                ("intersection", {"threshold": 0.3, "rule": "absolute"}, first),
                ("intersection", {"sheet_side": "down"}, first)):
            with self.subTest(operation=operation, **options):
                np.testing.assert_allclose(self.bounds_of_grid(
                    vtkwinding.boolean, solids(**options), operation=operation), expected,
                    atol=1e-12)


if __name__ == "__main__":
    unittest.main()
