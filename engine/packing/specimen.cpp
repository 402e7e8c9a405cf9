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

/// For each of n elements, one of those that hang together with it, the same for all of them.
std::vector<int> pieces_of(std::size_t n, const std::vector<std::array<int, 2>>& beam) {
  std::vector<int> parent(n);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {  // of i's tree, halving the path to it
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& [i, j] : beam) parent[root(i)] = root(j);
  std::vector<int> piece(n);
  for (int i = 0; i < static_cast<int>(n); ++i) piece[i] = root(i);
  return piece;
}

}  // namespace

std::vector<char> reached_from(const std::vector<char>& anchor, const std::vector<std::array<int, 2>>& beam) {
  const std::vector<int> piece = pieces_of(anchor.size(), beam);
  std::vector<char> anchored(anchor.size(), 0), reached(anchor.size());
  for (std::size_t i = 0; i < anchor.size(); ++i)
    if (anchor[i]) anchored[piece[i]] = 1;
  for (std::size_t i = 0; i < anchor.size(); ++i) reached[i] = anchored[piece[i]];
  return reached;
}

namespace {

/// The elements that are wanted, renumbered, with their beams and grips.
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
  const std::vector<int> piece = pieces_of(packing.radius.size(), beams);
  std::vector<int> members(piece.size(), 0);
  for (const int p : piece) ++members[p];
  const auto largest = static_cast<int>(std::max_element(members.begin(), members.end()) - members.begin());
  std::vector<char> wanted(piece.size());
  for (std::size_t i = 0; i < piece.size(); ++i) wanted[i] = piece[i] == largest;
  Specimen specimen = specimen_of(packing, box, beams, wanted);
  const auto holds_none = [&](Grip grip) { return std::ranges::count(specimen.grip, grip) == 0; };
  if (box.shape != Shape::periodic && (holds_none(Grip::bottom) || holds_none(Grip::top)))
    throw PackingError("no path of beams joins the bottom to the top: the specimen carries no load");
  return specimen;
}

}  // namespace rift::packing
