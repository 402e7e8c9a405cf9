#include "studio/commands/run_ending.hpp"

#include "engine/base/console.hpp"
#include "engine/base/text.hpp"
#include "studio/text/run_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>

namespace rift::studio {
namespace {

std::string stage_name(results::Phase phase) {
  return phase == results::Phase::loading ? "loading"
         : phase == results::Phase::hold  ? "stabilising"
                                          : "crack";
}

}  // namespace

std::function<bool(const simulation::Progress&)> telling(ProgressLine& line, const StopSignal& stop,
                                                         std::size_t elements) {
  return [&line, &stop, elements](const simulation::Progress& p) {
    const double speed = static_cast<double>(p.step) * static_cast<double>(elements) / p.seconds;
    line.tell(stage_name(p.phase), static_cast<double>(p.step) / static_cast<double>(p.total),
              magnitude_text(speed) + " element-steps/s");
    return stop.received() == 0;
  };
}

void print_run(const nlohmann::ordered_json& summary, const std::filesystem::path& folder, bool json,
               bool color, const std::string& film) {
  if (json) {
    base::print_text(base::json_text(summary, 2) + "\n");
    return;
  }
  const auto lanes = results::lane_summaries_of(summary.at("scenarios"));
  for (const results::LaneSummary& lane : lanes) base::print_text(run_table(lane, color));
  base::print("  {:<22}{}/  summary.json, series.csv, run.vtkhdf (ParaView 5.12 or later)\n", "files",
              folder.string());
  if (!film.empty()) base::print("  {:<22}{}\n", "film", film);
  if (std::any_of(lanes.begin(), lanes.end(), [](const results::LaneSummary& lane) {
        return lane.outcome == simulation::name_of(simulation::Outcome::stopped);
      }))
    base::print("  {:<22}rift resume {}\n", "to go on", folder.string());
}

ExitCode stopped_by(const StopSignal& stop) {
  if (stop.received() == StopSignal::time_is_up) return ExitCode::budget_ran_out;
  return static_cast<ExitCode>(128 + (stop.received() != 0 ? stop.received() : SIGINT));
}

std::string nothing_kept_text(const std::string& what, const StopSignal& stop, const std::string& then) {
  return fmt::format("{}{}: {}", what,
                     stop.received() == StopSignal::time_is_up ? " as the budget ran out" : "", then);
}

ExitCode exit_code_of(simulation::Outcome outcome, const StopSignal& stop) {
  if (outcome == simulation::Outcome::diverged) return ExitCode::diverged;
  if (outcome == simulation::Outcome::stopped) return stopped_by(stop);
  return ExitCode::done;
}

}  // namespace rift::studio
