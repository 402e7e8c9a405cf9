#!/usr/bin/env bash
# What bootstrap.sh installs on a machine where nothing is installed, with stand-ins for the package tools.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Long answers, as of a machine with many sources: a reader that stops early kills the writer.
cat >"$folder/apt-cache" <<'END'
#!/bin/sh
if grep -qx -- "$2" "$GONE"; then
  exit 0
fi
printf '%s:\n  Installed: (none)\n  Candidate: 1.0\n' "$2"
seq 200000
END
printf '#!/bin/sh\nexit 1\n' >"$folder/dpkg-query"
printf '#!/bin/sh\necho "$*" >>"%s/asked"\n' "$folder" >"$folder/apt-get"
printf '#!/bin/sh\n[ "$1" = env ] && shift 2\nexec "$@"\n' >"$folder/sudo"
chmod +x "$folder"/{apt-cache,dpkg-query,apt-get,sudo}

# Everything of bootstrap.sh up to the installation, then the installation.
{ sed '/^install_missing$/,$d' bootstrap.sh; echo install_missing; } >"$folder/install.sh"
install() { # GONE...
  : >"$folder/asked"
  printf '%s\n' "$@" >"$folder/gone"
  (cd "$folder" && GONE="$folder/gone" PATH="$folder:$PATH" bash install.sh test >"$folder/out" 2>&1)
}
fail() {
  printf '%s; it wrote and asked for:\n' "$1"
  cat "$folder/out" "$folder/asked"
  exit 1
}

install none || fail 'an installation of what every source has failed'
for package in g++ libeigen3-dev libvtk9-dev libosmesa6-dev libegl-dev ffmpeg tmux chromium; do
  grep -q "^install .* $package\( \|$\)" "$folder/asked" || fail "$package was not installed"
done

install libosmesa6-dev || fail 'EGL did not suffice'
grep -q 'pictures are drawn with libegl-dev' "$folder/out" || fail 'the other renderer was not named'
! grep -q libosmesa6-dev "$folder/asked" || fail 'a package that is gone was asked for'

install chromium || fail 'tests need no browser'
! grep -q chromium "$folder/asked" || fail 'a browser that is gone was asked for'

! install libosmesa6-dev libegl-dev || fail 'no renderer passed'
! install libhdf5-dev || fail 'a missing library passed'
grep -q 'have no libhdf5-dev' "$folder/out" || fail 'the missing library was not named'
! grep -q '^install' "$folder/asked" || fail 'something was installed all the same'
