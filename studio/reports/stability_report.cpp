#include "studio/reports/stability_report.hpp"

#include "engine/base/csv.hpp"
#include "engine/base/text.hpp"
#include "studio/reports/report.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

std::string seen_text(const stability::Observed& seen) {
  if (seen.ending == stability::CaseEnd::diverges && seen.caught_within >= 0)
    return fmt::format("diverges, detected within {}", seen.caught_within);
  return stability::name_of(seen.ending);
}

/// What a row has to say beside its numbers, short enough for a table.
std::string remark(const stability::StabilityRow& row) {
  std::string said = row.in_double.said;
  if (const auto line_end = said.find('\n'); line_end != said.npos) said.resize(line_end);
  constexpr std::size_t most = 120;
  if (said.size() > most) said = said.substr(0, most - 3) + "...";
  return said;
}

/// What of a claim a reader wants: a number where one is expected, or the bounds.
std::string bounds_text(const stability::Claim& claim) {
  const double middle = 0.5 * (claim.low + claim.high), slack = 0.5 * (claim.high - claim.low);
  if (!std::isfinite(claim.high)) return fmt::format("at least {:.6g}", claim.low);
  if (slack == 0.0) return fmt::format("{:.6g}", middle);
  if (slack <= 0.05 * std::abs(middle) || middle == 0.0) return fmt::format("{:.6g} ± {:.1g}", middle, slack);
  return fmt::format("{:.6g} to {:.6g}", claim.low, claim.high);
}

/// A number that is all but another one is shown by what they differ in.
std::string seen_text(const stability::Claim& claim) {
  const double middle = 0.5 * (claim.low + claim.high), off = claim.seen - middle;
  const bool close = std::isfinite(middle) && std::abs(off) < 1e-5 * std::abs(middle);
  return (close && off != 0.0 ? fmt::format("{:.6g} {:+.0e}", middle, off)
                              : fmt::format("{:.6g}", claim.seen)) +
         (claim.holds() ? "" : " FAILS");
}

/// Each claim of a row with what was seen in either precision; a precision without it has none.
struct SeenClaim {
  const stability::Claim *in_double = nullptr, *in_single = nullptr;
  const stability::Claim& any() const { return in_double ? *in_double : *in_single; }
};

std::vector<SeenClaim> claims_of(const stability::StabilityRow& row) {
  std::vector<SeenClaim> all;
  for (const stability::Claim& claim : row.in_double.claims) all.push_back({&claim, nullptr});
  for (const stability::Claim& claim : row.in_single.claims) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const SeenClaim& other) {
      return other.in_double && !other.in_single && other.in_double->what == claim.what;
    });
    if (same == all.end())
      all.push_back({nullptr, &claim});
    else
      same->in_single = &claim;
  }
  return all;
}

/// How many of a row's claims hold.
std::string claims_text(const stability::StabilityRow& row) {
  std::size_t held = 0, all = 0;
  for (const stability::Observed* seen : {&row.in_double, &row.in_single})
    for (const stability::Claim& claim : seen->claims) ++all, held += claim.holds() ? 1 : 0;
  return all == 0 ? "" : fmt::format("{} of {}", held, all);
}

Json json_of(const stability::Observed& seen) {
  Json claims = Json::array();
  for (const stability::Claim& claim : seen.claims)
    claims.push_back({{"claim", claim.what},
                      {"low", claim.low},
                      {"high", claim.high},
                      {"seen", claim.seen},
                      {"holds", claim.holds()}});
  return {{"seen", stability::name_of(seen.ending)},
          {"ledger_residual", seen.residual},
          {"ledger_limit", seen.limit},
          {"growth", seen.growth},
          {"ratio", seen.ratio},
          {"steps", seen.steps},
          {"caught_within", seen.caught_within < 0 ? Json(nullptr) : Json(seen.caught_within)},
          {"said", seen.said},
          {"claims", claims},
          {"wall_s", seen.wall_s}};
}

