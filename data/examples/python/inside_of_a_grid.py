# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The part of a grid inside an open surface: python inside_of_a_grid.py [--picture part.png]"""

# %% A sphere with its top cut off, and a grid of tetrahedra around it.
import argparse

import pyvista as pv

parser = argparse.ArgumentParser()
parser.add_argument("--picture")
arguments = parser.parse_args()
bowl = pv.Sphere().clip("z", origin=(0, 0, 0.35))
grid = pv.ImageData(dimensions=(31, 31, 31), spacing=(0.04,) * 3, origin=(-0.6,) * 3)
mesh = grid.to_tetrahedra()

# %% Winding numbers tell inside from outside though the bowl is open.
mesh = mesh.winding.sample(bowl)
mesh = mesh.winding.signed_distance(bowl)
part = mesh.winding.extract_interior(bowl)
print(f"{part.n_cells} of {mesh.n_cells} cells are inside")

# %% A slice of the winding number, and the part, coloured by the distance to the bowl.
plotter = pv.Plotter(shape=(1, 2), off_screen=bool(arguments.picture), window_size=(1200, 500))
bar = {"n_labels": 2, "fmt": "%.1f", "position_x": 0.2, "width": 0.6, "height": 0.12}
plotter.add_mesh(
    mesh.slice("y"), scalars="WindingNumber", clim=(0, 1), lighting=False, scalar_bar_args=bar
)
plotter.add_mesh(bowl, style="wireframe", color="black", opacity=0.3)
plotter.subplot(0, 1)
plotter.add_mesh(
    part.clip("-y"),
    scalars="implicit_distance",
    clim=(-0.5, 0),
    show_edges=True,
    line_width=0.3,
    scalar_bar_args=bar,
)
plotter.add_mesh(bowl, style="wireframe", color="black", opacity=0.2)
plotter.link_views()
plotter.camera_position = "xz"
plotter.camera.azimuth = 20
plotter.camera.elevation = 15
plotter.show(screenshot=arguments.picture)
