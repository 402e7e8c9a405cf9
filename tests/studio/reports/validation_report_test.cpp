#include "studio/reports/validation_report.hpp"

#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rift::studio {
namespace {

/// One branching and one wave-loaded problem with a crack each, which runs straight.
ValidationReport small_report() {
  ValidationReport report;
  for (const validation::Problem& problem : validation::problems()) {
    if (problem.name == "bobaru_branching") continue;
    ValidatedSize size{.elements = problem.elements, .scene = {}, .cracks = {}, .findings = {}};
    size.scene =
        scene::read_preset(std::filesystem::path(RIFT_SOURCE_DIR) / "presets" / (problem.name + ".toml"), {})
            .scene;
    validation::FreeCrack crack;
    crack.realisation = {21, problem.mirrored, problem.elements};
    crack.length = size.scene.specimen.length, crack.height = size.scene.specimen.height;
    crack.thickness = 2e-3, crack.notch = size.scene.crack.start, crack.mean_radius = 0.4e-3;
    crack.young_modulus = 32e9, crack.poisson_ratio = 0.2, crack.strength = 3.3e6, crack.kappa = 0.71;
    for (int k = 0; k < 400; ++k)
      crack.gone.push_back({1.6e-5 + 1e-7 * k, {crack.notch + 1e-4 * k, 0.5 * crack.height}});
    crack.fracture = {{0.0, 0.0}, {6e-5, 2.4e-4}};
    size.cracks.push_back(crack);
    size.findings = validation::judge(problem, size.scene, size.cracks);
    report.problems.push_back({&problem, {size}});
  }
  return report;
}

TEST(ValidationReport, HasEachRuleItsVerdictAndCharts) {
  const ValidationReport report = small_report();
  const std::string text = validation_text(report, false);
  for (const ValidatedProblem& problem : report.problems)
    for (const validation::Finding& finding : problem.sizes.front().findings)
      for (const std::string& part : {finding.rule, finding.measured, std::string(name_of(finding.verdict))})
        EXPECT_TRUE(contains(text, part)) << part;
  const TemporaryFolder folder;
  write_validation_report(report, folder.path());
  const std::string page = read_text(folder / "report.html");
  for (const char* part : {"Freund", "Borden", "does not hold", "R = 0.40 mm"})
    EXPECT_TRUE(contains(page, part)) << part;
  for (const char* chart : {"freund_wave_22000_tip", "freund_wave_22000_energy", "freund_wave_errors",
                            "borden_branching_10000_paths", "borden_branching_10000_tip"})
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "charts" / (std::string(chart) + ".svg"))) << chart;
  const auto json = nlohmann::json::parse(read_text(folder / "summary.json"));
  EXPECT_EQ(json.at("problems").size(), 2U);
  EXPECT_EQ(json.at("problems")[0].at("realisations")[0].at("beams_broken"), 400);
  EXPECT_TRUE(contains(read_text(folder / "table.csv"), "borden_branching"));
}

}  // namespace
}  // namespace rift::studio
