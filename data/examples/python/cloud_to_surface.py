# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""From points alone to a surface: python cloud_to_surface.py [--picture surface.png]"""

# %% Points of a bent tube, as a scanner gives them: without faces and without normals.
import argparse

import numpy as np
import pyvista as pv

import vtkwinding

parser = argparse.ArgumentParser()
parser.add_argument("--picture")
arguments = parser.parse_args()
torus = pv.ParametricTorus(ringradius=1, crosssectionradius=0.35)
points = torus.points[np.random.default_rng(1).permutation(torus.n_points)[:6000]]

# %% The area that each point stands for, and the surface around all of them.
cloud = pv.PolyData(points).winding.estimate_areas(estimate_normals=True)
vertices, faces = vtkwinding.surface(points, estimate_normals=True, resolution=96)
surface = pv.PolyData.from_regular_faces(vertices, faces)
print(f"{surface.n_cells} triangles, volume {surface.volume:.4g}, {torus.volume:.4g} is right")

# %% The points by their areas, and the surface.
plotter = pv.Plotter(shape=(1, 2), off_screen=bool(arguments.picture), window_size=(1200, 500))
bar = {"n_labels": 2, "fmt": "%.1e", "position_x": 0.2, "width": 0.6, "height": 0.12}
plotter.add_mesh(
    cloud, scalars="Area", point_size=4, render_points_as_spheres=True, scalar_bar_args=bar
)
plotter.subplot(0, 1)
plotter.add_mesh(surface, color="lightsteelblue", smooth_shading=True)
plotter.link_views()
plotter.show(screenshot=arguments.picture)
