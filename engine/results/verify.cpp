#include "engine/results/verify.hpp"

#include "engine/base/files.hpp"
#include "engine/base/ownership.hpp"
#include "engine/base/private_folder.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/archive_check.hpp"
#include "engine/results/checkpoint.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/series.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <system_error>

namespace rift::results {
namespace fs = std::filesystem;
namespace {

/// "run.vtkhdf" -> "run_damaged.vtkhdf", or with a number where that is taken.
fs::path name_aside(const fs::path& path) {
  for (int k = 1;; ++k) {
    fs::path aside =
        path.parent_path() / fmt::format("{}_damaged{}{}", path.stem().string(),
                                         k == 1 ? "" : std::to_string(k), path.extension().string());
    if (!fs::exists(aside)) return aside;
  }
}

void move_aside(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return;
  base::rename_file(path, name_aside(path));
}

constexpr const char* header_name = "scene/header";  // of the run, in the archive

class Verifier {
 public:
  Verifier(const fs::path& folder, bool mend) : folder_(folder) {
    result_.running = is_folder_being_written(folder);
    mend_ = mend && !result_.running;
    if (mend_ && fs::is_directory(folder)) lock_.emplace(folder);
  }

  Verification all() {
    leftovers();
    const bool has_journal = fs::exists(folder_ / journal_name);
    if (!has_journal && !fs::exists(folder_ / archive_name))
      throw base::WorldError(
          "verify", folder_,
          fmt::format("it holds neither {} nor {}: there is no run in it", journal_name, archive_name));
    result_.run = inspect_run(folder_);
    if (has_journal) journal();
    for (const char* name : {checkpoint_name, former_checkpoint_name}) checkpoint(name);
    archive();
    if (scan_ && scan_->geometry && !result_.running) tables();
    return std::move(result_);
  }

 private:
  void found(const std::string& file, Found what, std::string text) {
    result_.files.push_back({file, what, std::move(text)});
  }

  void leftovers() {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_, error)) {
      if (entry.path().extension() != ".part" || result_.running || !base::is_leftover(entry.path()))
        continue;
      if (mend_) fs::remove_all(entry.path(), error);
      found(entry.path().filename().string(), mend_ ? Found::removed : Found::damaged,
            "left by a killed process, not needed");
    }
    if (error) throw base::WorldError("read the folder", folder_, error.message());
  }

  void journal() {
    const RunState& run = result_.run;
    const fs::path path = folder_ / journal_name;
    const std::string holds =
        fmt::format("{} samples, {} frames, to step {}", run.samples, run.frames, run.last_step);
    switch (run.condition) {
      case RunCondition::finished:
        found(journal_name, Found::intact, holds);
        break;
      case RunCondition::unfinished:
        found(journal_name, Found::intact,
              result_.running ? holds + "; another process is writing it"
                              : fmt::format("{}; {}", holds, run.reason));
        break;
      case RunCondition::not_a_run:
        found(journal_name, Found::damaged, run.reason);
        return;
      case RunCondition::damaged:
        salvage(path);
        break;
    }
    scan_ = scan_journal(path);
  }

  void salvage(const fs::path& path) {
    const std::string reason = result_.run.reason;
    if (!mend_) return found(journal_name, Found::damaged, reason);
    base::PendingFile saved(path);
    fs::remove(saved.temporary());  // the salvaged journal is a new file
    const std::uint64_t lost = salvage_journal(path, saved.temporary());
    move_aside(path);
    saved.commit();
    const RunState now = inspect_run(folder_);
    found(journal_name, Found::damaged,
          fmt::format(
              "{}: {} bytes are lost; {} samples and {} frames were saved, and the damaged file is kept",
              reason, lost, now.samples, now.frames));
    damaged_at_ = result_.run.good_bytes;
  }

  void checkpoint(const char* name) {
    const fs::path path = folder_ / name;
    if (!fs::exists(path)) return;
    std::string why = checkpoint_damage(path);
    if (why.empty() && damaged_at_ && mend_) why = "the journal that it belongs to is damaged";
    const bool whole_journal = !result_.running && result_.run.condition != RunCondition::damaged;
    if (const std::uint64_t good = result_.run.good_bytes; why.empty() && whole_journal)
      if (const std::uint64_t needed = checkpoint_journal_bytes(path); needed > good)
        why = fmt::format("it needs {} bytes of the journal, which has {}: it belongs to another run", needed,
                          good);
    if (why.empty()) return found(name, Found::intact, "");
    found(name, Found::damaged, why);
    if (mend_) move_aside(path);
  }

