// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/* Makes a closed surface of a broken one, with libwinding alone: no VTK, and no C++.
 *
 * Usage: solid INPUT OUTPUT.off [RESOLUTION] */
#include "winding.h"

#include <stdio.h>
#include <stdlib.h>

static void warn(const char* text, void* user)
{
  (void)user;
  fprintf(stderr, "warning: %s\n", text);
}

/* Ends the program where a call was refused. */
static void check(winding_status status, const winding_refusal* refusal)
{
  if (status != WINDING_OK)
  {
    fprintf(stderr, "error: %s\n", refusal->text);
    exit(EXIT_FAILURE);
  }
}

static int write_off(const char* path, const winding_mesh_arrays* mesh)
{
  FILE* file = fopen(path, "w");
  if (!file)
  {
    return 0;
  }
  fprintf(file, "OFF\n%ld %ld 0\n", (long)mesh->point_count, (long)mesh->polygon_count);
  for (int64_t i = 0; i < mesh->point_count; ++i)
  {
    const double* p = (const double*)mesh->points + 3 * i;
    fprintf(file, "%.17g %.17g %.17g\n", p[0], p[1], p[2]);
  }
  for (int64_t i = 0; i < mesh->polygon_count; ++i)
  {
    fprintf(file, "%ld", (long)(mesh->offsets[i + 1] - mesh->offsets[i]));
    for (int64_t j = mesh->offsets[i]; j < mesh->offsets[i + 1]; ++j)
    {
      fprintf(file, " %ld", (long)mesh->corners[j]);
    }
    fprintf(file, "\n");
  }
  return fclose(file) == 0;
}

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    fprintf(stderr, "usage: %s INPUT OUTPUT.off [RESOLUTION]\n", argv[0]);
    return EXIT_FAILURE;
  }
  winding_refusal refusal;
  winding_run run;
  winding_run_init(&run, sizeof run);
  run.warn = warn;

  winding_mesh* input = NULL;
  check(winding_read(argv[1], &run, &input, &refusal), &refusal);
  winding_mesh_arrays arrays;
  winding_mesh_arrays_init(&arrays, sizeof arrays);
  check(winding_mesh_show(input, &arrays, &refusal), &refusal);

  if (arrays.polygon_count == 0)
  {
    fprintf(stderr, "error: %s has no faces\n", argv[1]);
    return EXIT_FAILURE;
  }
  const winding_array points = {arrays.points, arrays.point_count, 0, arrays.type};
  const winding_polygons polygons = {{arrays.corners, arrays.corner_count, 0, WINDING_INT64},
    {arrays.offsets, arrays.polygon_count + 1, 0, WINDING_INT64}};
  winding_field* field = NULL;
  check(winding_faces(points, &polygons, NULL, &run, &field, &refusal), &refusal);
  winding_mesh_free(input);

  winding_field_info info;
  winding_field_info_init(&info, sizeof info);
  check(winding_describe(field, &info, &refusal), &refusal);
  winding_grid_request request;
  winding_grid_request_init(&request, sizeof request);
  request.resolution = argc > 3 ? atoi(argv[3]) : 64;
  for (int i = 0; i < 6; ++i)
  {
    request.sampling_bounds[i] = info.bounds[i];
  }
  winding_grid grid;
  check(winding_lay_out_grid(&request, &run, &grid, &refusal), &refusal);

  winding_surface_options options;
  winding_surface_options_init(&options, sizeof options);
  options.type = WINDING_FLOAT64;
  winding_mesh* surface = NULL;
  check(winding_level_surface(field, &grid, NULL, &options, &run, &surface, &refusal), &refusal);
  check(winding_mesh_show(surface, &arrays, &refusal), &refusal);
  const int is_written = write_off(argv[2], &arrays);
  printf("%ld faces written to %s\n", (long)arrays.polygon_count, argv[2]);
  winding_mesh_free(surface);
  winding_field_free(field);
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
