# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# script-version: 2.0
"""Makes the winding number of the hull that a simulation hands to Catalyst at each step.

A simulation in Python adds this script, and hands its surface over:

    from paraview.catalyst import bridge
    bridge.initialize()
    bridge.add_pipeline("in_situ.py")
    bridge.coprocess(time, step, surface, name="hull")
    bridge.finalize()

It writes wet_000001.pvti and so on to the folder datasets: which voxels are inside. The plugin is
found by PV_PLUGIN_PATH, or in WINDING_PLUGIN.
"""

import os

from paraview import catalyst, simple

if "WINDING_PLUGIN" in os.environ:
    simple.LoadPlugin(os.environ["WINDING_PLUGIN"], remote=False)

hull = simple.TrivialProducer(registrationName="hull")
field = simple.WindingNumberField(
    registrationName="wet", Input=hull, Resolution=64, UseInputBounds=0,
    SamplingBounds=[-1, 3, -1, 1, -1, 1], GenerateInside=1)

extractor = simple.CreateExtractor("VTI", field, registrationName="wet")
extractor.Writer.FileName = "wet_{timestep:06d}.pvti"

options = catalyst.Options()
options.ExtractsOutputDirectory = os.environ.get("IN_SITU_FOLDER", "datasets")
