#include "engine/base/console.hpp"
#include "engine/base/text.hpp"
#include "engine/scene/issue.hpp"
#include "engine/theory/references.hpp"
#include "engine/theory/wave_speeds.hpp"
#include "studio/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace rift::studio {
namespace {

struct TheoryOptions {
  double poisson = 0.3;
  std::string plane = "stress";
  std::vector<double> velocities;
  double from = 0.1, to = 1.0;
  int steps = 10;
  bool json = false, csv = false;
  std::string color;
};

/// The solid and the factors at one velocity, the row of every form of output.
struct TheoryRow {
  double v_over_cr = 0.0;
  theory::Factor broberg, freund, strip;
};
struct TheoryTable {
  double poisson = 0.0;
  std::string plane;
  double cr_over_cs = 0.0, cd_over_cs = 0.0;
  std::vector<TheoryRow> rows;
};

constexpr int most_steps = 1'000'000;

std::vector<scene::Issue> mistakes(const TheoryOptions& o) {
  std::vector<scene::Issue> found;
  const auto require = [&](bool holds, const std::string& option, double value, const std::string& text) {
    if (!holds)
      found.push_back(
          {.file = "rift theory", .key = option, .text = text, .value = fmt::format("{}", value)});
  };
  const std::string interval = "must lie in (0, 1], in units of c_R";
  if (o.plane == "strain") {
    require(o.poisson > -1.0 && o.poisson < 0.5, "--poisson", o.poisson,
            "must lie in (-1, 0.5) in plane strain (at 0.5 c_d is infinite)");
  } else {
    require(o.poisson > -1.0 && o.poisson <= 0.5, "--poisson", o.poisson, "must lie in (-1, 0.5]");
  }
  for (const double v : o.velocities) require(v > 0.0 && v <= 1.0, "--v", v, interval);
  require(o.from > 0.0 && o.from <= 1.0, "--from", o.from, interval);
  require(o.to > 0.0 && o.to <= 1.0, "--to", o.to, interval);
  if (o.from > 0.0 && o.to <= 1.0)
    require(o.from < o.to, "--from", o.from, fmt::format("must lie below --to = {}", o.to));
  require(o.steps >= 2 && o.steps <= most_steps, "--steps", o.steps,
          fmt::format("must lie in [2, {}]", most_steps));
  return found;
}

std::vector<double> velocities_of(const TheoryOptions& o) {
  if (!o.velocities.empty()) return o.velocities;
  std::vector<double> sweep;
  const int last = o.steps - 1;
  for (int i = 0; i <= last; ++i) sweep.push_back((o.from * (last - i) + o.to * i) / last);
  return sweep;
}

TheoryTable evaluate(const TheoryOptions& o) {
  const theory::Plane plane = o.plane == "strain" ? theory::Plane::strain : theory::Plane::stress;
  TheoryTable table{.poisson = o.poisson,
                    .plane = o.plane,
                    .cr_over_cs = theory::rayleigh_over_shear(o.poisson, plane),
                    .cd_over_cs = theory::dilatational_over_shear(o.poisson, plane),
                    .rows = {}};
  for (const double v : velocities_of(o))
    table.rows.push_back({.v_over_cr = v,
                          .broberg = theory::broberg(v, o.poisson, plane),
                          .freund = theory::freund(v, o.poisson, plane),
                          .strip = theory::strip(v, o.poisson, plane)});
  return table;
}

void print_json(const TheoryTable& t) {
  nlohmann::ordered_json factors = nlohmann::ordered_json::array();
  for (const TheoryRow& r : t.rows)
    factors.push_back({{"v_over_cr", r.v_over_cr},
                       {"broberg_k", r.broberg.k},
                       {"broberg_g", r.broberg.g},
                       {"freund_k", r.freund.k},
                       {"freund_g", r.freund.g},
                       {"strip_g", r.strip.g}});
  const nlohmann::ordered_json all = {{"poisson", t.poisson},
                                      {"plane", t.plane},
                                      {"cr_over_cs", t.cr_over_cs},
                                      {"cd_over_cs", t.cd_over_cs},
                                      {"factors", factors}};
  base::print_text(base::json_text(all, 2) + "\n");  // NaN, the strip at c_R, becomes null
}

void print_csv(const TheoryTable& t) {
  base::print(
      "poisson,plane,v_over_cr,cr_over_cs,cd_over_cs,broberg_k,broberg_g,freund_k,freund_g,strip_g\n");
  for (const TheoryRow& r : t.rows)
    base::print("{},{},{:.13g},{:.13g},{:.13g},{:.13g},{:.13g},{:.13g},{:.13g},{:.13g}\n", t.poisson, t.plane,
                r.v_over_cr, t.cr_over_cs, t.cd_over_cs, r.broberg.k, r.broberg.g, r.freund.k, r.freund.g,
                r.strip.g);
}

std::string cell(double factor) { return std::isnan(factor) ? "-" : fmt::format("{:#.12g}", factor); }

void print_table(const TheoryTable& t, bool color) {
  const auto row = [](const std::vector<std::string>& cells) {
    std::string line;
    for (const std::string& text : cells) line += fmt::format("{:<19}", text);
    return line.substr(0, line.find_last_not_of(' ') + 1);
  };
  base::print("Poisson's ratio {}, plane {}: c_R/c_s = {:.13g}, c_d/c_s = {:.13g}\n\n", t.poisson, t.plane,
              t.cr_over_cs, t.cd_over_cs);
  const std::string titles = row({"v/c_R", "Broberg k", "Broberg g", "Freund k", "Freund g", "strip g"});
  base::print_text(heading(titles, color) + "\n");
  for (const TheoryRow& r : t.rows)
    base::print("{}\n", row({fmt::format("{:.10g}", r.v_over_cr), cell(r.broberg.k), cell(r.broberg.g),
                             cell(r.freund.k), cell(r.freund.g), cell(r.strip.g)}));
  base::print("\n{}\n{}\n",
              "k = K/K_static, g = G_ID/G_I0. Broberg: a crack expanding from zero; Freund: a half-infinite",
              "crack; strip: a steady crack in a clamped strip, below c_R only.");
}

void theory_factors(const TheoryOptions& options) {
  const std::vector<scene::Issue> found = mistakes(options);
  if (!found.empty()) throw scene::InputError(found);
  const TheoryTable table = evaluate(options);
  if (options.json) {
    print_json(table);
  } else if (options.csv) {
    print_csv(table);
  } else {
    print_table(table, wants_color(options.color, stdout));
  }
}

void add_options(CLI::App& command, TheoryOptions& o) {
  command.add_option("--poisson", o.poisson, "Poisson's ratio, in (-1, 0.5]")->capture_default_str();
  command.add_option("--plane", o.plane, "Plane elasticity")
      ->type_name("PLANE")
      ->check(CLI::IsMember({"stress", "strain"}))
      ->capture_default_str();
  auto* v =
      command
          .add_option("--v", o.velocities, "Crack velocity in c_R, in (0, 1]; may be given more than once")
          ->allow_extra_args(false);
  command.add_option("--from", o.from, "First velocity of a sweep, in c_R")
      ->capture_default_str()
      ->excludes(v);
  command.add_option("--to", o.to, "Last velocity of the sweep")->capture_default_str()->excludes(v);
  command.add_option("--steps", o.steps, "Number of velocities in the sweep, both ends counted")
      ->capture_default_str()
      ->excludes(v);
  auto* json = command.add_flag("-j,--json", o.json, "One JSON object; undefined factors are null");
  command.add_flag("--csv", o.csv, "Comma-separated values; undefined factors are nan")->excludes(json);
  add_color_option(command, o.color);
}

}  // namespace

void add_theory(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("theory", "Rayleigh speed and the factors of Broberg, Freund and the strip");
  const auto options = std::make_shared<TheoryOptions>();
  add_options(command, *options);
  command.callback([options, &exit_code] {
    theory_factors(*options);
    exit_code = ExitCode::done;
  });
}

}  // namespace rift::studio
