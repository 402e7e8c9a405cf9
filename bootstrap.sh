#!/usr/bin/env bash
# From a bare Debian machine to a result, or to the end of the tests:
#   ./bootstrap.sh demo    install what is missing, build, run the main job (presets/quickstart.toml)
#   ./bootstrap.sh test    install what is missing, build, run every test but those labelled slow
#   ./bootstrap.sh --help  this text
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
  'libchafa-dev|pictures in the terminal'
  'libglib2.0-dev|needed by it'
  'pkg-config|finds it'
  'ffmpeg|films'
)

usage() { sed -n '2,6p' "$0" | sed 's/^# \{0,1\}//'; }

say() { printf '\n== %s\n' "$*" >&2; }

list_needs() {
  echo "rift needs these Debian packages, or what they hold under your system's names:" >&2
  local entry
  for entry in "${packages[@]}"; do printf '  %-22s %s\n' "${entry%%|*}" "${entry#*|}" >&2; done
  echo "Then: cmake --preset release && cmake --build --preset release" >&2
}

is_installed() { [ "$(dpkg-query -W -f='${Status}' "$1" 2>/dev/null)" = 'install ok installed' ]; }

# The answer is read whole: with pipefail, a grep that stops at its match would make the writer's SIGPIPE a "no".
is_offered() { [[ $(apt-cache policy "$1" 2>/dev/null) =~ 'Candidate: '[^\(] ]]; }

# Prints the packages that are missing and can be had; one of OSMesa and EGL suffices.
obtainable() { # MISSING...
  local package other gone=()
  for package in "$@"; do
    if is_offered "$package"; then
      echo "$package"
      continue
    fi
    case "$package" in
      chromium)
        say "this system has no chromium: the tests of the reports' pages will be skipped"
        continue
        ;;
      slurm-wlm | munge)
        say "this system has no $package: the test of a study under Slurm will be skipped"
        continue
        ;;
      libchafa-dev)
        say "this system has no libchafa-dev: terminals get no pictures, and rift view shows cells"
        continue
        ;;
      libosmesa6-dev) other=libegl-dev ;;
      libegl-dev) other=libosmesa6-dev ;;
      *) other='' ;;
    esac
    if [ -n "$other" ] && { is_installed "$other" || is_offered "$other"; }; then
      say "this system has no $package: pictures are drawn with $other"
    else
      gone+=("$package")
    fi
  done
  [ ${#gone[@]} -eq 0 ] && return
  echo "this system's package lists have no ${gone[*]}" >&2
  list_needs
  return 1
}

install_missing() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    list_needs
    exit 1
  fi
  local missing=() entry sudo=() wanted
  for entry in "${packages[@]}"; do is_installed "${entry%%|*}" || missing+=("${entry%%|*}"); done
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "neither root nor sudo: ask for the packages below" >&2; list_needs; exit 1; }
    sudo=(sudo)
  fi
  "${sudo[@]}" apt-get update -qq
  wanted=$(obtainable "${missing[@]}") || exit 1
  [ -n "$wanted" ] || return 0
  say "installing" $wanted "and what they need (up to 1.5 GB and a few minutes for the renderer)"
  # shellcheck disable=SC2086  # names without spaces
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $wanted |
    awk -v live="$([ -t 2 ] && echo 1)" '
      /^Setting up/ { ++n; if (live) printf "\r   %d packages set up", n > "/dev/stderr" }
      END { if (n) printf "%s   %d packages set up\n", live ? "\r" : "", n > "/dev/stderr" }'
}

build() { # TARGET...
  say "building (build/release; the first time, on two cores, some three minutes for the demo and eight to ten for the tests)"
  cmake --preset release -DRIFT_VIZ="$viz" -DRIFT_KERNELS="$kernels" >/dev/null
  cmake --build --preset release --target "$@"
  ln -sf build/release/studio/rift rift
}

what=''
viz=ON
kernels=all
plain=()
for argument in "$@"; do
  case "$argument" in
    demo | test) what=$argument ;;
    --no-viz) viz=OFF ;;
    --plain) plain=(--plain) ;;
    -h | --help) usage; exit 0 ;;
    *) echo "bootstrap.sh: unknown argument '$argument'" >&2; usage >&2; exit 2 ;;
  esac
done
[ -n "$what" ] || { usage >&2; exit 2; }
[ $viz = OFF ] || packages+=("${viz_packages[@]}")
[ "$what" = demo ] || packages+=('tmux|tests of the panels' 'doxygen|reference of the engine' 'python3-h5py|tests of the Python examples'
  'python3-numpy|the run that a test rebuilds' 'python3-scipy|the same'
  "chromium|tests of the reports' pages" 'xterm|tests of pictures in a terminal' 'xvfb|the same' 'xfonts-base|the same'
  'imagemagick|the same' 'slurm-wlm|tests of studies on a cluster' 'munge|the same')

install_missing
if [ "$what" = demo ]; then
  kernels=native  # for this machine only: the compiler is done sooner
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
