"""The options that all functions share, and the properties of the filters that they stand for."""

from __future__ import annotations

import dataclasses
import math
import numbers

import numpy as np

METHODS = {"auto": 0, "rows": 1, "hierarchical": 2, "direct": 3, "parity": 4}
RULES = {"signed": 0, "absolute": 1, "odd": 2}
COVERAGES = {"center": 0, "any": 1, "fraction": 2}
FEATURES = {"smooth": 0, "sharp": 1}
ASSOCIATIONS = {"point": 0, "cell": 1}
NORMAL_ESTIMATIONS = {"auto": 0, "tree": 1, "consistent": 2}
AREA_METHODS = {"voronoi": 0, "mesh": 1, "constant": 2}


def choice(name, value, choices):
    """The number of one of some words."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a str, not {type(value).__name__}")
    if value not in choices:
        raise ValueError(f"{name} must be one of {', '.join(choices)}, not {value!r}")
    return choices[value]


def _plain(value):
    """Python's own number or bool, where NumPy's scalar or an array without axes is given."""
    return value.item() if isinstance(value, (np.generic, np.ndarray)) and not value.ndim else value


def flag(name, value):
    value = _plain(value)
    if not isinstance(value, numbers.Integral):
        raise TypeError(f"{name} must be a bool, not {type(value).__name__}")
    return bool(value)


def integer(name, value, least=None, most=None):
    value = _plain(value)
    if not isinstance(value, numbers.Integral) or isinstance(value, bool):
        raise TypeError(f"{name} must be an int, not {type(value).__name__}")
    return _in_range(name, int(value), least, most)


def number(name, value, least=None, most=None):
    """A finite number in a range."""
    value = _plain(value)
    if not isinstance(value, numbers.Real) or isinstance(value, bool):
        raise TypeError(f"{name} must be a number, not {type(value).__name__}")
    try:
        found = float(value)
    except OverflowError:  # integers and fractions have no bound
        found = math.inf
    if not math.isfinite(found):
        raise ValueError(f"{name} must be finite, not {found}")
    return _in_range(name, found, least, most)


def _in_range(name, value, least, most):
    if (least is not None and value < least) or (most is not None and value > most):
        ends = f"{least} or more" if most is None else f"{least} to {most}"
        raise ValueError(f"{name} must be {ends}, not {value}")
    return value


def text(name, value):
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a str, not {type(value).__name__}")
    return value


def threads(n_threads):
    """The property NumberOfThreads: 0 for all that there are."""
    return 0 if n_threads is None else integer("n_threads", n_threads, 1, 2**31 - 1)


@dataclasses.dataclass(frozen=True)
class Options:
    """What every winding number needs to know. Defaults are those of vtkWindingNumberAlgorithm."""

    method: str = "auto"
    tolerance: float = 1e-3
    threshold: float = 0.5
    rule: str = "signed"
    n_threads: int | None = None
    longest_expected_time: float = 600
    as_points: bool = False
    surface_cells: bool = False
    orient_faces: bool = False
    ignore_open_parts: bool = False
    estimate_normals: bool = False
    normal_estimation: str = "auto"
    n_neighbors: int = 20
    regularization: float = 0
    normals_array: str | None = None
    areas_array: str | None = None

    def apply(self, algorithm):
        algorithm.SetMethod(choice("method", self.method, METHODS))
        algorithm.SetTolerance(number("tolerance", self.tolerance, 0))
        algorithm.SetWindingThreshold(number("threshold", self.threshold))
        algorithm.SetInsideRule(choice("rule", self.rule, RULES))
        algorithm.SetNumberOfThreads(threads(self.n_threads))
        algorithm.SetLongestExpectedTime(
            number("longest_expected_time", self.longest_expected_time, 0))
        algorithm.SetSourceAsPoints(flag("as_points", self.as_points))
        algorithm.SetUseSurfaceCells(flag("surface_cells", self.surface_cells))
        algorithm.SetOrientFaces(flag("orient_faces", self.orient_faces))
        algorithm.SetIgnoreOpenParts(flag("ignore_open_parts", self.ignore_open_parts))
        algorithm.SetEstimateNormals(flag("estimate_normals", self.estimate_normals))
        algorithm.SetNormalEstimation(
            choice("normal_estimation", self.normal_estimation, NORMAL_ESTIMATIONS))
        algorithm.SetNumberOfNeighbors(integer("n_neighbors", self.n_neighbors, 3, 1000))
        algorithm.SetRegularization(number("regularization", self.regularization, 0, 4))
        if self.normals_array is not None:
            algorithm.SetNormalsArray(text("normals_array", self.normals_array))
        if self.areas_array is not None:
            algorithm.SetPointAreaMethod(algorithm.ARRAY)
            algorithm.SetAreaArray(text("areas_array", self.areas_array))
        return algorithm


NAMES = tuple(field.name for field in dataclasses.fields(Options))


def configured(algorithm, options):
    """The filter with options, of which all but the given ones have their defaults."""
    for name in options:
        if name not in NAMES:
            raise TypeError(f"there is no option {name}; the options are {', '.join(NAMES)}")
    return Options(**options).apply(algorithm)
