#include "engine/measurement/traces.hpp"

#include "engine/base/numbers.hpp"
#include "engine/scene/csv_table.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/preset.hpp"
#include "engine/scene/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rift::measurement {
namespace {

struct GaugeQuantity {
  const char* name;
  scene::Dimension dimension;
  double results::GaugeRow::*value;
};
using Row = results::GaugeRow;
constexpr std::array gauge_quantities{GaugeQuantity{"strain_yy", scene::Dimension::strain, &Row::strain_yy},
                                      GaugeQuantity{"strain_xx", scene::Dimension::strain, &Row::strain_xx},
                                      GaugeQuantity{"strain_xy", scene::Dimension::strain, &Row::strain_xy},
                                      GaugeQuantity{"uy", scene::Dimension::length, &Row::uy_m},
                                      GaugeQuantity{"ux", scene::Dimension::length, &Row::ux_m},
                                      GaugeQuantity{"vy", scene::Dimension::speed, &Row::vy_m_s},
                                      GaugeQuantity{"vx", scene::Dimension::speed, &Row::vx_m_s}};

Trace grip_trace(const Instruments& seen) {
  Trace trace{"grip_force", scene::Dimension::force, {}, {}};
  for (const results::Sample& s : seen.samples)
    trace.time.push_back(s.time_s + seen.clock), trace.value.push_back(s.grip_force_n);
  return trace;
}

std::vector<Trace> gauge_traces(const Instruments& seen) {
  std::vector<Trace> traces;
  for (const results::GaugeRow& row : seen.gauges) {
    const auto first = static_cast<std::size_t>(row.gauge) * gauge_quantities.size();
    while (traces.size() < first + gauge_quantities.size()) {
      const GaugeQuantity& q = gauge_quantities[traces.size() % gauge_quantities.size()];
      traces.push_back(
          {fmt::format("gauge{}_{}", traces.size() / gauge_quantities.size(), q.name), q.dimension, {}, {}});
    }
    for (std::size_t k = 0; k < gauge_quantities.size(); ++k) {
      traces[first + k].time.push_back(row.time_s + seen.clock);
      traces[first + k].value.push_back(row.*gauge_quantities[k].value);
    }
  }
  return traces;
}

Trace intensity_trace(const Instruments& seen, const char* name, scene::Dimension dimension,
                      double StressIntensity::*value) {
  Trace trace{name, dimension, {}, {}};
  for (const IntensityPoint& p : seen.intensity)
    trace.time.push_back(p.time + seen.clock), trace.value.push_back(p.k ? (*p.k).*value : std::nan(""));
  return trace;
}

/// Straight between the points; NaN beyond them.
double value_at(const Trace& trace, double time) {
  if (trace.time.empty() || !(time >= trace.time.front() && time <= trace.time.back())) return std::nan("");
  if (time == trace.time.front()) return trace.value.front();
  const auto [k, part] = base::interval_at(trace.time, time);
  if (time == trace.time[k]) return trace.value[k];
  return trace.value[k - 1] + part * (trace.value[k] - trace.value[k - 1]);  // NaN of NaN, unlike std::lerp
}

constexpr std::size_t most_time_faults = 100;  // of one file

std::vector<std::string> names_of(const std::vector<Trace>& traces) {
  std::vector<std::string> names;
  for (const Trace& trace : traces) names.push_back(trace.name);
  return names;
}

/// "a, b, c, d and so on" of many names.
std::string first_of(std::vector<std::string> names) {
  constexpr std::size_t most = 4;
  const bool more = names.size() > most;
  if (more) names.resize(most);
  for (std::string& name : names) name = "'" + scene::printable(name, 30) + "'";
  if (more) names.emplace_back("more");
  return scene::listed(names, "and");
}

}  // namespace

std::vector<Trace> traces_of(const Instruments& seen) {
  std::vector<Trace> traces{grip_trace(seen)};
  for (Trace& trace : gauge_traces(seen)) traces.push_back(std::move(trace));
  traces.push_back(
      intensity_trace(seen, "k_i", scene::Dimension::stress_intensity, &StressIntensity::opening));
  traces.push_back(
      intensity_trace(seen, "k_ii", scene::Dimension::stress_intensity, &StressIntensity::sliding));
  traces.push_back(
      intensity_trace(seen, "g_field", scene::Dimension::release_rate, &StressIntensity::release_rate));
  return traces;
}

std::vector<Trace> read_traces(const std::filesystem::path& file, const std::vector<Trace>& known) {
  std::vector<scene::Issue> issues;
  const auto say = [&](int line, std::string text) {
    issues.push_back({file.string(), line, "", std::move(text)});
  };
  const scene::PresetFile content = scene::read_preset_file(file, scene::largest_csv);
  if (!content.problem.empty()) say(0, content.problem);
  if (content.text.size() > scene::largest_csv) say(0, "larger than 64 MiB: thin its rows out");
  std::vector<scene::CsvColumn> columns{{"time", scene::Dimension::time, scene::CsvNeed::needed, "t"}};
  for (const Trace& trace : known) columns.push_back({trace.name, trace.dimension, scene::CsvNeed::optional});
  const scene::CsvTable table = issues.empty() ? scene::read_csv(content.text, columns) : scene::CsvTable{};
  for (const scene::CsvProblem& problem : table.problems) say(problem.line, problem.text);
  for (const std::string& name : table.beside)
    if (name.starts_with("gauge")) say(0, fmt::format("the run has no '{}'", scene::printable(name, 40)));
  std::vector<Trace> read;
  if (issues.empty()) {
    const std::vector<double>& time = table.column[0];
    if (std::string trouble = time.empty() ? std::string() : scene::clock_trouble(time[0]);
        !trouble.empty()) {
      say(table.line[0], std::move(trouble));
      throw scene::InputError(issues);
    }
    for (std::size_t r = 1; r < time.size() && issues.size() < most_time_faults; ++r)
      if (!(time[r] > time[r - 1]))
        say(table.line[r], fmt::format("time does not grow: {} after {}",
                                       scene::quantity_text(time[r], scene::Dimension::time),
                                       scene::quantity_text(time[r - 1], scene::Dimension::time)));
    for (std::size_t k = 0; k < known.size(); ++k)
      if (!table.column[k + 1].empty())
        read.push_back({known[k].name, known[k].dimension, time, table.column[k + 1]});
    if (read.empty() && issues.empty())
      say(0, table.beside.empty() ? std::string("holds nothing to compare with")
                                  : fmt::format("holds nothing to compare with: it has {}, the run {}",
                                                first_of(table.beside), first_of(names_of(known))));
  }
  if (!issues.empty()) throw scene::InputError(issues);
  return read;
}

std::optional<TraceDistance> distance_between(const Trace& trace, const Trace& measured) {
  TraceDistance d;
  double low = INFINITY, high = -INFINITY, squares = 0.0;
  for (std::size_t k = 0; k < measured.time.size(); ++k) {
    const double off = value_at(trace, measured.time[k]) - measured.value[k];
    if (std::isnan(off)) continue;
    ++d.points;
    squares += off * off, d.largest = std::max(d.largest, std::abs(off));
    low = std::min(low, measured.value[k]), high = std::max(high, measured.value[k]);
  }
  if (d.points == 0) return std::nullopt;
  d.rms = std::sqrt(squares / d.points), d.span = high - low;
  return d;
}

}  // namespace rift::measurement