std::string csv_of(const std::vector<stability::StabilityRow>& rows) {
  std::string csv =
      "family,case,expected,growth_expected,precision,seen,ledger_residual,ledger_limit,growth,ratio_with_"
      "damping,steps,caught_within,wall_s,said\n";
  for (const stability::StabilityRow& row : rows)
    for (const bool single : {false, true}) {
      const stability::Observed& s = single ? row.in_single : row.in_double;
      csv += base::csv_row(row.family, row.name, stability::name_of(row.expected), row.growth,
                           single ? "single" : "double", stability::name_of(s.ending), s.residual, s.limit,
                           s.growth, s.ratio, s.steps,
                           s.caught_within < 0 ? "" : std::to_string(s.caught_within), s.wall_s, s.said);
    }
  return csv;
}

std::string claims_csv(const std::vector<stability::StabilityRow>& rows) {
  std::string csv = "family,case,precision,claim,low,high,seen,holds\n";
  for (const stability::StabilityRow& row : rows)
    for (const bool single : {false, true})
      for (const stability::Claim& claim : (single ? row.in_single : row.in_double).claims)
        csv += base::csv_row(row.family, row.name, single ? "single" : "double", claim.what, claim.low,
                             claim.high, claim.seen, claim.holds() ? 1 : 0);
  return csv;
}

std::size_t as_expected(const std::vector<stability::StabilityRow>& rows) {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [](const stability::StabilityRow& row) { return row.as_expected; }));
}

std::string verdict(const StabilityReport& report) {
  return fmt::format("{} of {} cases are as expected, in both precisions; {}", as_expected(report.rows),
                     report.rows.size(), duration_text(report.wall_s));
}

/// A line per case: expected, seen in both precisions, the balance errors, growth, what was said.
Table stability_table(const std::vector<stability::StabilityRow>& rows) {
  Table table{{"case", "", "expected", "seen", "balance error, double", "single", "growth", "growth (theory)",
               "ratio", "single", "holds", "time [s]", ""},
              {}};
  std::string family;
  for (const stability::StabilityRow& row : rows) {
    const stability::Observed &a = row.in_double, &b = row.in_single;
    const std::string first = seen_text(a), second = seen_text(b);
    table.rows.push_back({row.family == family ? "" : row.family, row.name, stability::name_of(row.expected),
                          first == second ? first : first + " / " + second, number_cell(a.residual, "{:.0e}"),
                          number_cell(b.residual, "{:.0e}"), number_cell(a.growth, "{:.5f}"),
                          number_cell(row.growth, "{:.5f}"), number_cell(a.ratio, "{:.4f}"),
                          number_cell(b.ratio - a.ratio, "{:+.0e}"), claims_text(row),
                          number_cell(a.wall_s + b.wall_s, "{:.1f}"),
                          row.as_expected ? "" : "NOT AS EXPECTED"});
    family = row.family;
  }
  return table;
}

/// A line per claim: what physics expects of it, and what was seen in both precisions.
Table claims_table(const std::vector<stability::StabilityRow>& rows) {
  Table table{{"case", "", "quantity", "expected (± tolerance)", "double", "single"}, {}};
  for (const stability::StabilityRow& row : rows) {
    bool first = true;
    for (const SeenClaim& claim : claims_of(row)) {
      table.rows.push_back({first ? row.family : "", first ? row.name : "", claim.any().what,
                            bounds_text(claim.any()), claim.in_double ? seen_text(*claim.in_double) : "",
                            claim.in_single ? seen_text(*claim.in_single) : ""});
      first = false;
    }
  }
  return table;
}

}  // namespace

std::string stability_text(const StabilityReport& report, bool color) {
  std::string text = plain_table(stability_table(report.rows), color);
  if (const Table claims = claims_table(report.rows); !claims.rows.empty())
    text += "\n" + heading("Expected and observed quantities", color) + "\n" + plain_table(claims, color);
  std::string said;
  for (const stability::StabilityRow& row : report.rows)
    if (const std::string words = remark(row); !words.empty())
      said += fmt::format("  {}: {}\n    {}\n", row.family, row.name, words);
  if (!said.empty()) text += "\n" + heading("Messages", color) + "\n" + said;
  return text + "\n" + verdict(report) + "\n";
}

Json stability_json(const StabilityReport& report) {
  Json rows = Json::array();
  for (const stability::StabilityRow& row : report.rows)
    rows.push_back({{"family", row.family},
                    {"case", row.name},
                    {"expected", stability::name_of(row.expected)},
                    {"growth_expected", row.growth},
                    {"double", json_of(row.in_double)},
                    {"single", json_of(row.in_single)},
                    {"as_expected", row.as_expected}});
  return {{"cases", rows},
          {"as_expected", as_expected(report.rows)},
          {"of", report.rows.size()},
          {"wall_s", report.wall_s},
          {"version", report.build.version}};
}

