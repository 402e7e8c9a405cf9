#!/usr/bin/env bash
# The house has one direction: studio -> viz -> results, studio -> engine -> results; and one place for some things.
set -u
cd "$1" || exit 2
wrong=0
refuse() { # WHAT PATTERN FOLDERS...
  local what=$1 pattern=$2
  shift 2
  local found
  found=$(grep -rnE --include='*.cpp' --include='*.hpp' "$pattern" "$@" 2>/dev/null) || return 0
  printf '%s:\n%s\n' "$what" "$found"
  wrong=1
}
refuse 'engine reaches upwards' '#include "(viz|studio)/' engine
refuse 'base knows more than itself' '#include "(viz|studio|engine/(history|scene|lattice|mechanics|fracture|theory|measurement|ensemble|calibration|study|simulation|stability|experiment|results))/' engine/base
refuse 'results reaches into the engine' '#include "engine/(history|scene|lattice|mechanics|fracture|theory|measurement|ensemble|calibration|study|simulation|stability|experiment)/' engine/results
refuse 'viz knows more than results' '#include "(studio|engine/(history|scene|lattice|mechanics|fracture|theory|measurement|ensemble|calibration|study|simulation|stability|experiment))/' viz
refuse 'history knows more than itself' '#include "engine/(results|scene|lattice|mechanics|fracture|theory|measurement|ensemble|calibration|study|simulation|stability|experiment)/' engine/history
refuse 'measurement reaches upwards' '#include "engine/(results|scene|fracture|ensemble|calibration|study|simulation|stability|experiment)/' engine/measurement
refuse 'VTK outside viz' '#include <vtk' engine studio
refuse 'ncurses outside studio/terminal' '#include <n?curses' engine viz studio/commands studio/report studio/screen studio/workbench
refuse 'CLI11 outside studio' '#include <CLI/' engine viz studio/screen studio/workbench
refuse 'screens know what acts on them' '#include "studio/(workbench|terminal|commands)/' studio/screen
refuse 'the workbench knows a terminal' '#include "studio/(terminal|commands)/' studio/workbench
# What may be written wherever a name is shown is written in one place, which knows how.
refuse 'a standard stream is written outside engine/base/console.cpp' '(fmt::print|std::(cerr|cout|clog|puts|printf)|fprintf|fputs|perror)\b' engine/[!b]* viz studio
refuse 'JSON becomes text outside engine/base/json_text.cpp' '\.dump\(' engine/[!b]* viz studio
exit $wrong
