#include "engine/results/export.hpp"

#include "engine/base/files.hpp"
#include "engine/base/ownership.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/columns.hpp"
#include "engine/results/journal_scan.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/results/series.hpp"
#include "engine/results/vtp.hpp"

#include <fmt/format.h>

#include <set>
#include <string>

namespace rift::results {
namespace {

namespace fs = std::filesystem;

template <typename Columns>
std::string names(const Columns& columns) {
  std::string text;
  for (const auto& column : columns) text += fmt::format(",{}", column.name);
  return text + "\n";
}

template <typename Row, typename Columns>
std::string numbers(const Row& row, const Columns& columns) {
  std::string text;
  for (const auto& column : columns) text += "," + csv_number(row.*column.value);
  return text + "\n";
}

std::string events_csv(const JournalScan& scan) {
  std::string text = "beam,lane" + names(event_columns);
  for (const auto& event : scan.events)
    text += fmt::format("{},{}", event.beam, event.lane) + numbers(event, event_columns);
  return text;
}

std::string rate_csv(const JournalScan& scan) {
  std::string text = "lane,tip_m" + names(rate_columns);
  for (const auto& curve : scan.rates)
    for (const auto& point : curve.points)
      text += fmt::format("{},{}", curve.lane, csv_number(point.tip_m)) + numbers(point, rate_columns);
  return text;
}

std::string crack_csv(const JournalScan& scan) {
  std::string text = "step,time_s,lane,tip_m,velocity_m_s\n";
  for (const auto& sample : scan.samples) {
    if (sample.phase != Phase::fracture) continue;
    text += fmt::format("{},{},{},{},{}\n", sample.step, csv_number(sample.time_s), sample.lane,
                        csv_number(sample.tip_m), csv_number(sample.velocity_m_s));
  }
  return text;
}

}  // namespace

fs::path export_csv(const fs::path& run_folder) {
  const auto scan = scan_journal(run_folder / journal_name);
  base::OwnedFolder owned(run_folder / "csv");
  const fs::path& folder = owned.path();
  base::write_whole_file(folder / "series.csv", series_csv(scan.samples, scan.rates));
  base::write_whole_file(folder / "events.csv", events_csv(scan));
  base::write_whole_file(folder / "rate.csv", rate_csv(scan));
  base::write_whole_file(folder / "crack.csv", crack_csv(scan));
  return folder;
}

fs::path export_pvd(const fs::path& run_folder) {
  const auto journal = run_folder / journal_name;
  const base::HeldFile held(journal);
  const auto scan = scan_journal(journal);
  if (!scan.geometry) throw base::WorldError("export", journal, "it holds no geometry");
  base::OwnedFolder owned(run_folder / "pvd");
  const fs::path& folder = owned.path();

  std::string entries;
  std::set<std::string> written{"run.pvd"};
  int count = 0;
  const auto add = [&](double time_s, std::span<const Frame> frames) {
    const auto name = fmt::format("frame_{:06}.vtp", count++);
    write_vtp(folder / name, *scan.geometry, frames, scan.lanes);
    written.insert(name);
    entries +=
        fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time_s, name);
  };
  for_each_moment(journal, *scan.geometry,
                  [&](std::span<const Frame> frames) { add(frames.front().time_s, frames); });
  if (count == 0) add(0.0, {});
  check_same_run(held);

  const auto collection = folder / "run.pvd";
  base::write_whole_file(
      collection,
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n" +
          entries + "  </Collection>\n</VTKFile>\n");
  remove_other_exports(folder, "pvd", written);
  return collection;
}

fs::path export_vtkhdf(const fs::path& run_folder) {
  const RunState state = inspect_run(run_folder);
  if (state.condition == RunCondition::not_a_run) throw base::WorldError("export", run_folder, state.reason);
  if (state.condition == RunCondition::finished && state.has_archive) {
    if (const fs::path former = run_folder / "paraview";
        fs::exists(former))  // of the run before it had ended
      remove_other_exports(base::OwnedFolder(former).path(), "paraview", {});
    return run_folder / archive_name;
  }
  base::OwnedFolder owned(run_folder / "paraview");
  assemble_archive(run_folder, owned.path() / archive_name);
  return owned.path() / archive_name;
}

}  // namespace rift::results
