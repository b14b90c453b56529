#!/usr/bin/env bash
# FaceNav's one script: sets up what is missing (Debian packages, one data package by name through npm), builds, runs.
#   ./facenav.sh demo [-o DIR]   the whole path on the virtual patient (default: facenav_demo)
#   ./facenav.sh test            the tests of every module, under a virtual display (some minutes)
#   ./facenav.sh package         the Debian packages and the archive that runs from any folder, in build/release/packages
#   ./facenav.sh manual [--no-pictures]  the manual as a site that can be searched and as a PDF, in build/release/manual
#   ./facenav.sh test --package  those packages: contents, start, demo, removal; without root
#   ./facenav.sh test --full     the long ones: real heads, live sessions, accuracy, the demo's path
#   ./facenav.sh check           before a commit: format and clang-tidy on what changed, layers, fast tests under sanitizers
#   ./facenav.sh benchmark [WORD] every kernel beside its peers: Markdown tables, also in out/benchmarks.md
#   ./facenav.sh gui [ARGS]      the workstation window
#   ./facenav.sh build           set-up and build only
#   ./facenav.sh VERB ...        any verb of the command line tool (see: ./facenav.sh --help)
set -u -o pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
caller=$PWD
cd "$root" || exit 1
export FACENAV_CACHE="${FACENAV_CACHE:-$root/build/cache}"
# One compiler cache for all checkouts of FaceNav: paths below the root are made relative.
export CCACHE_BASEDIR="${CCACHE_BASEDIR:-$root}" CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros
log="$root/build/setup.log"
binaries="$root/build/release/bin"

packages=(
  g++ cmake ninja-build ccache pkg-config
  libeigen3-dev libspdlog-dev nlohmann-json3-dev libcli11-dev libssl-dev zlib1g-dev
  libvtk9-dev libvtk9-qt-dev libgdcm-dev libdcmtk-dev libnifti-dev libnifti2-dev libgiftiio-dev libdeflate-dev libzip-dev libpugixml-dev libtbb-dev
  libopencv-dev libopencv-contrib-dev opencv-data libaravis-dev libdc1394-dev libasound2-dev libsndfile1-dev
  libpcl-dev libdlib-dev libdlib-data libembree-dev qtbase5-dev qttools5-dev qttools5-dev-tools libgl1-mesa-dri
  xvfb xauth mricron-data fonts-dejavu-core fonts-vlgothic qttranslations5-l10n
)
check_packages=(clang-tidy git)
package_packages=(dpkg-dev fakeroot binutils file)
package_test_packages=(lintian desktop-file-utils shared-mime-info unzip bc)
manual_packages=(python3-sphinx python3-myst-parser weasyprint python3-pil)
test_packages=(clang-format libgtest-dev libgmock-dev libapriltag-dev dcm2niix dcmtk dicom3tools libgdcm-tools libopenigtlink-dev opencv-doc snakemake python3-skimage python3-nibabel python3-socketio python3-aiohttp
  python3-sphinx python3-myst-parser)

say() { printf 'facenav: %s\n' "$*"; }
fail() { printf 'facenav: %s\n' "$*" >&2; exit 1; }

# Prints one clear line that explains the failure in the log.
explain() {
  local step=$1
  if grep -q -i -E 'no space left|not enough free space' "$log"; then
    fail "$step failed: the disk is full; free some space (5 GB are needed) and run this again"
  elif grep -q -i -E 'could not resolve|temporary failure|failed to fetch|network is unreachable|ENOTFOUND|ECONNREFUSED|EAI_AGAIN|ETIMEDOUT' "$log"; then
    fail "$step failed: no network; connect this machine and run this again (details: $log)"
  elif grep -q -i 'unable to locate package' "$log"; then
    fail "$step failed: $(grep -i -m1 'unable to locate package' "$log" | sed 's/^E: //'); FaceNav is built on Debian 12 (details: $log)"
  fi
  fail "$step failed: $(grep -i -E '^E: |error' "$log" | tail -n 1 | cut -c1-160) (details: $log)"
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"
  elif command -v sudo >/dev/null; then sudo "$@"
  else fail "packages are missing and neither root nor sudo is at hand; as root run: apt-get install ${missing[*]}"; fi
}

