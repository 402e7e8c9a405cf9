#include "engine/experiment/kept_parts.hpp"

#include "engine/base/files.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/text.hpp"
#include "engine/ensemble/instruction_set.hpp"
#include "engine/experiment/experiment.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/text_differences.hpp"
#include "engine/simulation/record.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <system_error>

namespace rift::experiment {
namespace {

namespace fs = std::filesystem;

fs::path mark_file(const fs::path& folder) { return folder / "experiment.json"; }
fs::path parts_folder(const fs::path& folder) { return folder / "parts"; }

}  // namespace

std::string experiment_identity(const scene::Preset& preset, const ExperimentOptions& options,
                                const simulation::BuildInfo& build) {
  return fmt::format("{}\nresamples {}\nspecimens {}\nversion {}\ninstruction set {}\n",
                     scene::preset_text(preset), options.resamples, options.specimens, build.version,
                     ensemble::name_of(ensemble::instruction_set()));
}

bool is_under_way(const fs::path& folder, const std::string& identity) {
  if (!fs::exists(mark_file(folder))) return false;
  const auto mark = results::json_or_discarded(base::read_whole_file(mark_file(folder)));
  return mark.is_object() && mark.contains("identity") && mark["identity"] == identity;
}

std::vector<std::string> differences_from(const fs::path& folder, const std::string& identity) {
  if (!fs::exists(mark_file(folder))) return {};
  const auto mark = results::json_or_discarded(base::read_whole_file(mark_file(folder)));
  if (!mark.is_object() || !mark.contains("identity") || !mark["identity"].is_string()) return {};
  return scene::text_differences(mark["identity"].get<std::string>(), identity);
}

void begin_experiment(const fs::path& folder, const std::string& identity) {
  if (is_under_way(folder, identity)) return;
  forget_parts(folder);
  results::create_run_folder(folder / "run",
                             true);  // before the mark: a run beside a mark is of its experiment
  base::write_whole_file(mark_file(folder),
                         base::json_text(nlohmann::json{{"identity", identity}}, 2) + "\n");
}

bool holds_parts(const fs::path& folder) {
  std::error_code none;
  return fs::exists(folder / "run" / results::journal_name, none) || fs::exists(parts_folder(folder), none);
}

void forget_parts(const fs::path& folder) {
  std::error_code none;
  fs::remove(mark_file(folder), none);
  fs::remove_all(parts_folder(folder), none);
}

simulation::RunResult Parts::march(const std::string& name, const simulation::Prepared& prepared,
                                   const std::function<bool(double done)>& progress) const {
  simulation::MarchKeeping keeping{.folder = parts_folder(folder_) / name, .identity = identity_ + name};
  std::string ignored;  // what is damaged is computed again
  const std::optional<simulation::Resumption> from = simulation::kept_march(keeping, ignored);
  const simulation::Observer observer{.go_on = [&](const simulation::Progress& p) {
    return progress(static_cast<double>(p.step) / static_cast<double>(p.total));
  }};
  simulation::RunResult run =
      simulation::march_and_keep(prepared, observer, options_, keeping, from ? &*from : nullptr, ignored);
  if (run.outcome == simulation::Outcome::stopped) throw base::Interrupted("marching the " + name);
  return run;
}

}  // namespace rift::experiment