  void archive() {
    const fs::path path = folder_ / archive_name;
    const bool can_be_made = scan_ && scan_->geometry;
    if (!fs::exists(path)) {
      const bool yet_to_come = result_.run.condition == RunCondition::unfinished;
      if (result_.running || (yet_to_come && !mend_)) return;
      if (!can_be_made || !mend_)
        return found(archive_name, Found::missing,
                     can_be_made ? "can be rebuilt from the journal"
                                 : "it cannot be rebuilt, because the journal holds no geometry");
      assemble_archive(folder_);
      return found(archive_name, Found::mended, "rebuilt from the journal");
    }
    const ArchiveCheck check = check_archive_in_child(path);
    std::string wrong = check.problems.empty() ? "" : check.problems.front();
    if (check.problems.size() > 1) wrong += fmt::format(", and {} more", check.problems.size() - 1);
    if (wrong.empty() && can_be_made) wrong = differs_from_journal(check);
    if (wrong.empty())
      return found(archive_name, Found::intact,
                   fmt::format("{} datasets, {} frames, {} elements (without rattlers), {} beams",
                               check.digest.size(), check.moments, check.elements, check.beams));
    if (!can_be_made || !mend_) return found(archive_name, Found::damaged, wrong);
    move_aside(path);
    assemble_archive(folder_);
    found(archive_name, Found::mended, wrong + ": rebuilt from the journal");
  }

  /// Where it does not hold what the journal gives; empty where it does.
  std::string differs_from_journal(const ArchiveCheck& check) const {
    const base::PrivateFolder folder("verify");
    const fs::path again = folder.path() / archive_name;
    assemble_archive(folder_, again);
    const ArchiveCheck expected = check_archive(again);
    const auto ours = expected.digest.find(header_name), its = check.digest.find(header_name);
    if (ours != expected.digest.end() && its != check.digest.end() && ours->second != its->second)
      return "it belongs to another run";
    if (damaged_at_) return "";  // it may hold what the journal has lost
    for (const auto& [name, digest] : expected.digest) {
      const auto there = check.digest.find(name);
      if (there == check.digest.end()) return name + " is missing";
      if (there->second != digest) return name + " differs from the journal";
    }
    return "";
  }

  void table(const char* name, const std::string& expected, bool same) {
    const fs::path path = folder_ / name;
    if (same) return found(name, Found::intact, "");
    const bool there = fs::exists(path);
    if (!mend_)
      return found(name, there ? Found::damaged : Found::missing,
                   there ? "differs from the journal: it belongs to another run or was changed"
                         : "can be rebuilt from the journal");
    move_aside(path);
    base::write_whole_file(path, expected);
    found(name, Found::mended,
          there ? "differed from the journal: rebuilt from it" : "rebuilt from the journal");
  }

  void tables() {
    const fs::path series = folder_ / series_name, summary = folder_ / summary_name;
    const std::string rows = series_csv(scan_->samples, scan_->rates);
    const std::string there_are = fs::exists(series) ? base::read_whole_file(series) : "";
    // A kill may have come between the journal and the table, which 'rift resume' rewrites.
    const bool behind =
        result_.run.condition == RunCondition::unfinished && !mend_ && rows.starts_with(there_are);
    table(series_name, rows, there_are == rows || behind);
    if (!scan_->summary_json) {
      if (!fs::exists(summary)) return;
      found(
          summary_name, mend_ ? Found::removed : Found::damaged,
          fmt::format("the journal has no end record, so this belongs to another run or to an earlier end{}",
                      mend_ ? ": moved aside" : ""));
      if (mend_) move_aside(summary);
      return;
    }
    if (!scan_->gauges.empty()) {
      const fs::path gauges = folder_ / gauges_name;
      const std::string readings = gauges_csv(scan_->gauges);
      table(gauges_name, readings, fs::exists(gauges) && base::read_whole_file(gauges) == readings);
    }
    const auto expected = json_or_discarded(*scan_->summary_json);
    if (expected.is_discarded())
      return found(summary_name, Found::damaged, "the journal's summary is not valid JSON");
    const auto there =
        fs::exists(summary) ? json_or_discarded(base::read_whole_file(summary)) : nlohmann::ordered_json();
    table(summary_name, base::json_text(expected, 2) + "\n", there == expected);
  }

  const fs::path& folder_;
  std::optional<base::FolderLock> lock_;  // while something may be mended
  bool mend_ = false;
  Verification result_;
  std::optional<JournalScan> scan_;
  std::optional<std::uint64_t> damaged_at_;
};

}  // namespace

const char* name_of(Found found) {
  switch (found) {
    case Found::intact:
      return "intact";
    case Found::missing:
      return "missing";
    case Found::mended:
      return "rebuilt";
    case Found::damaged:
      return "damaged";
    case Found::removed:
      return "removed";
  }
  return "";
}

bool is_whole(const Verification& verification) {
  return std::none_of(verification.files.begin(), verification.files.end(), [](const Finding& f) {
    return f.found == Found::damaged || f.found == Found::missing;
  });
}

Verification verify_run(const fs::path& folder, bool mend) { return Verifier(folder, mend).all(); }

}  // namespace rift::results
