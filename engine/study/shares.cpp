#include "engine/base/interrupted.hpp"
#include "engine/study/store.hpp"
#include "engine/study/under_way.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>
#include <tuple>
#include <utility>

// Who computes what: each call takes scenarios from the folder until none is left.

namespace rift::study {
namespace {

using Group = std::vector<StudyItem>;

/// Rows of the study that are known to be impossible.
std::set<int> rows_not_made(const UnderWay& study) {
  std::set<int> rows;
  for (const NotMade& one : study.result.not_made) rows.insert(one.rows.begin(), one.rows.end());
  return rows;
}

/// The scenarios still to be computed, one list per group.
std::vector<Group> missing(const UnderWay& study, const std::vector<StudyItem>& mine) {
  const std::set<int> impossible = rows_not_made(study);
  std::vector<Group> groups;
  for (const StudyItem& item : mine) {
    if (study.is_there(item) || impossible.contains(item.row)) continue;
    if (groups.empty() || groups.back().front().group != item.group) groups.emplace_back();
    groups.back().push_back(item);
  }
  return groups;
}

/// Scenarios with the claims on them, which are released together.
struct Share {
  Group items;
  std::vector<base::Claim> claims;
};

/// Claims a scenario. @return false where another process has it
bool claim(UnderWay& study, const StudyItem& item, Share& share) {
  if (study.claims && study.options.work != StudyWork::preparation) {
    std::optional<base::Claim> claim = study.claims->take(hash_text(item.key));
    if (!claim) return false;
    share.claims.push_back(std::move(*claim));
  }
  share.items.push_back(item);
  return true;
}

/// A pass that a process has left under way, such as one whose time ran out; nothing where there is none, or
/// another process goes on with it.
Share share_under_way(UnderWay& study, const Group& left) {
  for (const PassUnderWay& pass : passes_under_way(study, left)) {
    Share share;
    const bool mine = std::all_of(pass.items.begin(), pass.items.end(), [&](const StudyItem& item) {
      return study.is_there(item) || claim(study, item, share);
    });
    if (mine && !share.items.empty()) return share;
  }
  return {};
}

/// Those that march together stand together, the longest first.
void sort_by_kind(Group& items) {
  const auto kind = [](const StudyItem& item) {
    const StepCount count = estimated_steps(item.scene);
    return std::tuple(item.scene.damping.region != scene::DampingRegion::none,
                      std::lround(std::log2(count.step_s)), -count.steps);
  };
  std::stable_sort(items.begin(), items.end(),
                   [&](const StudyItem& a, const StudyItem& b) { return kind(a) < kind(b); });
}

/// How many scenarios of a group one of several tasks takes at a time: as many as fill the lanes, and more
/// where there are more, so that it prepares seldom and the others still find some (guided self-scheduling,
/// Polychronopoulos and Kuck, 1987).
std::size_t size_of_share(const UnderWay& study, const Group& left) {
  if (study.options.work != StudyWork::share) return left.size();
  const auto lanes = static_cast<std::size_t>(lanes_of_many(left.front().scene.solver.precision));
  const auto tasks = static_cast<std::size_t>(std::max(1, study.options.tasks));
  return std::max(lanes, left.size() / (2 * tasks));
}

Share share_of(UnderWay& study, Group& left) {
  if (study.options.work == StudyWork::share) {
    if (Share share = share_under_way(study, left); !share.items.empty()) return share;
    sort_by_kind(left);
  }
  const std::size_t most = size_of_share(study, left);
  Share share;
  for (const StudyItem& item : left)
    if (share.items.size() < most) claim(study, item, share);
  return share;
}

/// What is to be done of the groups, and what of it is preparation.
struct Costs {
  std::vector<double> preparing;
  double whole = 0;
};

Costs costs_of(const UnderWay& study, const std::vector<Group>& groups) {
  PreparationCost preparation;
  Costs costs;
  for (const Group& group : groups) {
    costs.preparing.push_back(preparation.next(group.front()));
    costs.whole += costs.preparing.back();
    if (study.options.work == StudyWork::preparation) continue;
    for (const StudyItem& item : group) costs.whole += item.cost;
  }
  return costs;
}

double cost_of(const UnderWay& study, const Group& items) {
  double cost = 0.0;
  if (study.options.work != StudyWork::preparation)
    for (const StudyItem& item : items) cost += item.cost;
  return cost;
}

void without(Group& left, const Group& gone) {
  std::set<int> rows;
  for (const StudyItem& item : gone) rows.insert(item.row);
  std::erase_if(left, [&](const StudyItem& item) { return rows.contains(item.row); });
}

/// Takes what other processes have computed or found impossible meanwhile.
void take_what_others_did(UnderWay& study, Group& items) {
  if (!study.claims) return;
  gather(study, items);
  for (const StudyItem& item : items)
    if (const auto issues = read_not_made(study.options.folder, item.key))
      add_not_made(study.result.not_made, {item}, *issues);
  const std::set<int> impossible = rows_not_made(study);
  std::erase_if(items,
                [&](const StudyItem& item) { return study.is_there(item) || impossible.contains(item.row); });
}

/// Takes a share of the group and does it. @return whether there was one
bool do_a_share(UnderWay& study, Group& left, double preparing) {
  Share share = share_of(study, left);
  if (share.items.empty()) return false;
  without(left, share.items);
  const double end = study.cost_done + preparing + cost_of(study, share.items);
  study.preparation = preparing;
  take_what_others_did(study, share.items);
  if (!share.items.empty()) compute_what_can_be(study, std::move(share.items));
  study.cost_done = end;
  return true;
}

/// Shares of all groups, until no group gives one. @return whether there was any
bool do_shares(UnderWay& study, std::vector<Group>& groups, std::vector<double>& preparing) {
  bool any = false;
  for (std::size_t k = 0; k < groups.size() && !study.stopped; ++k) {
    if (groups[k].empty() || !do_a_share(study, groups[k], preparing[k])) continue;
    preparing[k] = 0.0;
    any = true;
  }
  return any;
}

/// A call for the whole study waits for scenarios that other processes compute, and takes them where those
/// die.
bool waits_for_others(UnderWay& study, const std::vector<Group>& groups,
                      std::chrono::duration<double> pause) {
  const bool none_left =
      std::all_of(groups.begin(), groups.end(), [](const Group& left) { return left.empty(); });
  if (none_left || study.options.work != StudyWork::everything) return false;
  if (!study.tell("waiting for scenarios that other processes compute", 0.0, 0.0)) return false;
  std::this_thread::sleep_for(pause);
  return true;
}

}  // namespace

void compute(UnderWay& study, const std::vector<StudyItem>& mine) {
  std::vector<Group> groups = missing(study, mine);
  if (groups.empty()) return;
  if (!study.options.shared) study.claims.emplace(study.options.folder / "claims", study.options.label);
  Costs costs = costs_of(study, groups);
  study.cost = costs.whole;
  constexpr std::chrono::duration<double> shortest(0.2), longest(3.0);
  auto pause = shortest;
  try {
    while (!study.stopped) {
      if (do_shares(study, groups, costs.preparing)) {
        pause = shortest;
      } else {
        if (!waits_for_others(study, groups, pause)) break;
        pause = std::min(longest, 1.5 * pause);
      }
    }
  } catch (const base::Interrupted&) {
    study.stopped = true;
  }
  study.claims.reset();
  if (study.stopped || study.options.work == StudyWork::preparation) return;
  gather(study, mine);  // what others were at and have ended
  for (const Group& left : missing(study, mine)) study.result.elsewhere += static_cast<int>(left.size());
}

}  // namespace rift::study
