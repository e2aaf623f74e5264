#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# Makes a release of the last commit in out/release: sources, Debian packages, wheels, the zip for
# ParaView, recipes with the hash of the sources, an SBOM, and checksums.
#
# Usage: release.sh <python with the linters of recipes and SBOMs>, which ./dev release gives
#
# All that is compiled is made twice, from two unpacked copies of the archive, and has to have the
# same bytes. The second copy has a longer path, and a cache of compiled files that is empty.
# SOURCE_DATE_EPOCH, the time of the commit, stands wherever the time of the build would.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python=$PWD/$1
release=$PWD/out/release
copies=$PWD/build/release-copies
version=$(sed -n 's/^project(vtkWinding VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
archive=$release/winding-$version.tar.gz

die() {
  echo "release.sh: $*" >&2
  exit 1
}

git diff --quiet HEAD -- || die "commit or stash your changes: a release is made of the last commit"
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH LC_ALL=C.UTF-8 TZ=UTC PYTHONHASHSEED=0
umask 022

# make_in <folder> <variable=value…>: unpacks the archive there and makes what is compiled, by the
# tools of this checkout.
make_in() {
  local folder=$1 tool
  mkdir -p "$folder/build"
  tar -xzf "$archive" -C "$folder" --strip-components=1
  for tool in paraview-sdk vtk-sdk wheel-tools; do
    ln -s "$PWD/build/$tool" "$folder/build/$tool"
  done
  [[ ! -d ../shared ]] || ln -s "$(realpath ../shared)" "$folder/../shared"
  env "${@:2}" "$folder/dev" artifacts
}

# made_in <folder>: the names of what was made there.
made_in() {
  (cd "$1" && find out/packages out/wheel build/package-paraview/zip -type f | sort)
}

rm -rf "$release" "$copies"
mkdir -p "$release"
git archive --format=tar --prefix="winding-$version/" HEAD | gzip -9n >"$archive"
first=$copies/first/winding second=$copies/second/in/another/folder/winding
printf '\nThe first copy\n'
make_in "$first"
printf '\nThe second copy\n'
make_in "$second" CCACHE_DIR="$copies/second/ccache"

printf '\nBytes of both copies\n'
[[ $(made_in "$first") == "$(made_in "$second")" ]] || die "the copies have made different files"
differ=()
for name in $(made_in "$first"); do
  if cmp "$first/$name" "$second/$name"; then
    echo "same       $(basename "$name")"
    cp -p "$first/$name" "$release"
  else
    echo "DIFFERENT  $(basename "$name")"
    differ+=("$name")
  fi
done
[[ ${#differ[@]} -eq 0 ]] || die "not the same bytes: ${differ[*]} in $first and in $second"

printf '\nTests of what was made\n'
python3 tests/packages/packages_test.py "$release"/vtk-winding_*.deb \
  "$release"/paraview-winding_*.deb build/paraview-sdk build/release-copies/roots
PYTHONDONTWRITEBYTECODE=1 "$python" tests/packages/recipes_test.py

mkdir "$release/recipes"
sha256=$(sha256sum "$archive" | cut -d ' ' -f 1)
sha512=$(sha512sum "$archive" | cut -d ' ' -f 1)
for name in conda-forge vcpkg spack homebrew; do
  cp -r "packages/$name" "$release/recipes"
done
find "$release/recipes" -type f \
  -exec sed -i "s/\b0\{64\}\b/$sha256/; s/SHA512 0)/SHA512 $sha512)/" {} +

printf '\nThe SBOM\n'
bill=$release/winding-$version.spdx.json
/usr/bin/python3 packages/sbom.py "$release" "$version" "$first/build" >"$bill"
"$(dirname "$python")/pyspdxtools" --infile "$bill"
(cd "$release" && find . -type f ! -name SHA256SUMS -printf '%P\0' | sort -z | xargs -0 sha256sum) \
  >"$release.sums"
mv "$release.sums" "$release/SHA256SUMS"
cat "$release/SHA256SUMS"
