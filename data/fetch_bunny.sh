#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# Fetches the Stanford bunny into build/data, and cuts holes into a copy of it:
#   bunny00.off      75 408 triangles, closed
#   bunny_holes.off  the same with three holes, the demo's input
# It comes from the Debian package libcgal-demo, which is downloaded and unpacked, not installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Drops the triangles whose first vertex lies in one of the balls (centre, radius).
cut_holes() {
  awk '
    BEGIN {
      holes = split("0.12 0.1 0.06 0.15; -0.4 -0.15 0.06 0.14; 0.2 -0.25 0.36 0.1", ball, ";")
      vertices = kept = read = 0
    }
    NF == 0 || $1 == "OFF" { next }
    !vertices { vertices = $1; next }
    read < vertices { vertex[read++] = $0; next }
    {
      split(vertex[$2], p)
      for (i = 1; i <= holes; i++) {
        split(ball[i], c)
        if ((p[1] - c[1])^2 + (p[2] - c[2])^2 + (p[3] - c[3])^2 < c[4]^2) next
      }
      face[kept++] = $0
    }
    END {
      print "OFF"
      print vertices, kept, 0
      for (i = 0; i < vertices; i++) print vertex[i]
      for (i = 0; i < kept; i++) print face[i]
    }'
}

if [[ -s build/data/bunny_holes.off ]]; then
  exit
fi

mkdir -p build/data
temporary=$(mktemp -d build/data/fetch.XXXXXX)
trap 'rm -rf "$temporary"' EXIT
(cd "$temporary" && apt-get download libcgal-demo)
# The meshes lie in an archive inside the package.
dpkg-deb --fsys-tarfile "$temporary"/libcgal-demo_*.deb |
  tar -xO ./usr/share/doc/libcgal-dev/data.tar.gz |
  tar -xzO data/meshes/bunny00.off >"$temporary/bunny00.off"
cut_holes <"$temporary/bunny00.off" >"$temporary/bunny_holes.off"
mv "$temporary/bunny00.off" "$temporary/bunny_holes.off" build/data
