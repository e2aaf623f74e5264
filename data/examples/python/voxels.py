# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Voxels of a mesh, for simulations and for learning: python voxels.py [--picture voxels.png]"""

# %% A body of parts that overlap.
import argparse

import pyvista as pv

parser = argparse.ArgumentParser()
parser.add_argument("--picture")
arguments = parser.parse_args()
body = pv.Cylinder(radius=0.35, height=1.4) + pv.Sphere(radius=0.5) + pv.Cube(
    center=(0, 0, 0.45), x_length=0.3, y_length=1.1, z_length=0.05).triangulate()

# %% A mask by the centres of voxels, as PyVista makes it, and the share of each that is inside.
mask = body.winding.voxelize_binary_mask(spacing=0.05)
shares = body.winding.field(spacing=0.05, coverage="fraction", association="cell", padding=0.05)
voxels = body.winding.voxelize(spacing=0.05)
print(f"{mask['mask'].sum()} of {mask.n_points} voxels are inside")

# %% The voxels, and a slice of the shares.
plotter = pv.Plotter(shape=(1, 2), off_screen=bool(arguments.picture), window_size=(1200, 500))
plotter.add_mesh(voxels, color="lightsteelblue", show_edges=True)
plotter.subplot(0, 1)
bar = {"n_labels": 2, "fmt": "%.1f", "position_x": 0.2, "width": 0.6, "height": 0.12}
plotter.add_mesh(
    shares.slice("z"),
    scalars="Coverage",
    clim=(0, 1),
    cmap="Blues",
    lighting=False,
    scalar_bar_args=bar,
)
plotter.add_mesh(body.slice("z"), color="black", line_width=2)
plotter.view_xy()
plotter.show(screenshot=arguments.picture)
