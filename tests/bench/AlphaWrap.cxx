// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Wraps a triangle mesh by CGAL's alpha wrapping, which offsets it outward, for solids_peers.py:
//   alpha_wrap <in.off> <alpha> <offset> <out.off>
// Prints the seconds of the wrapping.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

int main(int argc, char** argv)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  if (argc != 5)
  {
    std::fprintf(stderr, "alpha_wrap <in.off> <alpha> <offset> <out.off>\n");
    return 1;
  }
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  if (!CGAL::IO::read_polygon_soup(argv[1], points, faces))
  {
    std::fprintf(stderr, "cannot read %s\n", argv[1]);
    return 1;
  }
  CGAL::Surface_mesh<Kernel::Point_3> wrap;
  const auto begin = std::chrono::steady_clock::now();
  CGAL::alpha_wrap_3(points, faces, std::atof(argv[2]), std::atof(argv[3]), wrap);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::printf("%.3f\n", seconds.count());
  std::ofstream file(argv[4]);
  file.precision(17);
  return CGAL::IO::write_OFF(file, wrap) ? 0 : 1;
}
