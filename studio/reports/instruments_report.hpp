#pragma once

#include "engine/measurement/traces.hpp"
#include "studio/text/table.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// All that `rift measure` has to tell.
struct InstrumentsReport {
  std::string run, command, version;
  int lane = 0;
  measurement::Instruments seen;
  std::vector<measurement::SeenField> field;  // some, along the way
  std::vector<measurement::Trace> trace;      // of the run
  std::vector<measurement::Trace> measured;   // laid over
};

/// A dozen moments: stress intensities, and the books beside them.
Table intensity_table(const InstrumentsReport& report);

/// Table, and what the instruments and the measured curves come to.
std::string instruments_text(const InstrumentsReport& report, bool color);

nlohmann::ordered_json instruments_json(const InstrumentsReport& report);

/// Writes stress_intensity.csv, summary.json, charts/ and report.html. Throws WorldError where a chart cannot
/// be drawn; the rest is then written.
void write_instruments_report(const InstrumentsReport& report, const std::filesystem::path& folder);

/// field.csv: a row per moment and point of the grid that the camera holds.
std::string field_csv_header();
std::string field_csv_rows(const measurement::Grid& grid, const measurement::SeenField& field);

/// Mean over the moments that have both, weights alike; NaN where there are none.
struct FieldAgainstBooks {
  int moments = 0;
  double over_g_i0 = 0;  // G of the field over G_I0
  double taken = 0;      // G_ID of the books over G of the field
};
FieldAgainstBooks field_against_books(const InstrumentsReport& report);

}  // namespace rift::studio
