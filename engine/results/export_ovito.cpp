#include "engine/results/export_ovito.hpp"

#include "engine/base/files.hpp"
#include "engine/base/ownership.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/journal_scan.hpp"
#include "engine/results/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <set>
#include <string>

namespace rift::results {
namespace {

namespace fs = std::filesystem;
using Vector = std::array<float, 3>;

Vector deformed(const Geometry& geometry, const Frame& frame, std::size_t i) {
  Vector p = geometry.position[i];
  for (int axis = 0; axis < 3 && !frame.displacement.empty(); ++axis) p[axis] += frame.displacement[i][axis];
  return p;
}

/// Free boundaries that hold all elements as deformed.
std::string box_of(const Geometry& geometry, const Frame& frame) {
  Vector low{1e30F, 1e30F, 1e30F}, high{-1e30F, -1e30F, -1e30F};
  for (std::size_t i = 0; i < geometry.position.size(); ++i) {
    const Vector p = deformed(geometry, frame, i);
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis] - geometry.radius[i]);
      high[axis] = std::max(high[axis], p[axis] + geometry.radius[i]);
    }
  }
  std::string text = "ITEM: BOX BOUNDS ff ff ff\n";
  for (int axis = 0; axis < 3; ++axis) text += fmt::format("{} {}\n", low[axis], high[axis]);
  return text;
}

std::string head_of(const Frame& frame, const char* counted, std::size_t count) {
  return fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\n", frame.step, counted, count);
}

std::string numbers(const Vector& v) { return fmt::format(" {} {} {}", v[0], v[1], v[2]); }

std::string atoms_of(const Geometry& geometry, const Frame& frame) {
  std::string text = head_of(frame, "ATOMS", geometry.position.size()) + box_of(geometry, frame);
  text += "ITEM: ATOMS id type radius x y z";
  if (!frame.displacement.empty()) text += " ux uy uz";
  if (!frame.velocity.empty()) text += " vx vy vz";
  if (!frame.elastic_energy.empty()) text += " elastic_energy";
  text += "\n";
  for (std::size_t i = 0; i < geometry.position.size(); ++i) {
    text += fmt::format("{} 1 {}", i + 1, geometry.radius[i]) + numbers(deformed(geometry, frame, i));
    if (!frame.displacement.empty()) text += numbers(frame.displacement[i]);
    if (!frame.velocity.empty()) text += numbers(frame.velocity[i]);
    if (!frame.elastic_energy.empty()) text += fmt::format(" {}", frame.elastic_energy[i]);
    text += "\n";
  }
  return text;
}

std::string beams_of(const Geometry& geometry, const Frame& frame) {
  std::vector<float> factor(geometry.beam.size(), 1.0F);
  for (std::size_t k = 0; k < geometry.crossing.size(); ++k)
    factor[geometry.crossing[k]] = frame.damage_factor[k];
  const auto bearing = std::count_if(factor.begin(), factor.end(), [](float f) { return f > 0; });
  std::string text = head_of(frame, "ENTRIES", static_cast<std::size_t>(bearing)) + box_of(geometry, frame);
  text += "ITEM: ENTRIES index atom1 atom2 factor\n";
  for (std::size_t b = 0; b < factor.size(); ++b)
    if (factor[b] > 0)
      text +=
          fmt::format("{} {} {} {}\n", b + 1, geometry.beam[b][0] + 1, geometry.beam[b][1] + 1, factor[b]);
  return text;
}

void export_lane(const JournalIndex& journal, std::int32_t lane, const fs::path& folder,
                 std::set<std::string>& written) {
  const auto name = [&](const char* stem) {
    return folder / *written.insert(lane_name(stem, lane, journal.lanes()) + ".dump").first;
  };
  const auto& entries = journal.frames(lane);
  base::PendingText atoms(name("run"));
  if (entries.empty()) atoms.append(atoms_of(journal.geometry(), {}));
  for (const FrameEntry& entry : entries) atoms.append(atoms_of(journal.geometry(), journal.frame(entry)));
  atoms.commit();
  if (entries.empty() || journal.frame(entries.front()).damage_factor.empty()) return;
  base::PendingText beams(name("beams"));
  for (const FrameEntry& entry : entries)
    if (const Frame frame = journal.frame(entry); !frame.damage_factor.empty())
      beams.append(beams_of(journal.geometry(), frame));
  beams.commit();
}

}  // namespace

fs::path export_ovito(const fs::path& run_folder) {
  const JournalIndex journal(run_folder / journal_name);
  const fs::path folder = run_folder / "ovito";
  const base::OwnedFolder owned(folder);
  std::set<std::string> written;
  for (std::int32_t lane = 0; lane < journal.lanes(); ++lane) export_lane(journal, lane, folder, written);
  remove_other_exports(folder, "ovito", written);
  return folder;
}

}  // namespace rift::results
