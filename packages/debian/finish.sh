#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# Packs a package of CPack once more, by dpkg-deb.
#
# Usage: finish.sh <package.deb>
#
# CPack adds scripts that call ldconfig where Debian asks for a trigger, which packages/debian.cmake
# adds. dpkg-deb sorts the files, and gives none a time later than SOURCE_DATE_EPOCH.
set -euo pipefail

package=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
dpkg-deb --raw-extract "$package" "$folder/root"
rm -f "$folder/root/DEBIAN/postinst" "$folder/root/DEBIAN/postrm"
dpkg-deb --root-owner-group -Zxz --build "$folder/root" "$folder/new.deb"
mv "$folder/new.deb" "$package"
