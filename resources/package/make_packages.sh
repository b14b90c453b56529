#!/usr/bin/env bash
# make_packages.sh BUILD: makes BUILD/packages/facenav_*.deb, facenav-lab_*.deb and facenav-VERSION-linux-ARCH.tar.gz from the
# programs in BUILD/bin. The archive runs from any folder. It holds no libraries: some that OpenCV brings along are under
# the GPL, and Debian's own get Debian's security updates. Its launcher names the packages that are missing.
set -eu -o pipefail
build=$(cd "$1" && pwd)
source=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
value() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }
version=$(value CMAKE_PROJECT_VERSION)
packages=$build/packages
rm -rf "$packages"
"$source/make_files.sh" "$build/bin" "$build/package" "$version" "$(value FACENAV_MAINTAINER)"
SOURCE_DATE_EPOCH=$(git -C "$source" log -1 --format=%ct 2>/dev/null || date +%s)
export SOURCE_DATE_EPOCH
(umask 022 && cd "$build" && cpack --config CPackConfig.cmake)
rm -rf "$packages/_CPack_Packages"

arch=$(dpkg --print-architecture)
top=facenav-$version-linux-$arch
(umask 022 && cmake --install "$build" --component clinic --strip --prefix "$build/archive/$top" >/dev/null)
install -m 755 "$source/launcher" "$build/archive/$top/facenav"
# A package with an alternative comes with one that needs it.
dpkg-deb -f "$packages/facenav_${version}_$arch.deb" Depends | tr ',' '\n' | grep -v '|' | sed 's/^ *//; s/ .*//' | sort -u >"$build/archive/$top/PACKAGES"
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" -C "$build/archive" -cf - "$top" |
  gzip -9n >"$packages/$top.tar.gz"
rm -rf "$build/archive"
