# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""From a scan, holes and all, to a solid: python scan_to_solid.py [mesh] [--picture solid.png]"""

# %% A mesh with faces that look outward; here two rings that overlap, with holes in them.
import argparse

import numpy as np
import pyvista as pv

parser = argparse.ArgumentParser()
parser.add_argument("mesh", nargs="?", help="a file that PyVista reads")
parser.add_argument("--picture")
arguments = parser.parse_args()
if arguments.mesh:
    scan = pv.read(arguments.mesh)
else:
    ring = pv.ParametricTorus(ringradius=1, crosssectionradius=0.35).triangulate()
    scan = ring + ring.rotate_x(90).translate((1, 0, 0))
    holes = np.array([[-0.9, -0.9, 0.2], [0, -1.1, 0.3], [2.1, 0, 0.9], [1.2, -0.3, -1.1]])
    away = np.linalg.norm(scan.cell_centers().points[:, None] - holes, axis=2).min(axis=1)
    scan = scan.extract_cells(away > 0.3).extract_surface(algorithm="dataset_surface")

# %% What is wrong with it?
print(scan.winding.report()["advice"])

# %% The surface where the winding number is a half: smooth, closed, without what lies inside.
solid = scan.winding.surface(resolution=160)
print(f"{solid.n_cells} triangles, {solid.n_open_edges} open edges, volume {solid.volume:.6g}")

# %% Before and after.
plotter = pv.Plotter(shape=(1, 2), off_screen=bool(arguments.picture), window_size=(1200, 500))
plotter.add_mesh(scan, color="wheat", backface_params={"color": "firebrick"})
plotter.add_text(f"as it came: {scan.n_open_edges} open edges", font_size=10)
plotter.subplot(0, 1)
plotter.add_mesh(solid, color="lightsteelblue")
plotter.add_text(f"the solid: {solid.n_open_edges} open edges", font_size=10)
plotter.link_views()
plotter.show(screenshot=arguments.picture)
