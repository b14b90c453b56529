#!/usr/bin/env bash
# test_packages.sh PACKAGES: checks what make_packages.sh made, as a user without root and without a build tree. Each check
# prints one line; the exit status is 1 if one failed.
set -u -o pipefail
packages=$(cd "$1" && pwd)
place=$(mktemp -d "${TMPDIR:-/tmp}/facenav_package.XXXXXX") || exit 1
trap 'rm -rf "$place"' EXIT
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
deb=$(echo "$packages"/facenav_*.deb) lab=$(echo "$packages"/facenav-lab_*.deb) archive=$(echo "$packages"/facenav-*.tar.gz)
cache=${FACENAV_CACHE:-$source/build/cache}
failures=0
ok() { printf 'ok      %s\n' "$*"; }
bad() { printf 'FAILED  %s\n' "$*"; failures=$((failures + 1)); }
check() { local words=$1; shift; if "$@" >"$place/said" 2>&1; then ok "$words"; else bad "$words"; sed 's/^/        /' "$place/said" | head -n 12; fi; }

# Without root no owner can be set: the files are unpacked, and dpkg's own database lies in the prefix.
root=$place/root
mkdir -p "$root"
holds() { grep -q -x -- "$1" "$place/list"; }
lacks() { ! grep -q -E -- "$1" "$place/list"; }
dpkg-deb -c "$deb" | awk '{print $6}' >"$place/list"
for file in bin/facenav bin/facenav-cli bin/facenav-gui bin/facenav-bids share/facenav/brain_prior/weights.fnbp share/applications/facenav.desktop \
  share/mime/packages/facenav.xml share/icons/hicolor/scalable/apps/facenav.svg share/man/man1/facenav-prepare.1.gz share/man/man1/facenav-gui.1.gz \
  share/bash-completion/completions/facenav share/doc/facenav/copyright share/doc/facenav/facenav.spdx.json share/doc/facenav/manual/safety.md; do
  check "the clinic's package holds $file" holds "./usr/$file"
done
check "it holds no laboratory, no test and no source" lacks 'facenav-lab($|\.)|_test|\.cpp$|\.h$|virtual_patient'
check "it depends on the data that the programs read" grep -q -E 'libdlib-data.*mricron-data|mricron-data.*libdlib-data' <(dpkg-deb -f "$deb" Depends)
check "its libraries were found by shlibdeps" grep -q 'libvtk9.1 (>=' <(dpkg-deb -f "$deb" Depends)
size_kb=$(dpkg-deb -f "$deb" Installed-Size)
check "it needs less than 60 MB ($size_kb kB)" test "$size_kb" -lt 60000
lintian "$deb" "$lab" >"$place/lintian" 2>/dev/null
check "lintian finds no error and warns of nothing" bash -c '! grep "^[EW]:" "$1"' _ "$place/lintian"

if holds ./usr/share/doc/facenav/manual/html/index.html; then
  check "the manual's site comes with its search" holds ./usr/share/doc/facenav/manual/html/searchindex.js
  check "and as a PDF" holds ./usr/share/doc/facenav/manual/facenav-manual.pdf
else
  printf 'skipped the manual as a site: ./facenav.sh manual was not run before\n'
fi

dpkg-deb -x "$deb" "$root"
check "the desktop entry is valid" desktop-file-validate "$root/usr/share/applications/facenav.desktop"
check "the MIME types are valid" update-mime-database "$root/usr/share/mime"
check "a case.json is a FaceNav case" grep -q 'application/x-facenav-case' "$root/usr/share/mime/globs2"
check "no program holds a path of the source tree" bash -c '! strings -a "$1"/usr/bin/* | grep -q -F "$2/"' _ "$root" "$source"

# An environment without build tree, cache and settings, and a home of its own.
home=$place/home
mkdir -p "$home"
clean() { env -i PATH="$root/usr/bin:/usr/bin:/bin" HOME="$home" LANG=C.UTF-8 "$@"; }
check "--version" grep -q 'commit' <(clean facenav --version)
check "a verb: series of an empty folder" bash -c '! "$@"' _ env -i PATH="$root/usr/bin:/usr/bin:/bin" HOME="$home" facenav series "$home"
check "licences" grep -q 'VTK' <(clean facenav licences)
check "the brain prior is found beside the program" grep -q '"brain prior": true' <(clean facenav support-bundle -o "$home/b.zip" --quiet && unzip -p "$home/b.zip" program.json)
check "without the laboratory, demo says what to install" grep -q 'facenav-lab' <(clean facenav demo 2>&1)

window() {
  xvfb-run -a -s '-screen 0 1920x1200x24 -noreset' env -u FACENAV_CACHE -u FACENAV_DATA -u XDG_CONFIG_HOME -u XDG_DATA_HOME \
    PATH="$root/usr/bin:/usr/bin:/bin" HOME="$home" facenav-gui "$@" --screenshot "$place/window.png" --after 0.1
}
check "the window starts" window
check "it shows something" bash -c 'test "$(stat -c %s "$1")" -gt 20000' _ "$place/window.png"
began=$(date +%s.%N)
check "the window starts again" window
printf '        %.1f s with the start of Xvfb, 0.1 s of waiting and the picture\n' "$(echo "$(date +%s.%N) - $began" | bc)"
mkdir -p "$home/no case"
check "a folder that is no case is wrong usage" bash -c '"$@"; test $? -eq 2' _ env HOME="$home" "$root/usr/bin/facenav-gui" "$home/no case"

dpkg-deb -x "$lab" "$root"
check "with the laboratory, demo says where the virtual patient goes" grep -q 'brainbrowser' <(clean facenav demo -o "$home/demo" 2>&1)
if [ -d "$cache/brainbrowser" ] || [ -d "$cache/virtual_patient" ]; then
  check "with the virtual patient, demo finds it and the data" clean FACENAV_CACHE="$cache" facenav demo --only-patient
else
  printf 'skipped the demo: the virtual patient is not in %s\n' "$cache"
fi

# Installed and removed by dpkg itself, in a prefix; fakeroot stands in for root.
check "dpkg installs it into a prefix" fakeroot bash -c '
  mkdir -p "$1/var/lib/dpkg"/{updates,info,triggers} "$1/var/log" && touch "$1/var/lib/dpkg/status" "$1/var/lib/dpkg/available" &&
  dpkg --root="$1" --force-depends --force-not-root --force-script-chrootless --install "$2" "$3"' _ "$place/prefix" "$deb" "$lab"
check "and removes all of it" fakeroot bash -c '
  dpkg --root="$1" --force-depends --force-not-root --force-script-chrootless --purge facenav-lab facenav &&
  ! find "$1/usr" -name "*facenav*" 2>/dev/null | grep .' _ "$place/prefix"

mkdir "$place/elsewhere with blank"
tar -xzf "$archive" -C "$place/elsewhere with blank"
top=$(echo "$place/elsewhere with blank"/facenav-*)
check "the archive runs from any folder" grep -q commit <(env -i PATH=/usr/bin:/bin HOME="$home" "$top/facenav" --version)
check "it finds its data there" grep -q '"brain prior": true' <(env -i PATH=/usr/bin:/bin HOME="$home" "$top/facenav" support-bundle -o "$home/c.zip" --quiet && unzip -p "$home/c.zip" program.json)
printf 'no-such-package\n' >>"$top/PACKAGES"
check "its launcher names what is missing" grep -q 'no-such-package' <(env -i PATH=/usr/bin:/bin HOME="$home" "$top/facenav" --version 2>&1)

printf '%s of the checks failed\n' "$failures"
[ "$failures" -eq 0 ]
