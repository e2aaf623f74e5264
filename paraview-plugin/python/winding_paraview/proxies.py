# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The classes that proxies of ParaView name, each as in C++ without vtk before it."""

from .booleans import WindingNumberBoolean
from .grids import GridAlgorithm, WindingNumberField
from .points import WindingNumberNormals
from .probes import ProbeAlgorithm, WindingNumberClip, WindingNumberProbe
from .readers import WindingNumberReader
from .reports import WindingNumberReport
from .solids import WindingNumberLabels
from .sources import SourceAlgorithm
from .surfaces import WindingNumberSurface, WindingNumberVoxels

# Bases that no proxy is made of.
WindingNumberAlgorithm = SourceAlgorithm
WindingNumberGridAlgorithm = GridAlgorithm
WindingNumberProbeAlgorithm = ProbeAlgorithm

__all__ = [
    "WindingNumberAlgorithm",
    "WindingNumberBoolean",
    "WindingNumberClip",
    "WindingNumberField",
    "WindingNumberGridAlgorithm",
    "WindingNumberLabels",
    "WindingNumberNormals",
    "WindingNumberProbe",
    "WindingNumberProbeAlgorithm",
    "WindingNumberReader",
    "WindingNumberReport",
    "WindingNumberSurface",
    "WindingNumberVoxels",
]
