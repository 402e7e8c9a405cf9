#include "engine/results/run_writer.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/json_input.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <utility>

namespace rift::results {

RunWriter::RunWriter(std::filesystem::path folder, const nlohmann::ordered_json& header,
                     const Geometry& geometry, const Mechanics& mechanics)
    : folder_(std::move(folder)),
      journal_(folder_ / journal_name),
      held_(folder_ / journal_name),
      series_(folder_ / series_name) {
  journal_.write(RunHeader{base::json_text(header, -1)});
  journal_.write(geometry);
  if (!mechanics.centre.empty()) journal_.write(mechanics);
  journal_.flush();
}

namespace {

/// Removes the files of a run's end, and those that are written again.
const std::filesystem::path& without_end(const std::filesystem::path& folder) {
  for (const char* name : {archive_name, summary_name, series_name, gauges_name})
    base::remove_file(folder / name);
  return folder;
}

}  // namespace

RunWriter::RunWriter(std::filesystem::path folder, std::uint64_t journal_bytes)
    : folder_(std::move(folder)),
      journal_(folder_ / journal_name, journal_bytes),
      held_(folder_ / journal_name),
      series_(without_end(folder_) / series_name) {
  for (const Sample& sample : scan_journal(folder_ / journal_name).samples) series_.write(sample);
}

std::uint64_t RunWriter::journal_bytes() const { return held_.size(); }

void RunWriter::check_still_ours() const {
  if (held_.is_still_there()) return;
  throw base::WorldError(
      "continue the run in", folder_,
      fmt::format("its {} was removed or replaced by another process; nothing more is written",
                  journal_name));
}

void RunWriter::sample(const Sample& sample) {
  journal_.write(sample);
  series_.write(sample);
}

void RunWriter::frame(const Frame& frame) { journal_.write(frame); }

void RunWriter::event(const ReleaseEvent& event) { journal_.write(event); }

void RunWriter::gauge(const GaugeRow& row) { journal_.write(row); }

void RunWriter::flush() {
  journal_.flush();
  series_.flush();
  check_still_ours();
}

void RunWriter::finish(const nlohmann::ordered_json& summary,
                       const std::vector<std::vector<RatePoint>>& rate_per_lane) {
  for (std::size_t lane = 0; lane < rate_per_lane.size(); ++lane)
    journal_.write(RateCurve{static_cast<std::int32_t>(lane), rate_per_lane[lane]});
  journal_.write(RunEnd{base::json_text(summary, -1)});
  journal_.close();
  series_.close();

  check_still_ours();
  complete_folder(folder_, [this] { check_still_ours(); });
}

void complete_folder(const std::filesystem::path& folder, const std::function<void()>& check) {
  const auto scan = scan_journal(folder / journal_name);
  if (!scan.summary_json) throw base::WorldError("complete", folder, "its journal holds no end of the run");
  if (check) check();
  base::write_whole_file(folder / series_name, series_csv(scan.samples, scan.rates));
  if (!scan.gauges.empty()) base::write_whole_file(folder / gauges_name, gauges_csv(scan.gauges));
  assemble_archive(folder);
  if (check) check();
  const auto summary = read_json(*scan.summary_json, folder / journal_name);
  base::write_whole_file(folder / summary_name, base::json_text(summary, 2) + "\n");
}

}  // namespace rift::results
