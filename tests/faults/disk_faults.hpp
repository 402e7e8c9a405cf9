#pragma once

#include "tests/studio/run_rift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <map>
#include <string>
#include <vector>

/// What becomes of a command when one call of the system fails: the sweep that docs/reliability.md reports.
namespace rift::studio::faults {

namespace fs = std::filesystem;

/// A command under test, as shell text. `{}` stands for a folder, `rift` for the program.
struct Case {
  std::string name;
  std::string before;   // makes what the command needs, undisturbed
  std::string command;  // what is disturbed
  std::string again;    // goes on after it, or does it once more
  std::string check;    // looks at what is there; fails where it is not what was asked for
  std::vector<std::string>
      results;                // files that end with the same bytes however often the command is disturbed
  bool whole_at_once = true;  // each of them is there whole or not at all
};

struct Fault {
  const char* kind;
  int error;
  bool stays;
};

/// Each kind of call fails once; writing also from one call on for ever, as on a full disk.
inline const std::vector<Fault> all_faults{
    {"write", ENOSPC, false}, {"write", ENOSPC, true},  {"write", EDQUOT, true},   {"write", EIO, false},
    {"close", EDQUOT, false}, {"fsync", EIO, false},    {"rename", EACCES, false}, {"open", ENOSPC, false},
    {"open", EMFILE, true},   {"truncate", EIO, false}, {"mkdir", ENOSPC, false},  {"unlink", EACCES, false}};

/// How many disturbed commands came to what; all but the first two are faults of ours.
struct Counts {
  int said = 0;      // exit 1 and a plain sentence
  int unharmed = 0;  // exit 0 and the right results
  int wrong = 0, crashed = 0, hung = 0, other_code = 0, library_text = 0, half_a_file = 0, not_resumable = 0;
  std::vector<std::string> details;

  [[nodiscard]] int faults() const {
    return wrong + crashed + hung + other_code + library_text + half_a_file + not_resumable;
  }
  void add(const Counts& more) {
    said += more.said, unharmed += more.unharmed, wrong += more.wrong, crashed += more.crashed,
        hung += more.hung;
    other_code += more.other_code, library_text += more.library_text, half_a_file += more.half_a_file;
    not_resumable += more.not_resumable;
    details.insert(details.end(), more.details.begin(), more.details.end());
  }
};

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// Words that only libraries, exceptions and the insides of a program use.
inline bool is_library_text(const std::string& text) {
  for (const char* word : {"0x", "HDF5", "H5F", "H5D", "basic_", "filesystem error", "iostream", "ios_base",
                           "std::", "errno", "terminate called", "[json", "what():"})
    if (text.find(word) != std::string::npos) return true;
  return false;
}

/// The sweep over one command: an undisturbed reference, and a fresh copy of its folder for each fault.
class Sweep {
 public:
  explicit Sweep(Case tested) : case_(std::move(tested)) {
    fs::create_directories(base());
    fs::create_directories(folder_.path() / "cache");
    require(case_.before, base());
    copy_to(reference());
    require(case_.command, reference());
    require(case_.check, reference());
    for (const std::string& file : case_.results) expected_[file] = read_text(reference() / file);
  }

  /// How many calls of a kind the undisturbed command makes.
  int calls(const char* kind) {
    copy_to(work());
    const fs::path count = folder_.path() / "count";
    fs::remove(count);
    (void)run(case_.command, shim(kind) + " RIFT_FAULT_COUNT='" + count.string() + "'");
    return std::atoi(read_text(count).c_str());
  }

  Counts disturb(const Fault& fault, int call) {
    return outcome_of(fmt::format("{} {} {} errno {}{}", case_.name, fault.kind, call, fault.error,
                                  fault.stays ? " for ever" : ""),
                      shim(fault.kind) +
                          fmt::format(" RIFT_FAULT_CALL={} RIFT_FAULT_ERROR={}", call, fault.error) +
                          (fault.stays ? " RIFT_FAULT_STAYS=1" : ""));
  }

