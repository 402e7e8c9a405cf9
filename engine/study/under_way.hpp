#pragma once

#include "engine/base/cache.hpp"
#include "engine/base/claim.hpp"
#include "engine/base/clock.hpp"
#include "engine/simulation/prepare.hpp"
#include "engine/study/kernel_cost.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/runner.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// What the files of a study's computation share with one another: for them alone.

namespace rift::study {

/// A study under way.
struct UnderWay {
  const scene::Preset& preset;
  const StudyOptions& options;
  base::Cache& cache;
  const simulation::BuildInfo& build;
  const StudyObserver& observer;
  std::vector<StudyItem> items;             // of all parts
  std::optional<base::Claims> claims = {};  // none where the folder is this call's alone
  KernelCosts kernels = {};
  StudyResult result = {};
  int there = 0;                   // scenarios computed or found
  double cost = 0, cost_done = 0;  // of what is to be computed
  bool stopped = false;
  double preparation = 0;  // cost, of the group under way
  std::map<std::string, std::vector<scene::Issue>> impossible =
      {};  // specimens by simulation::specimen_key(), and why

  [[nodiscard]] bool is_there(const StudyItem& item) const { return result.rows[item.row].has_value(); }

  /// Tells how far the whole is when `part` of something of this cost is done. @return whether it goes on
  bool tell(std::string_view stage, double part, double of_cost);
};

// runner.cpp

/// Counts a scenario as computed or found, and tells of it.
void take(UnderWay& study, const StudyItem& item, results::LaneSummary summary);
/// Takes those of these scenarios that the folder holds.
void gather(UnderWay& study, std::span<const StudyItem> items);
/// Keeps scenarios that cannot be made, with the reason.
void note_not_made(UnderWay& study, const std::vector<StudyItem>& items,
                   const std::vector<scene::Issue>& issues);

// shares.cpp

/// Computes, or only prepares, what is missing of these items and what no other process has taken on.
void compute(UnderWay& study, const std::vector<StudyItem>& mine);

// group.cpp

/// The group's lattice under its pre-stress, with a lane for each of these scenarios. Throws
/// ScenariosRefused, and as simulation::prepare().
simulation::Prepared prepare_lanes(UnderWay& study, std::span<const StudyItem> items);
/// Computes what can be of scenarios of one group; what cannot is kept with its reason, and each specimen
/// that cannot be made is tried once.
void compute_what_can_be(UnderWay& study, std::vector<StudyItem> items);

// passes.cpp

/// Marches what `prepared` holds now, keeps each scenario as it ends, and of what is under way a checkpoint.
void march_pass(UnderWay& study, const simulation::Prepared& prepared, std::span<const StudyItem> pass,
                base::Clock::time_point started);

/// A pass that an earlier call has left under way.
struct PassUnderWay {
  std::filesystem::path folder;
  std::vector<StudyItem> items;
};

/// Those passes whose scenarios are all known: computed, or among `missing`.
std::vector<PassUnderWay> passes_under_way(const UnderWay& study, std::span<const StudyItem> missing);

/// Removes the passes all of whose scenarios have been computed, by whichever call.
void forget_passes_that_are_done(const UnderWay& study);

}  // namespace rift::study
