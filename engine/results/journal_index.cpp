#include "engine/results/journal_index.hpp"

#include "engine/base/world_error.hpp"
#include "engine/results/agreement.hpp"
#include "engine/results/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rift::results {
namespace {

constexpr std::int32_t most_lanes = 4096;  // more is no run of ours

}  // namespace

JournalIndex::JournalIndex(std::filesystem::path path) : path_(std::move(path)), held_(path_) {
  extend();
  if (!header_json_.empty() && !geometry_.position.empty()) return;
  throw base::WorldError("read", path_, reason_.empty() ? "it holds no geometry yet" : reason_);
}

void JournalIndex::extend() {
  check_same_run(held_);
  JournalReader reader(path_, good_bytes_);
  for (std::uint64_t offset = reader.good_bytes(); auto record = reader.next(); offset = reader.good_bytes())
    take(std::move(*record), offset);
  good_bytes_ = reader.good_bytes();
  state_ = reader.state();
  reason_ = reader.reason();
}

void JournalIndex::take(Record&& record, std::uint64_t offset) {
  if (auto* header = std::get_if<RunHeader>(&record)) {
    header_json_ = std::move(header->json);
    lane_.resize(std::clamp(lanes_of_header(header_json_), 1, most_lanes));
  }
  if (auto* geometry = std::get_if<Geometry>(&record)) geometry_ = std::move(*geometry);
  if (const auto* sample = std::get_if<Sample>(&record)) lane(sample->lane).samples.push_back(*sample);
  if (auto* end = std::get_if<RunEnd>(&record)) summary_json_ = std::move(end->summary_json);
  if (const auto* frame = std::get_if<Frame>(&record)) {
    check_fit(path_, geometry_, *frame);
    lane(frame->lane).frames.push_back({offset, frame->step, frame->time_s, frame->tip_m});
  }
}

JournalIndex::Lane& JournalIndex::lane(std::int32_t number) {
  if (number >= lanes())
    throw base::WorldError("use", path_, fmt::format("a record of lane {} in a run of {}", number, lanes()));
  return lane_[number];
}

Frame JournalIndex::frame(const FrameEntry& entry) const {
  check_same_run(held_);
  JournalReader reader(path_, entry.offset);
  auto record = reader.next();
  auto* frame = record ? std::get_if<Frame>(&*record) : nullptr;
  if (frame == nullptr || frame->step != entry.step)
    throw base::WorldError("read", path_,
                           fmt::format("the frame of step {} is not where it was", entry.step));
  return std::move(*frame);
}

}  // namespace rift::results
