#!/usr/bin/env bash
# Which folder may know which: every #include across folders is in the table, whose folders know only folders above them.
# usage: include_direction.sh SOURCE_DIR
set -u
cd "$1" || exit 2
wrong=0

table='
engine/base:
engine/history:
engine/theory:
engine/results:      base
engine/packing:      base
engine/lattice:      base packing
engine/fracture:     base history results packing lattice
engine/reference:    history packing lattice fracture
engine/ensemble:     base results packing lattice fracture history reference
engine/scene:        base history theory packing lattice fracture ensemble
engine/calibration:  base theory packing lattice fracture ensemble scene
engine/simulation:   base history theory results packing lattice fracture ensemble scene calibration
engine/measurement:  base history theory results packing lattice fracture ensemble scene calibration simulation
engine/stability:    base results packing lattice fracture ensemble scene simulation measurement
engine/validation:   base theory results lattice fracture scene simulation
engine/experiment:   base history theory results packing lattice fracture ensemble scene calibration simulation measurement
engine/study:        base history results ensemble scene simulation
engine/claims:       base theory lattice fracture scene calibration study
engine/accuracy:     base scene study
viz:                 base results
viz/draw:            base results viz
studio/text:         base theory results scene simulation study
studio/charts:       base studio/text
studio/reports:      base history theory results packing lattice fracture ensemble scene calibration simulation measurement stability validation experiment study claims accuracy studio/text studio/charts
studio/screen:       base theory results fracture scene simulation studio/text
studio/workbench:    base history theory results scene simulation study studio/text studio/charts studio/reports studio/screen
studio/graphics:     base studio/screen
studio/slurm:        base scene
studio/view:         base results scene viz studio/screen studio/workbench
studio/terminal:     base studio/screen studio/workbench studio/graphics
studio/commands:     base theory results packing lattice ensemble scene calibration simulation measurement stability validation experiment study claims accuracy viz studio/text studio/charts studio/reports studio/screen studio/workbench studio/graphics studio/slurm studio/view studio/terminal
studio:              base results scene studio/commands
'

problems=$(
  find engine viz studio -name '*.[ch]pp' -o -name '*.inc' | LC_ALL=C sort |
    xargs grep -nE '^#include "(engine|viz|studio)/' |
    awk -F: -v table="$table" '
      BEGIN {
        lines = split(table, row, "\n")
        for (l = 1; l <= lines; ++l) {
          if (row[l] == "") continue
          split(row[l], part, ":")
          folder = part[1]
          n = split(part[2], known, " ")
          for (k = 1; k <= n; ++k) {
            name = known[k] ~ /\// || known[k] == "viz" ? known[k] : "engine/" known[k]
            if (!(name in listed)) print "the table: " folder " knows " name ", which does not stand above it"
            may[folder, name] = 1
          }
          listed[folder] = 1
        }
      }
      {
        from = $1; sub("/[^/]*$", "", from)
        to = $3; sub(/^#include "/, "", to); sub("/[^/]*$", "", to)
        if (!(from in listed)) print $1 ": its folder is not in the table"
        else if (from != to && !((from, to) in may)) print $1 ":" $2 ": " from " does not know " to ": " $3
      }' | LC_ALL=C sort -u
)
if [ -n "$problems" ]; then
  printf '%s\n' "$problems"
  wrong=1
fi

refuse() { # WHAT PATTERN FOLDERS...
  local what=$1 pattern=$2
  shift 2
  local found
  found=$(grep -rnE --include='*.cpp' --include='*.hpp' "$pattern" "$@" 2>/dev/null) || return 0
  printf '%s:\n%s\n' "$what" "$found"
  wrong=1
}
refuse 'VTK outside viz' '#include <vtk' engine studio
refuse 'ncurses outside studio/terminal' '#include <n?curses' engine viz studio/commands studio/text studio/charts studio/reports studio/screen studio/workbench studio/graphics studio/view
refuse 'CLI11 outside studio' '#include <CLI/' engine viz studio/screen studio/workbench
refuse 'libchafa outside studio/graphics' '#include <chafa' engine viz studio/commands studio/text studio/charts studio/reports studio/screen studio/workbench studio/view studio/terminal
# What may be written wherever a name is shown is written in one place, which knows how.
refuse 'a standard stream is written outside engine/base/console.cpp' '(fmt::print|std::(cerr|cout|clog|puts|printf)|fprintf|fputs|perror)\b' engine/[!b]* viz studio
refuse 'JSON becomes text outside engine/base/text.cpp' '\.dump\(' engine/[!b]* viz studio
exit $wrong
