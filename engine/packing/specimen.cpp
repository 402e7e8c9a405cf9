#include "engine/packing/specimen.hpp"

#include <algorithm>
#include <numeric>

namespace rift::packing {
namespace {

std::vector<Grip> grips_of(const Packing& packing, const Box& box) {
  std::vector<Grip> grips(packing.radius.size(), Grip::none);
  if (box.shape == Shape::periodic) return grips;
  for (const Grip grip : {Grip::top, Grip::bottom})
    for (const int i : elements_at(box, boundary_of(grip), packing.centre, packing.radius, grip_depth))
      grips[i] = grip;
  return grips;
}

/// Root of i's tree, halving the path on the way.
int root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

std::vector<char> reached_from(const std::vector<char>& anchor, const std::vector<std::array<int, 2>>& beam) {
  std::vector<int> parent(anchor.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [i, j] : beam) parent[root(parent, i)] = root(parent, j);
  std::vector<char> anchored(anchor.size(), 0), reached(anchor.size(), 0);
  for (int i = 0; i < static_cast<int>(anchor.size()); ++i)
    if (anchor[i]) anchored[root(parent, i)] = 1;
  for (int i = 0; i < static_cast<int>(anchor.size()); ++i) reached[i] = anchored[root(parent, i)];
  return reached;
}

namespace {

/// The elements that are wanted, numbered anew, with their beams and grips.
Specimen specimen_of(const Packing& packing, const Box& box, const std::vector<std::array<int, 2>>& beams,
                     const std::vector<char>& wanted) {
  Specimen specimen;
  specimen.box = box;
  specimen.packing = statistics(packing, box);
  const std::vector<Grip> grips = grips_of(packing, box);
  std::vector<int> renumbered(wanted.size(), -1);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!wanted[i]) {
      ++specimen.rattlers;
      continue;
    }
    renumbered[i] = static_cast<int>(specimen.centre.size());
    specimen.centre.push_back(packing.centre[i]);
    specimen.radius.push_back(packing.radius[i]);
    specimen.grip.push_back(grips[i]);
  }
  for (const auto& [i, j] : beams)
    if (renumbered[i] >= 0 && renumbered[j] >= 0) specimen.beam.push_back({renumbered[i], renumbered[j]});
  return specimen;
}

std::vector<char> reached_from_grip(Grip grip, const std::vector<Grip>& grips,
                                    const std::vector<std::array<int, 2>>& beams) {
  std::vector<char> in(grips.size());
  std::ranges::transform(grips, in.begin(), [&](Grip other) { return other == grip; });
  return reached_from(in, beams);
}

}  // namespace

Specimen make_plate(const Packing& packing, const Box& box, double contact_tolerance) {
  const auto beams = contacts(packing, box, contact_tolerance);
  const std::vector<Grip> grips = grips_of(packing, box);
  const std::vector<char> from_bottom = reached_from_grip(Grip::bottom, grips, beams),
                          from_top = reached_from_grip(Grip::top, grips, beams);
  std::vector<char> wanted(from_top.size());
  bool joined = false;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted[i] = from_bottom[i] || from_top[i];
    joined = joined || (from_bottom[i] && from_top[i]);
  }
  if (!joined) throw PackingError("no path of beams joins the bottom grip to the top grip");
  return specimen_of(packing, box, beams, wanted);
}

Specimen make_free_specimen(const Packing& packing, const Box& box, double contact_tolerance) {
  const auto beams = contacts(packing, box, contact_tolerance);
  std::vector<int> parent(packing.radius.size()), members(packing.radius.size(), 0);
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [i, j] : beams) parent[root(parent, i)] = root(parent, j);
  for (std::size_t i = 0; i < parent.size(); ++i) ++members[root(parent, static_cast<int>(i))];
  const auto largest = static_cast<int>(std::max_element(members.begin(), members.end()) - members.begin());
  std::vector<char> wanted(parent.size());
  for (std::size_t i = 0; i < parent.size(); ++i) wanted[i] = root(parent, static_cast<int>(i)) == largest;
  Specimen specimen = specimen_of(packing, box, beams, wanted);
  const auto holds_none = [&](Grip grip) { return std::ranges::count(specimen.grip, grip) == 0; };
  if (box.shape != Shape::periodic && (holds_none(Grip::bottom) || holds_none(Grip::top)))
    throw PackingError("no path of beams joins the bottom to the top: nothing in the specimen carries load");
  return specimen;
}

}  // namespace rift::packing
