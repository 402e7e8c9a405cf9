#!/usr/bin/env bash
# From a bare Debian machine to a result, or to the end of the tests:
#   ./bootstrap.sh demo    install what is missing, build, run the main job (presets/quickstart.toml)
#   ./bootstrap.sh test    install what is missing, build, run every test but those labelled slow
# Options: --no-viz leaves the renderer (VTK) out; --plain shows lines in place of the live panel. A second call does no work twice.
set -euo pipefail
cd "$(dirname "$0")"

# Debian package | what it is for
packages=(
  'g++|C++20 compiler'
  'cmake|3.25 or later'
  'ninja-build|build tool'
  'libeigen3-dev|linear algebra'
  'libhdf5-dev|result archives'
  'libfmt-dev|text'
  'libtomlplusplus-dev|presets'
  'libcli11-dev|command line'
  'nlohmann-json3-dev|summaries'
  'libxxhash-dev|checksums'
  'libgtest-dev|tests'
  'gnuplot-nox|charts of reports'
  'libncurses-dev|panels in the terminal'
)
viz_packages=(  # --no-viz leaves them out
  'libvtk9-dev|pictures and films'
  'libosmesa6-dev|OpenGL without a display'
  'libegl-dev|the same where OSMesa is gone'
  'libpng-dev|pictures'
  'ffmpeg|films'
)

usage() {
  sed -n '2,5p' "$0" | sed 's/^# \{0,1\}//' >&2
  exit 2
}

say() { printf '\n== %s\n' "$*" >&2; }

list_needs() {
  echo "rift needs these Debian packages, or what they hold under your system's names:" >&2
  local entry
  for entry in "${packages[@]}"; do printf '  %-22s %s\n' "${entry%%|*}" "${entry#*|}" >&2; done
  echo "Then: cmake --preset release && cmake --build --preset release" >&2
}

install_missing() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    list_needs
    exit 1
  fi
  local missing=() entry
  for entry in "${packages[@]}"; do
    [ "$(dpkg-query -W -f='${Status}' "${entry%%|*}" 2>/dev/null)" = 'install ok installed' ] || missing+=("${entry%%|*}")
  done
  [ ${#missing[@]} -eq 0 ] && return
  say "installing ${missing[*]}"
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "neither root nor sudo: ask for the packages named above" >&2; list_needs; exit 1; }
    sudo=(sudo)
  fi
  "${sudo[@]}" apt-get update -qq
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

build() { # TARGET...
  say "building (build/release)"
  cmake --preset release -DRIFT_VIZ="$viz" >/dev/null
  cmake --build --preset release --target "$@"
  ln -sf build/release/studio/rift rift
}

what=''
viz=ON
plain=()
for argument in "$@"; do
  case "$argument" in
    demo | test) what=$argument ;;
    --no-viz) viz=OFF ;;
    --plain) plain=(--plain) ;;
    *) usage ;;
  esac
done
[ -n "$what" ] || usage
[ $viz = OFF ] || packages+=("${viz_packages[@]}")
[ "$what" = demo ] || packages+=('tmux|tests of the panels')

install_missing
if [ "$what" = demo ]; then
  build rift
  say 'running presets/quickstart.toml'
  if [ $viz = ON ]; then
    ./rift run quickstart --out runs/demo --force --render "${plain[@]}"
    ./rift render runs/demo --poster --force --quiet
  else
    ./rift run quickstart --out runs/demo --force "${plain[@]}"
  fi
  say 'next: ./rift opens the workbench; ./rift list, ./rift check plate_pnrt, ./rift run plate_pnrt'
else
  build all
  say 'testing'
  results=build/release/test_results.xml
  rm -f "$results"
  failed=0
  ctest --preset release --output-junit "$PWD/$results" || failed=1
  tests/unexpected_skips.sh "$results" tests/expected_skips.txt || failed=1
  exit $failed
fi
