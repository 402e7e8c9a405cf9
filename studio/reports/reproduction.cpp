#include "studio/reports/reproduction.hpp"

#include "studio/reports/report.hpp"
#include "studio/text/html.hpp"
#include "studio/text/markdown.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

bool is_beyond(const Reproduction& r) {
  return std::all_of(r.claims.begin(), r.claims.end(), [](const auto& c) { return c.claim->beyond; });
}

const char* title_of(const Reproduction& r) {
  return is_beyond(r) ? "Beyond the paper" : "The paper's claims, judged";
}

constexpr const char* of_the_paper =
    " Every claim is judged with the paper's calibrated beams (bulk) and with beams scaled to the plate's "
    "own modulus (in-situ).";
constexpr const char* of_our_own =
    " These questions go beyond the paper; beams are scaled to the plate's own modulus (in-situ).";

/// How the numbers are to be read, and where they come from.
std::string preamble(const Reproduction& r) {
  return fmt::format(
      "Made by `{}`, rift {}, on {}, in {}: {} scenarios, {} computed now, {} reused. The plate has {} "
      "elements; "
      "\"ratio\" is G_ID/G_I0 with damping counted, the mean of {} specimens, and delta its difference to "
      "Broberg. What the words of a claim mean was fixed before any result (Margins).{} How far the verdicts "
      "rest on what the paper leaves open is shown by `rift reproduce readings`.",
      r.command, r.build.version, today_text(), duration_text(r.wall_s), r.scenarios, r.computed, r.found,
      r.elements, is_beyond(r) ? "the preset's" : "three", is_beyond(r) ? of_our_own : of_the_paper);
}

std::string time_text(const JudgedClaim& c) { return c.scenarios == 0 ? "-" : duration_text(c.wall_s); }

const char* unit_of(const JudgedClaim& c) {
  return c.claim->calibration ? "results of specimens" : "scenarios";
}

struct Line {
  std::string stiffness, verdict, measured;
};

/// What stands for the verdict of a picture.
std::string state_of(const JudgedClaim& c) { return c.pictures.empty() ? "not drawn" : "drawn"; }

/// "holds", "does not hold", "not decidable", or what stands for a verdict.
std::string verdict_text(const JudgedClaim& c, const claims::Judgement& judgement) {
  return c.claim->judge ? claims::name_of(judgement.verdict) : state_of(c);
}

/// One line per stiffness; one line alone of a picture, of cylinders, and beyond the paper.
std::vector<Line> lines_of(const JudgedClaim& c) {
  if (!c.claim->judge) return {{"", state_of(c), c.not_drawn.empty() ? c.claim->standing : c.not_drawn}};
  const Line in_situ{"in-situ", claims::name_of(c.in_situ.verdict), c.in_situ.measured};
  if (c.claim->beyond) return {in_situ};
  if (c.claim->calibration) return {{"bulk", claims::name_of(c.bulk.verdict), c.bulk.measured}};
  return {{"bulk", claims::name_of(c.bulk.verdict), c.bulk.measured}, in_situ};
}

std::vector<std::string> overview_row(const JudgedClaim& c) {
  return {c.claim->name,
          c.claim->artefact,
          c.claim->text,
          c.claim->beyond ? "-" : verdict_text(c, c.bulk),
          c.claim->calibration && c.claim->judge ? "-" : verdict_text(c, c.in_situ),
          time_text(c)};
}

const std::vector<std::string> overview_head{"name", "in the paper", "claim", "bulk", "in-situ", "time"};

std::string section_html(const JudgedClaim& c) {
  std::vector<std::vector<std::string>> rows;
  for (const Line& line : lines_of(c)) rows.push_back({line.stiffness, line.verdict, line.measured});
  std::string body = html_paragraph(c.claim->text);
  body += html_table({.head = {"stiffness", "verdict", "measured"}, .rows = rows});
  if (c.scenarios > 0)
    body += html_paragraph(fmt::format("{} {}, {} of computing.", c.scenarios, unit_of(c), time_text(c)));
  for (const Figure& figure : c.figures) body += html_figure(figure.chart.svg_text, figure.caption);
  for (const Picture& picture : c.pictures) body += html_picture(picture.png, picture.caption);
  return html_section(fmt::format("{} ({})", c.claim->artefact, c.claim->name), body);
}

