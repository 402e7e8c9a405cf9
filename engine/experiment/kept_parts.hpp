#pragma once

#include "engine/simulation/kept_march.hpp"
#include "engine/simulation/record.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// An experiment under way: the marches that it has done so far and the one that it was stopped in, kept in
/// its folder until its report is there.
namespace rift::experiment {

struct ExperimentOptions;

/// What an experiment is known by: its preset, what is wished of it, the program and its instruction set.
std::string experiment_identity(const scene::Preset& preset, const ExperimentOptions& options,
                                const simulation::BuildInfo& build);

/// Whether the folder holds this very experiment, stopped or killed before its report.
bool is_under_way(const std::filesystem::path& folder, const std::string& identity);

/// In what the experiment under way in the folder differs from this one: "specimen.elements was 3000, is now
/// 5000", one for each; empty where the folder holds none.
std::vector<std::string> differences_from(const std::filesystem::path& folder, const std::string& identity);

/// Says in the folder that this experiment is under way; what another one has left of itself is removed, an
/// earlier report stays. Nothing is done where it is under way already. Throws WorldError.
void begin_experiment(const std::filesystem::path& folder, const std::string& identity);

/// Whether anything has been computed of the experiment under way.
bool holds_parts(const std::filesystem::path& folder);

/// The experiment has its report, or nothing of it is worth keeping: removes what was kept for the next call.
void forget_parts(const std::filesystem::path& folder);

/// The marches of an experiment, each by its name: done, gone on with, or found.
class Parts {
 public:
  Parts(std::filesystem::path folder, std::string identity, simulation::MarchOptions options)
      : folder_(std::move(folder)), identity_(std::move(identity)), options_(options) {}

  /// Throws Interrupted where it was stopped, which is kept.
  /// @param[in] progress  told the fraction of the march; false stops it
  simulation::RunResult march(const std::string& name, const simulation::Prepared& prepared,
                              const std::function<bool(double done)>& progress) const;

  const simulation::MarchOptions& options() const { return options_; }

 private:
  std::filesystem::path folder_;
  std::string identity_;
  simulation::MarchOptions options_;
};

}  // namespace rift::experiment