namespace {

NamedChart growth_chart(const stability::GrowthCurve& curve) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < curve.step.size(); ++k)
    farthest = std::max(farthest, std::abs(curve.seen[k] - curve.expected[k]));
  return {"growth",
          fmt::format("A lattice of 75 elements released in its highest mode: growth of its amplitude per "
                      "step, fitted over all steps, and theory (largest difference {:.1e}). Up to the "
                      "critical step the mode does not grow. The guaranteed-stable step of the stiffest "
                      "element is {:.4f} of it; Lanczos iteration gives {:.6f}.",
                      farthest, curve.element_bound, curve.iterated),
          Chart{.title = "Stability limit of explicit integration",
                .x_label = "time step [2/ω_{max}]",
                .y_label = "growth of the highest mode [ln per step]",
                .series = {{.label = "theory, arcosh(2 x^2 - 1)", .x = curve.step, .y = curve.expected},
                           {.label = "measured",
                            .x = curve.step,
                            .y = curve.seen,
                            .style = ChartSeries::Style::points,
                            .colour = 1}},
                .marks = {{curve.element_bound, curve.element_bound, "element bound"},
                          {curve.iterated, curve.iterated, "Lanczos"}}}};
}

/// Case by case, in the order of the table; zero residuals cannot be drawn.
ChartSeries residuals(const std::vector<stability::StabilityRow>& rows, const char* label, int colour,
                      stability::Observed stability::StabilityRow::*seen) {
  ChartSeries series{.label = label, .style = ChartSeries::Style::points, .colour = colour};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const stability::Observed& s = rows[k].*seen;
    const bool kept = s.ending == stability::CaseEnd::closes || s.ending == stability::CaseEnd::open;
    if (kept && s.residual > 0.0 && std::isfinite(s.residual))
      series.add(static_cast<double>(k + 1), s.residual);
  }
  return series;
}

NamedChart residual_chart(const std::vector<stability::StabilityRow>& rows) {
  Chart chart{.title = "Balance error of stiff and extreme cases",
              .x_label = "case, in the order of the table",
              .y_label = "largest balance error [-]",
              .log_y = true,
              .series = {residuals(rows, "double", 0, &stability::StabilityRow::in_double),
                         residuals(rows, "single", 1, &stability::StabilityRow::in_single)}};
  std::erase_if(chart.series, [](const ChartSeries& s) { return s.x.empty(); });
  if (!chart.series.empty())
    for (const auto& [limit, label] : {std::pair{1e-10, "limit, double"}, std::pair{1e-3, "limit, single"}})
      chart.series.push_back(level(label, limit, 1.0, static_cast<double>(rows.size())));
  return {"residuals",
          "Balance error of each finished case, relative to the largest energy; the numbers are the rows of "
          "the table. With corotational beams it falls with the square of the step.",
          std::move(chart)};
}

std::vector<NamedChart> stability_charts(const StabilityReport& report) {
  std::vector<NamedChart> charts;
  if (report.growth) charts.push_back(growth_chart(*report.growth));
  charts.push_back(residual_chart(report.rows));
  return those_with_points(std::move(charts));
}

}  // namespace

void write_stability_report(const StabilityReport& report, const std::filesystem::path& folder) {
  Table said{{"case", "", "message"}, {}};
  for (const stability::StabilityRow& row : report.rows)
    if (!row.in_double.said.empty()) said.rows.push_back({row.family, row.name, row.in_double.said});
  write_report({.title = "Stiff and extreme cases: what each came to",
                .made = {report.command, report.build, report.wall_s},
                .opening = {verdict(report) + "."},
                .files = {{"summary.json", base::json_text(stability_json(report), 2) + "\n"},
                          {"table.csv", csv_of(report.rows)},
                          {"claims.csv", claims_csv(report.rows)}},
                .sections = {{"Charts", stability_charts(report)},
                             {"Cases", stability_table(report.rows)},
                             {"Expected and observed quantities", claims_table(report.rows)},
                             {"Messages", said}}},
               folder);
}

}  // namespace rift::studio