std::string section_markdown(const JudgedClaim& c) {
  std::vector<std::vector<std::string>> rows;
  for (const Line& line : lines_of(c)) rows.push_back({line.stiffness, line.verdict, line.measured});
  std::string text = fmt::format("\n## {} ({})\n\n{}\n\n", c.claim->artefact, c.claim->name, c.claim->text);
  text += markdown_table({{"stiffness", "verdict", "measured"}, rows});
  if (c.scenarios > 0)
    text += fmt::format("\n{} {}, {} of computing.\n", c.scenarios, unit_of(c), time_text(c));
  for (const Figure& figure : c.figures)
    text += fmt::format("\n![{}](charts/{})\n", figure.caption, figure.chart.svg.filename().string());
  for (const Picture& picture : c.pictures)
    text += fmt::format("\n![{}](charts/{})\n", picture.caption, picture.png.filename().string());
  return text;
}

/// What all scenarios share, and what each of them leaves out.
std::string scenes_markdown(const std::vector<scene::Scene>& scenes) {
  const SharedParts shared = shared_parts(scenes);
  std::string text;
  if (!shared.parameters.empty()) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [key, value] : shared.parameters) rows.push_back({"`" + key + "`", value});
    text += "\n## Fixed parameters\n\nBy their keys in a preset; numbers are in SI units.\n\n" +
            markdown_table({{"key", "value"}, rows});
  }
  if (!shared.left_out.empty()) text += "\n## Left out\n\n";
  for (const std::string& line : shared.left_out) text += "- " + line + "\n";
  return text;
}

std::string colored(const std::string& verdict, bool color) {
  const std::string padded = fmt::format("{:<14}", verdict);
  if (!color) return padded;
  const char* code = verdict == "holds" || verdict == "drawn" ? "32"
                     : verdict == "does not hold"             ? "31"
                                                              : "33";
  return fmt::format("\x1b[{}m{}\x1b[0m", code, padded);
}

Json judgement_json(const claims::Judgement& j) {
  return {{"verdict", claims::name_of(j.verdict)}, {"measured", j.measured}};
}

}  // namespace

Table margins_table() {
  Table table{{"words", "mean", "from"}, {}};
  for (const claims::Margin& m : claims::margins()) table.rows.push_back({m.words, m.rule, m.source});
  return table;
}

std::string reproduction_html(const Reproduction& r) {
  std::vector<std::vector<std::string>> overview;
  for (const JudgedClaim& c : r.claims) overview.push_back(overview_row(c));
  std::string body = html_made({r.command, r.build, r.wall_s}) + html_paragraph(preamble(r));
  body += html_section("Verdicts", html_table({.head = overview_head, .rows = overview}));
  for (const JudgedClaim& c : r.claims) body += section_html(c);
  body += html_section("Margins", html_table(margins_table()));
  return html_page(title_of(r), body + html_scenes(r.scenes));
}

std::string reproduction_markdown(const Reproduction& r) {
  std::vector<std::vector<std::string>> overview;
  for (const JudgedClaim& c : r.claims) overview.push_back(overview_row(c));
  std::string text =
      fmt::format("# {}\n\n{}\n\n", title_of(r), preamble(r)) + markdown_table({overview_head, overview});
  for (const JudgedClaim& c : r.claims) text += section_markdown(c);
  text += "\n## Margins\n\n" + markdown_table(margins_table());
  return text + scenes_markdown(r.scenes);
}

std::string reproduction_text(const Reproduction& r, bool color) {
  std::string text;
  for (const JudgedClaim& c : r.claims) {
    text += heading(fmt::format("{:<14} {}", c.claim->name, c.claim->artefact), color);
    text += c.scenarios == 0 ? "\n" : fmt::format("  {} {}, {}\n", c.scenarios, unit_of(c), time_text(c));
    text += fmt::format("  {}\n", c.claim->text);
    for (const Line& line : lines_of(c))
      text += fmt::format("  {:<8} {} {}\n", line.stiffness, colored(line.verdict, color), line.measured);
  }
  return text;
}

Json reproduction_json(const Reproduction& r) {
  Json all = Json::array();
  for (const JudgedClaim& c : r.claims) {
    Json claim{{"name", c.claim->name}, {"artefact", c.claim->artefact}, {"claim", c.claim->text}};
    if (c.claim->judge) {
      if (!c.claim->beyond) claim["bulk"] = judgement_json(c.bulk);
      if (!c.claim->calibration) claim["in-situ"] = judgement_json(c.in_situ);
    } else {
      claim["drawn"] = Json::array();
      for (const Picture& picture : c.pictures) claim["drawn"].push_back(picture.png.string());
      if (!c.not_drawn.empty()) claim["not_drawn"] = c.not_drawn;
    }
    claim["scenarios"] = c.scenarios;
    claim["wall_s"] = c.wall_s;
    all.push_back(std::move(claim));
  }
  return {{"version", r.build.version}, {"command", r.command},   {"elements", r.elements},
          {"scenarios", r.scenarios},   {"computed", r.computed}, {"found", r.found},
          {"wall_s", r.wall_s},         {"claims", all}};
}

}  // namespace rift::studio