missing_packages() {
  local installed
  installed=$(dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' "$@" 2>/dev/null | sed -n 's/^ii //p')
  for package in "$@"; do grep -q -x -- "$package" <<<"$installed" || printf '%s\n' "$package"; done
}

install_packages() {
  mapfile -t missing < <(missing_packages "$@")
  [ "${#missing[@]}" -eq 0 ] && return
  command -v apt-get >/dev/null || fail "apt-get is not here; FaceNav sets itself up on Debian 12 (packages needed: ${missing[*]})"
  say "installing ${#missing[@]} Debian packages: ${missing[*]}"
  { as_root apt-get update &&
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1 </dev/null ||
    explain "package installation"
}

# The tests start their own archive on loopback. The package's service must never run at the same time.
install_orthanc() {
  [ -z "$(missing_packages orthanc)" ] && return
  missing=(orthanc)
  local policy=/usr/sbin/policy-rc.d
  if [ -d /etc/systemd/system ] && [ ! -e /etc/systemd/system/orthanc.service ]; then
    as_root ln -s /dev/null /etc/systemd/system/orthanc.service
  fi
  if [ -e "$policy" ]; then
    install_packages orthanc
  else
    as_root sh -c "printf '#!/bin/sh\nexit 101\n' >$policy && chmod +x $policy"
    (install_packages orthanc)  # in a subshell: its failure must not leave the policy behind
    local status=$?
    as_root rm -f "$policy"
    [ "$status" -eq 0 ] || exit "$status"
  fi
}

# The virtual patient: a real adult T1 with a whole face, in npm's brainbrowser (AGPL: installed by name, never committed).
fetch_virtual_patient() {
  local folder="$FACENAV_CACHE/brainbrowser" models=package/examples/models work
  [ -f "$folder/structural1.mnc.header.gz" ] && [ -f "$folder/structural1.mnc.raw.gz" ] && return
  command -v npm >/dev/null || install_packages npm
  say "fetching the virtual patient's MRI (npm package brainbrowser 2.3.0, once)"
  mkdir -p "$folder"
  work=$(mktemp -d "$FACENAV_CACHE/fetch.XXXXXX") || fail "no folder can be made in $FACENAV_CACHE; check free disk space"
  { (cd "$work" && npm pack --silent brainbrowser@2.3.0) &&
    tar -xzf "$work"/brainbrowser-2.3.0.tgz -C "$work" $models/structural1.mnc.header.gz $models/structural1.mnc.raw.gz &&
    (cd "$work/$models" && sha256sum -c "$root/Data/virtual_patient.sha256") &&
    mv "$work/$models"/structural1.mnc.* "$folder/"; } >"$log" 2>&1 </dev/null || { rm -rf "$work"; explain "fetching the virtual patient's MRI"; }
  rm -rf "$work"
}

set_up() {
  mkdir -p "$root/build" "$FACENAV_CACHE" 2>/dev/null || fail "cannot write to $root/build; check permissions and free disk space"
  local free_kb; free_kb=$(df -Pk "$root/build" | awk 'NR==2 {print $4}')
  [ "$free_kb" -gt 1000000 ] || fail "the disk is nearly full ($((free_kb / 1024)) MB free); FaceNav needs 5 GB to build"
  install_packages "$@"
}

# build TESTS(ON|OFF) TARGET..: configures if needed, and builds these programs.
build() {
  local tests=$1; shift
  if [ ! -f build/release/build.ninja ] || ! grep -q "FACENAV_BUILD_TESTS:BOOL=$tests" build/release/CMakeCache.txt; then
    say "configuring"
    cmake --preset release -DFACENAV_BUILD_TESTS="$tests" -DFACENAV_ONLY= >"$log" 2>&1 || explain "configuring"
  fi
  ninja -C build/release -n "$@" 2>/dev/null | grep -q 'no work to do' && return
  say "building (release, $(nproc) cores; some minutes the first time)"
  if [ -t 1 ]; then ninja -C build/release "$@" 2>&1 | tee "$log" | grep -E --line-buffered '^\[|error|FAILED' | sed -u 's/^\(\[[0-9/]*\]\).*/\1/' | tr '\n' '\r'
  else ninja -C build/release "$@" >"$log" 2>&1; fi
  [ "${PIPESTATUS[0]}" -eq 0 ] || { grep -E -m5 'error:|FAILED' "$log" >&2; explain "building"; }
}

# -noreset: without it the virtual display restarts when its last client leaves, and refuses clients that connect just then.
on_display() {  # runs a command on the desktop's display, or on a virtual one
  if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then "$@"; else xvfb-run -a -s '-screen 0 1920x1200x24 -noreset' "$@"; fi
}

run_ctest() {  # JOBS ARGS..
  xvfb-run -a -s '-screen 0 1920x1200x24 -noreset' ctest --test-dir build/release --output-on-failure -j "$@"
}

# TIER(default|full) ARGS..: first the tests that compute, one a core; then those that mostly wait (label waits), two a core.
run_tests() {
  local tier=$1 failed=0; shift
  local computing=(-LE '^(full|waits)$') waiting=(-L '^waits$' -LE '^full$')
  if [ "$tier" = full ]; then computing=(-L '^full$' -LE '^waits$') waiting=(-L '^full$' -L '^waits$'); fi
  run_ctest "$(nproc)" "${computing[@]}" "$@" || failed=1
  run_ctest "$((2 * $(nproc)))" "${waiting[@]}" "$@" || failed=1
  return "$failed"
}

# Once tests have been built, later builds include them, so that demo and test do not rebuild each other's work.
tests_wanted() { grep -q 'FACENAV_BUILD_TESTS:BOOL=ON' build/release/CMakeCache.txt 2>/dev/null && echo ON || echo OFF; }

run_benchmarks() {  # those whose name contains $1
  mkdir -p out
  { printf '# Benchmarks: %s, %s cores, %s\n' "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)" "$(nproc)" "$(date -u +%F)"
    grep -- "$1" build/release/benchmarks.txt | while read -r name; do
      "$binaries/$name" </dev/null || printf '\n%s failed (exit status %s)\n' "$name" $?
    done; } | tee out/benchmarks.md
  say "written: $root/out/benchmarks.md"
}

# The manual's pictures: a robot walks through the window (testing/walk), on the virtual patient.
make_manual_pictures() {  # FOLDER
  rm -rf "$1" && mkdir -p "$1"
  if [ ! -d "$FACENAV_CACHE/brainbrowser" ] && [ ! -d "$FACENAV_CACHE/virtual_patient" ]; then
    say "the virtual patient's MRI is missing ('./facenav.sh demo' fetches it): the manual is made without pictures"
    return
  fi
  build ON facenav facenav-lab walk_test
  "$binaries/facenav" demo --only-patient >"$log" 2>&1 || { say "the virtual patient's MRI cannot be read: the manual is made without pictures"; return; }
  say "making the manual's pictures (some minutes)"
  FACENAV_GUI_PICTURES="$1" xvfb-run -a -s '-screen 0 1920x1200x24 -noreset' "$binaries/walk_test" --gtest_brief=1 \
    --gtest_filter='Walk.The*:Walk.A*Person*:Walk.AnEngineer*:Walk.AClinician*' >"$log" 2>&1 ||
    say "the walk through the window found a fault (see $log): pictures may be missing"
}

make_manual() {  # [--no-pictures]
  local out=$root/build/release/manual
  set_up "${packages[@]}" "${manual_packages[@]}"
  local pictures=()
  if [ "${1:-}" != --no-pictures ]; then
    install_packages "${test_packages[@]}"
    make_manual_pictures "$out/pictures"
    pictures=(--pictures "$out/pictures")
  fi
  say "making the manual"
  resources/manual/make_manual.py "$out" "${pictures[@]}" --pdf >"$log" 2>&1 || explain "making the manual"
  say "made: $out/html/index.html and facenav-manual.pdf ($(tail -n 1 "$log"))"
}

make_packages() {
  set_up "${packages[@]}" "${package_packages[@]}"
  build "$(tests_wanted)" facenav facenav-bids facenav-gui facenav-lab
  say "making the packages"
  resources/package/make_packages.sh build/release >"$log" 2>&1 || explain "making the packages"
}

# Prints the sources that differ from the main branch and are not ignored, one name a line.
changed_sources() {
  local base
  base=$(git merge-base HEAD origin/main 2>/dev/null || git merge-base HEAD main 2>/dev/null || git rev-parse HEAD)
  [ "$base" = "$(git rev-parse HEAD)" ] && git diff --quiet HEAD && base=HEAD~1  # on the main branch itself: the last commit
  { git diff --name-only --diff-filter=d "$base" -- '*.h' '*.cpp' '*.cu'; git ls-files --others --exclude-standard -- '*.h' '*.cpp' '*.cu'; } | sort -u
}

# Tests that need no data, no screen and little time. They find most memory and thread errors.
fast_programs=(base_test case_test target_test rig_test)
fast_tests='^(base/.*|case/casefile|target/guidance|target/stimulation|rig/capture|rig/health)$'

run_sanitized() {  # PRESET: builds the fast programs in build/PRESET and runs the fast tests
  local preset=$1
  [ -f "build/$preset/build.ninja" ] ||
    cmake --preset "$preset" -DFACENAV_BUILD_TESTS=ON -DFACENAV_BUILD_UI=OFF -DFACENAV_ONLY= >"$log" 2>&1 || explain "configuring $preset"
  say "building under $preset: ${fast_programs[*]}"
  cmake --build "build/$preset" --target "${fast_programs[@]}" >"$log" 2>&1 || { grep -E -m5 'error:|FAILED' "$log" >&2; explain "building $preset"; }
  ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    xvfb-run -a -s '-screen 0 1920x1200x24 -noreset' ctest --test-dir "build/$preset" --output-on-failure -R "$fast_tests" || fail "a test failed under $preset"
}

run_checks() {
  local changed
  mapfile -t changed < <(changed_sources)
  say "${#changed[@]} sources changed"
  if [ "${#changed[@]}" -gt 0 ]; then
    clang-format --dry-run -Werror "${changed[@]}" || fail "format: run clang-format -i on the files named above"
    mapfile -t changed < <(printf '%s\n' "${changed[@]}" | grep '\.cpp$')
    say "clang-tidy on ${#changed[@]} of them"
    printf '%s\0' "${changed[@]}" | xargs -0 -r -n 1 -P "$(nproc)" clang-tidy -p build/release --quiet 2>"$log" || fail "clang-tidy: see above"
  fi
  cmake --build build/release --target facenav facenav-lab architecture_test >"$log" 2>&1 || { grep -E -m5 'error:|FAILED' "$log" >&2; explain "building"; }
  "$binaries/architecture_test" --gtest_brief=1 || fail "layers: see above"
  run_sanitized asan-ubsan
  say "checked"
}

case "${1:-}" in
  test)
    shift
    if [ "${1:-}" = --package ]; then
      make_packages
      install_packages "${package_test_packages[@]}"
      exec resources/package/test_packages.sh build/release/packages
    fi
    tier=default
    if [ "${1:-}" = --full ]; then tier=full; shift; fi
    set_up "${packages[@]}" "${test_packages[@]}"
    install_orthanc
    fetch_virtual_patient
    build ON all facenav-lab
    "$binaries/facenav" demo --only-patient || fail "the virtual patient's MRI could not be converted"
    say "running the tests"
    run_tests "$tier" "$@"
    ;;
  check)
    shift
    set_up "${packages[@]}" "${test_packages[@]}" "${check_packages[@]}"
    [ "$(tests_wanted)" = ON ] || cmake --preset release -DFACENAV_BUILD_TESTS=ON -DFACENAV_ONLY= >"$log" 2>&1 || explain "configuring"
    run_checks
    ;;
  benchmark)
    shift
    set_up "${packages[@]}" "${test_packages[@]}"
    fetch_virtual_patient
    cmake --preset release -DFACENAV_BUILD_BENCHMARKS=ON -DFACENAV_ONLY= >"$log" 2>&1 || explain "configuring"
    say "building the benchmarks"
    cmake --build build/release --target facenav facenav-lab facenav_benchmarks >"$log" 2>&1 ||
      { grep -E -m5 'error:|FAILED' "$log" >&2; explain "building"; }
    "$binaries/facenav" demo --only-patient || fail "the virtual patient's MRI could not be converted"
    run_benchmarks "${1:-}"
    ;;
  build)
    set_up "${packages[@]}"
    build "$(tests_wanted)" facenav facenav-bids facenav-gui facenav-lab
    say "built: $binaries/facenav"
    ;;
  package)
    make_packages
    for file in build/release/packages/*; do say "made: $root/$file ($(du -h "$file" | cut -f1))"; done
    ;;
  manual)
    shift
    make_manual "$@"
    ;;
  gui)
    shift
    set_up "${packages[@]}"
    build "$(tests_wanted)" facenav facenav-gui
    [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || fail "no display here; start this on a desktop (or under xvfb-run)"
    cd "$caller" && exec "$binaries/facenav-gui" "$@"
    ;;
  '' | help)
    sed -n '2,13s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    ;;
  demo | simulate | evaluate)  # the laboratory; without the window
    set_up "${packages[@]}" python3-skimage
    fetch_virtual_patient
    build "$(tests_wanted)" facenav facenav-lab
    cd "$caller" && exec "$binaries/facenav" "$@"
    ;;
  *)
    set_up "${packages[@]}"
    build "$(tests_wanted)" facenav facenav-bids
    cd "$caller" && exec "$binaries/facenav" "$@"
    ;;
esac
