#include "studio/reports/readings.hpp"

#include "engine/base/numbers.hpp"
#include "studio/reports/report.hpp"
#include "studio/reports/reproduction.hpp"
#include "studio/text/html.hpp"
#include "studio/text/markdown.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

using claims::Beams;
using Json = nlohmann::ordered_json;

constexpr Beams all_beams[] = {Beams::in_situ, Beams::bulk, Beams::matched};
constexpr const char* readings_title = "What the verdicts rest on: all readings, all claims";

/// Of a cell of the matrix.
const char* short_of(claims::Verdict verdict) {
  switch (verdict) {
    case claims::Verdict::holds:
      return "yes";
    case claims::Verdict::does_not_hold:
      return "no";
    case claims::Verdict::not_decidable:
      break;
  }
  return "?";
}

std::vector<std::string> cells_of(const claims::Reading& r) {
  return {claims::name_of(r.beams), r.kinematics, claims::name_of(r.kinetic), claims::name_of(r.window),
          claims::title_of(r)};
}

const std::vector<std::string> reading_head{"beams", "kinematics", "kinetic energy", "window", "reading of"};

Table matrix(const ReadingsReport& report) {
  Table table{reading_head, {}};
  for (const claims::Claim* claim : report.claims) table.head.push_back(claim->name);
  for (const ReadingRow& row : report.rows) {
    table.rows.push_back(cells_of(row.reading));
    for (const claims::Judgement& j : row.judgement) table.rows.back().emplace_back(short_of(j.verdict));
  }
  return table;
}

Table ratios(const ReadingsReport& report) {
  Table table{reading_head, {}};
  for (const char* technique : {"P-NRT", "S-NRT"})
    for (const double v : ReadingsReport::shown) table.head.push_back(fmt::format("{} {:g}", technique, v));
  for (const ReadingRow& row : report.rows) {
    table.rows.push_back(cells_of(row.reading));
    for (const std::vector<double>* curve : {&row.progressive, &row.simple})
      for (const double ratio : *curve)
        table.rows.back().push_back(std::isnan(ratio) ? "-" : fmt::format("{:.3f}", ratio));
  }
  return table;
}

Table verdicts(const ReadingsReport& report) {
  Table table{{"name", "claim"}, {}};
  for (const Beams beams : all_beams) table.head.emplace_back(claims::name_of(beams));
  for (std::size_t k = 0; k < report.claims.size(); ++k) {
    table.rows.push_back({report.claims[k]->name, report.claims[k]->text});
    for (const Beams beams : all_beams)
      table.rows.back().push_back(
          claims::verdict_of_both(report.row_of(claims::project_reading(beams)).judgement[k],
                                  report.row_of(claims::letter_of_paper(beams)).judgement[k]));
  }
  return table;
}

/// What was measured for each part of the claims, by the project's reading and by the letter.
Table measured(const ReadingsReport& report) {
  Table table{{"name", "beams", "reading of", "verdict", "measured"}, {}};
  for (std::size_t k = 0; k < report.claims.size(); ++k)
    for (const Beams beams : all_beams)
      for (const claims::Reading& reading :
           {claims::project_reading(beams), claims::letter_of_paper(beams)}) {
        const claims::Judgement& j = report.row_of(reading).judgement[k];
        table.rows.push_back({report.claims[k]->name, claims::name_of(beams), claims::title_of(reading),
                              claims::name_of(j.verdict), j.measured});
      }
  return table;
}

std::vector<BalanceRow> balances_of(const std::vector<claims::SummaryRow>& rows) {
  std::vector<BalanceRow> balances;
  for (const claims::SummaryRow& row : rows) {
    auto at = std::find_if(balances.begin(), balances.end(), [&](const BalanceRow& b) {
      return b.technique == row.technique && b.kinematics == row.kinematics;
    });
    if (at == balances.end())
      at = balances.insert(
          at, {.technique = row.technique, .kinematics = row.kinematics, .limit = row.ledger_limit});
    ++at->scenarios, at->open += !row.ledger_closes;
    at->worst = std::max(at->worst, row.ledger_residual), at->limit = std::min(at->limit, row.ledger_limit);
  }
  return balances;
}

Table balances(const ReadingsReport& r) {
  Table table{{"technique", "kinematics", "scenarios", "beyond the limit", "largest error", "limit"}, {}};
  for (const BalanceRow& b : r.balances)
    table.rows.push_back({b.technique, b.kinematics, fmt::format("{}", b.scenarios),
                          fmt::format("{}", b.open), fmt::format("{:.1e}", b.worst),
                          fmt::format("{:.0e}", b.limit)});
  return table;
}

std::string preamble(const ReadingsReport& r) {
  return fmt::format(
      "Made by `{}`, rift {}, in {}: {} scenarios, {} computed now, {} reused; {} elements, three specimens "
      "(at "
      "0.01 c_R one). A reading is what the paper leaves open: which kinetic energy the balance counts (all, "
      "or "
      "of translation as in its eq. 7), how beams turn, where the ratio is read, how stiff the beams are. No "
      "verdict is picked from this table: two readings were fixed beforehand, the project's (all kinetic "
      "energy, "
      "linear beams, the presets' window) and the paper's letter (translation, corotational beams, the "
      "windows "
      "that its text names). \"Bulk, matched\" is bulk beams in a packing of coordination {:.2f}, found by "
      "calibration: at it the plate's strip modulus is {:.2f} GPa, that of the material {:.2f} GPa.",
      r.command, r.build.version, duration_text(r.wall_s), r.scenarios, r.computed, r.found, r.elements,
      r.matched.coordination, 1e-9 * r.matched.strip_modulus, 1e-9 * r.matched.wanted);
}