  /// The command may write files of at most so many blocks of 512 bytes (`ulimit -f`); its children too.
  Counts limit_files(int blocks) {
    return outcome_of(fmt::format("{} ulimit -f {}", case_.name, blocks), "",
                      fmt::format("ulimit -f {}; ", blocks));
  }

  /// The undisturbed command's time [s], as a user waits for it.
  double seconds() {
    copy_to(work());
    const auto start = std::chrono::steady_clock::now();
    (void)run(case_.command, "");
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  /// A signal reaches the command after so long: a killed one may leave anything that the next command can go
  /// on from; a stopped one ends by itself, as quickly as a batch system gives it time (10 s), or was done.
  Counts stop(const char* signal, double after_s) {
    copy_to(work());
    const std::string wrapper =
        fmt::format("timeout --preserve-status -k 10 -s {} {:.3f} rift ", signal, after_s);
    const bool killed = std::string(signal) == "KILL";
    const Ran ran = run(replaced(case_.command, "rift ", wrapper), "");
    Counts counts;
    const auto fault = [&](int Counts::*kind, const std::string& text) {
      ++(counts.*kind);
      counts.details.push_back(fmt::format("{} {} after {:.3f} s: {}: exit {}: {}", case_.name, signal,
                                           after_s, text, ran.exit_code, ran.err));
    };
    if (ran.exit_code == 0) {
      has_results() ? ++counts.unharmed : (fault(&Counts::wrong, "wrong results"), 0);
      return counts;
    }
    if (!killed && ran.exit_code == 137) {
      fault(&Counts::hung, "hung");
    } else if (ran.exit_code != (killed ? 137 : 143)) {
      fault(&Counts::crashed, "ended otherwise");
    } else if (has_half_a_file()) {
      fault(&Counts::half_a_file, "half a file");
    } else {
      ++counts.said;
    }
    const Ran again = run(case_.again, "");
    if (again.exit_code != 0 || !has_results())
      fault(&Counts::not_resumable, fmt::format("not resumable ({}: {})", again.exit_code, again.err));
    return counts;
  }

  /// The largest file that the command leaves [blocks of 512 bytes].
  int largest_file() const {
    std::uintmax_t largest = 0;
    for (const auto& entry : fs::recursive_directory_iterator(reference()))
      if (entry.is_regular_file()) largest = std::max(largest, entry.file_size());
    return static_cast<int>(largest / 512 + 1);
  }

 private:
  fs::path base() const { return folder_.path() / "base"; }
  fs::path reference() const { return folder_.path() / "reference"; }
  fs::path work() const { return folder_.path() / "work"; }

  void copy_to(const fs::path& target) const {
    fs::remove_all(target);
    fs::copy(base(), target, fs::copy_options::recursive);
  }
  std::string shim(const char* kind) const {
    return fmt::format(
        "LD_PRELOAD='{}' ASAN_OPTIONS=verify_asan_link_order=0 RIFT_FAULT_KIND={} RIFT_FAULT_UNDER='{}'",
        RIFT_DISK_SHIM, kind, work().string());
  }
  Ran run_in(const fs::path& where, const std::string& command, const std::string& environment,
             const std::string& limits = "") const {
    const std::string text =
        replaced(replaced(command, "{}", where.string()), "rift ", std::string(RIFT_EXE) + " ");
    write_text(folder_.path() / "command.sh", limits + text + "\n");
    return run_shell(
        fmt::format("env XDG_CACHE_HOME='{0}/cache' TMPDIR='{0}' {1} timeout -k 5 600 sh '{0}/command.sh'",
                    folder_.path().string(), environment));
  }
  Ran run(const std::string& command, const std::string& environment, const std::string& limits = "") const {
    return run_in(work(), command, environment, limits);
  }
  void require(const std::string& command, const fs::path& where) const {
    if (command.empty()) return;
    const Ran ran = run_in(where, command, "");
    if (ran.exit_code != 0) throw std::runtime_error(case_.name + ": " + command + ": " + ran.out + ran.err);
  }
  bool has_results() const {
    if (!case_.check.empty() && run(case_.check, "").exit_code != 0) return false;
    return std::all_of(expected_.begin(), expected_.end(), [&](const auto& file) {
      return fs::exists(work() / file.first) && read_text(work() / file.first) == file.second;
    });
  }
  bool has_half_a_file() const {
    if (!case_.whole_at_once) return false;
    return std::any_of(expected_.begin(), expected_.end(), [&](const auto& file) {
      return fs::exists(work() / file.first) && read_text(work() / file.first) != file.second;
    });
  }

  Counts outcome_of(const std::string& what, const std::string& environment, const std::string& limits = "") {
    copy_to(work());
    const Ran ran = run(case_.command, environment, limits);
    Counts counts;
    const auto fault = [&](int Counts::*kind, const std::string& text) {
      ++(counts.*kind);
      counts.details.push_back(fmt::format("{}: {}: exit {}: {}", what, text, ran.exit_code, ran.err));
    };
    if (ran.exit_code == 124 || ran.exit_code == 137) {
      fault(&Counts::hung, "hung");
    } else if (ran.exit_code > 128) {
      fault(&Counts::crashed, "crashed");
    } else if (ran.exit_code == 0) {
      has_results() ? ++counts.unharmed : (fault(&Counts::wrong, "wrong results"), 0);
    } else if (ran.exit_code != 1) {
      fault(&Counts::other_code, "another exit code");
    } else if (ran.err.empty() || is_library_text(ran.err)) {
      fault(&Counts::library_text, "no plain sentence");
    } else if (has_half_a_file()) {
      fault(&Counts::half_a_file, "half a file");
    } else {
      ++counts.said;
    }
    if (ran.exit_code == 0) return counts;
    const Ran again = run(case_.again, "");
    if (again.exit_code != 0 || !has_results())
      fault(&Counts::not_resumable, fmt::format("not resumable ({}: {})", again.exit_code, again.err));
    return counts;
  }

  TemporaryFolder folder_;
  Case case_;
  std::map<std::string, std::string> expected_;
};

/// The plate of all cases: 500 elements, 60 x 12 mm.
inline std::string plate(const std::string& more) {
  return "cat > {}/tiny.toml <<'END'\n[specimen]\nlength = \"60 mm\"\nheight = \"12 mm\"\nlayers = "
         "2\nelements = 500\n"
         "coordination = 5.5\n[loading]\ndisplacement = \"0.6 mm\"\n[output]\nsamples = 40\nframes = 4\n" +
         more + "END\n";
}
inline const std::string crack = "[crack]\nvelocity = \"0.5 c_r\"\nend = \"30 mm\"\n";
inline const std::string quiet_run = "rift run {}/tiny.toml --out {}/out --threads 1 --quiet";

/// What is left of a file that could not be written is no damage.
inline const std::string run_is_whole =
    "test -e {}/out/summary.json && test -e {}/out/run.vtkhdf && rift verify {}/out --check-only > {}/found; "
    "! grep -v '\\.part' {}/found | grep -E 'damaged|missing|rebuilt'";

inline Case run_case() {
  return {
      "run",
      plate(crack),
      quiet_run + " --checkpoint '1 us'",
      "if [ -e {}/out/journal.rift ]; then rift resume {}/out --quiet; else " + quiet_run + " --force; fi",
      run_is_whole,
      {"out/series.csv"},
      false};
}

/// A run that a signal has stopped after its first checkpoint, on a machine of any speed.
inline Case resume_case() {
  return {
      "resume",
      plate("[crack]\nvelocity = \"0.003 c_r\"\nend = \"30 mm\"\n") + quiet_run +
          " --checkpoint '1 us' >/dev/null 2>&1 & run=$!; while kill -0 $run 2>/dev/null; do "
          "if [ -e {}/out/checkpoint.h5 ]; then kill -TERM $run; break; fi; done; wait $run; "
          "test -e {}/out/checkpoint.h5",
      "rift resume {}/out --threads 1 --quiet",
      "if [ -e {}/out/journal.rift ]; then rift resume {}/out --quiet; else " + quiet_run + " --force; fi",
      run_is_whole,
      {"out/series.csv"},
      false};
}

inline Case export_case(const std::string& to, const std::vector<std::string>& results) {
  const std::string command = "rift export {}/out --to " + to;
  return {"export " + to, plate(crack) + quiet_run, command, command, "", results};
}

inline Case study_case() {
  const std::string command = "rift study {}/tiny.toml --out {}/study --threads 1 --quiet";
  return {
      "study",
      plate(crack + "[study]\ntechnique = [\"simple\", \"progressive\"]\nseed = [1, 2]\n"),
      command,
      command,
      "test -s {}/study/table.csv && test -s {}/study/report.html && cat {}/study/runs/*.csv > {}/all.csv",
      {"all.csv"},
      false};
}

inline Case measure_case() {
  const std::string command = "rift measure {}/out --inner 4 --grid 2 --quiet";
  return {"measure",
          plate(crack) + quiet_run,
          command,
          command,
          "test -s {}/out/measure/report.html",
          {"out/measure/field.csv", "out/measure/stress_intensity.csv"}};
}

inline Case experiment_case() {
  const std::string command =
      "rift experiment {}/tiny.toml --out {}/out --threads 1 --resamples 0 --specimens 1 --no-application "
      "--quiet";
  return {"experiment",
          plate("[crack]\nhistory = \"measured.csv\"\ndamage_zone_ratio = 2\ntoughness_window = 6\n") +
              "{ echo 'time [us];position [mm]'; for k in 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do "
              "echo \"$((2 * k));$((5 + 2 * k))\"; done; } > {}/measured.csv",
          command,
          command + " --force",
          // The first line of a law names the preset's folder.
          "test -s {}/out/report.html && "
          "grep -hv '^#' {}/out/toughness_velocity.csv {}/out/toughness_position.csv > {}/all.csv",
          {"all.csv"},
          false};
}

inline Case calibrate_case() {
  const std::string command =
      "rift calibrate --young '3.2 GPa' --poisson 0.25 --out {}/out --quiet --set calibration.elements=300 "
      "--set calibration.packings=2 --set 'calibration.radius_ratios=[0.2, 0.4, 0.8]' "
      "--set 'calibration.sizes=[200, 300]'";
  return {"calibrate",          "", command, command + " --force", "test -s {}/out/report.html",
          {"out/material.toml"}};
}

inline Case pack_case() {
  const std::string command = "rift pack {}/tiny.toml --out {}/out --quiet";
  return {"pack",
          plate(crack),
          command,
          command + " --force",
          "test -s {}/out/report.html",
          {"out/elements.csv"}};
}

inline Case render_case() {
  const std::string command =
      "rift render {}/out --size 320x180 --film {}/film.gif --at 0.5 --picture {}/a.png --quiet";
  return {"render", plate(crack) + quiet_run, command, command + " --force", "", {"film.gif", "a.png"}};
}

/// A run whose archive and table are damaged, to be repaired.
inline Case verify_case() {
  return {"verify",
          plate(crack) + quiet_run + " && truncate -s 5000 {}/out/run.vtkhdf && rm {}/out/series.csv",
          "rift verify {}/out",
          "rift verify {}/out",
          run_is_whole,
          {"out/series.csv"}};
}

inline std::vector<Case> all_cases() {
  return {run_case(),
          resume_case(),
          study_case(),
          measure_case(),
          experiment_case(),
          calibrate_case(),
          export_case("csv",
                      {"out/csv/series.csv", "out/csv/events.csv", "out/csv/rate.csv", "out/csv/crack.csv"}),
          export_case("pvd", {"out/pvd/run.pvd", "out/pvd/frame_000000.vtp", "out/pvd/frame_000003.vtp"}),
          export_case("ovito", {"out/ovito/run.dump", "out/ovito/beams.dump"}),
          render_case(),
          verify_case(),
          pack_case()};
}

}  // namespace rift::studio::faults