constexpr const char* of_windows =
    "Windows: default 0.2-0.4 L, above 0.8 c_R 0.4-0.6 L; text 0.1-0.2 L for P-NRT (\"between 10 % and 20 "
    "%\"), "
    "0.2-0.3 L for S-NRT (\"after an advance of 20 %\"), 0.4-0.5 L above 0.8 c_R (\"about 40 %\"); early "
    "0.1-0.2 "
    "L (\"the early stage\"). yes: holds, no: does not hold, ?: not decidable.";

std::vector<double> ratios_of(const claims::Evidence& evidence, const claims::Selection& selection) {
  const claims::Curve curve = claims::curve_in(evidence, selection);
  std::vector<double> ratios;
  for (const double v : ReadingsReport::shown) {
    const claims::Curve at = claims::within(curve, v, v);
    ratios.push_back(at.empty() ? NAN : base::mean_of(at.front().ratio));
  }
  return ratios;
}

struct Section {
  const char* title;
  Table table;
  const char* note;
};

std::vector<Section> sections_of(const ReadingsReport& r) {
  return {
      {"Verdicts", verdicts(r), ""},
      {"Readings and claims", matrix(r), of_windows},
      {"Ratios", ratios(r), "G_ID/G_I0 at velocities over c_R: P-NRT (linear, r_l = 1) and S-NRT, undamped."},
      {"Energy balances", balances(r),
       "Errors relative to the largest energy. A ratio is uncertain by the error over the share of the "
       "energy "
       "that its window releases; rows beyond the limit are in the tables above all the same."},
      {"Margins", margins_table(), "Fixed before any result was seen."},
      {"Measured", measured(r), ""}};
}

}  // namespace

const ReadingRow& ReadingsReport::row_of(const claims::Reading& reading) const {
  return *std::find_if(rows.begin(), rows.end(), [&](const ReadingRow& r) { return r.reading == reading; });
}

void judge_readings(ReadingsReport& report, const claims::Evidence& evidence) {
  report.rows.clear();
  report.balances = balances_of(evidence.rows);
  for (const claims::Reading& reading : claims::all_readings()) {
    const claims::Evidence seen = claims::evidence_under(evidence, reading, report.matched.coordination);
    ReadingRow row{.reading = reading, .judgement = {}, .progressive = {}, .simple = {}};
    for (const claims::Claim* claim : report.claims) row.judgement.push_back(claim->judge(seen));
    row.progressive = ratios_of(seen, {}), row.simple = ratios_of(seen, claims::simple_release());
    report.rows.push_back(std::move(row));
  }
}

std::string readings_markdown(const ReadingsReport& r) {
  std::string text = fmt::format("# {}\n\n{}\n", readings_title, preamble(r));
  for (const Section& s : sections_of(r)) {
    text += fmt::format("\n## {}\n\n", s.title);
    if (*s.note) text += fmt::format("{}\n\n", s.note);
    text += markdown_table(s.table);
  }
  return text;
}

std::string readings_html(const ReadingsReport& r) {
  std::string body = html_made({r.command, r.build, r.wall_s}) + html_paragraph(preamble(r));
  for (const Section& s : sections_of(r))
    body += html_section(s.title, (*s.note ? html_paragraph(s.note) : std::string{}) + html_table(s.table));
  return html_page(readings_title, body);
}

std::string readings_text(const ReadingsReport& r, bool color) {
  std::string text = heading(readings_title, color) + "\n" + plain_table(matrix(r), color) + "\n";
  for (const auto& row : verdicts(r).rows) {
    text += heading(row[0], color) + "\n";
    for (std::size_t k = 0; k < std::size(all_beams); ++k)
      text += label_line(claims::name_of(all_beams[k]), row[2 + k], 16);
  }
  return text;
}

Json readings_json(const ReadingsReport& r) {
  Json rows = Json::array();
  for (const ReadingRow& row : r.rows) {
    Json one{{"beams", claims::name_of(row.reading.beams)},
             {"kinematics", row.reading.kinematics},
             {"kinetic_energy", claims::name_of(row.reading.kinetic)},
             {"window", claims::name_of(row.reading.window)},
             {"reading_of", claims::title_of(row.reading)},
             {"progressive", row.progressive},
             {"simple", row.simple}};
    for (std::size_t k = 0; k < r.claims.size(); ++k)
      one["claims"][r.claims[k]->name] = {{"verdict", claims::name_of(row.judgement[k].verdict)},
                                          {"measured", row.judgement[k].measured}};
    rows.push_back(std::move(one));
  }
  Json energy_balances = Json::array();
  for (const BalanceRow& b : r.balances)
    energy_balances.push_back({{"technique", b.technique},
                               {"kinematics", b.kinematics},
                               {"scenarios", b.scenarios},
                               {"beyond_limit", b.open},
                               {"largest_error", b.worst},
                               {"limit", b.limit}});
  return {{"version", r.build.version},
          {"command", r.command},
          {"elements", r.elements},
          {"scenarios", r.scenarios},
          {"computed", r.computed},
          {"found", r.found},
          {"wall_s", r.wall_s},
          {"matched_coordination", r.matched.coordination},
          {"matched_strip_modulus_pa", r.matched.strip_modulus},
          {"velocities_over_cr", ReadingsReport::shown},
          {"energy_balances", energy_balances},
          {"readings", rows}};
}

}  // namespace rift::studio
