#include "engine/results/journal_index.hpp"

#include "engine/base/world_error.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/run_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

namespace rift::results {
namespace {

struct Collector {
  JournalScan scan;

  void moment(std::int64_t step, double time_s, std::int32_t lane) {
    scan.last_step = step;
    scan.last_time_s = time_s;
    scan.lanes = std::max(scan.lanes, lane < std::numeric_limits<std::int32_t>::max() ? lane + 1 : lane);
  }
  void operator()(RunHeader&& header) {
    scan.lanes = std::max(scan.lanes, lanes_of_header(header.json));
    scan.header_json = std::move(header.json);
  }
  void operator()(Geometry&& geometry) { scan.geometry = std::move(geometry); }
  void operator()(Mechanics&& mechanics) { scan.mechanics = std::move(mechanics); }
  void operator()(Sample&& sample) {
    moment(sample.step, sample.time_s, sample.lane);
    scan.samples.push_back(sample);
  }
  void operator()(Frame&& frame) {
    moment(frame.step, frame.time_s, frame.lane);
    ++scan.frames;
  }
  void operator()(ReleaseEvent&& event) { scan.events.push_back(event); }
  void operator()(RateCurve&& curve) { scan.rates.push_back(std::move(curve)); }
  void operator()(GaugeRow&& row) { scan.gauges.push_back(row); }
  void operator()(RunEnd&& end) { scan.summary_json = std::move(end.summary_json); }
};

}  // namespace

JournalScan scan_journal(const std::filesystem::path& path) {
  JournalReader reader(path);
  Collector collector;
  while (auto record = reader.next()) std::visit(collector, std::move(*record));
  auto& scan = collector.scan;
  scan.good_bytes = reader.good_bytes();
  scan.state = reader.state();
  scan.reason = reader.reason();
  return std::move(scan);
}

void for_each_moment(const std::filesystem::path& path, const Geometry& geometry,
                     const std::function<void(std::span<const Frame>)>& visit) {
  JournalReader reader(path);
  std::vector<Frame> moment;
  while (auto record = reader.next()) {
    auto* frame = std::get_if<Frame>(&*record);
    if (!frame) continue;
    check_fit(path, geometry, *frame);
    const bool same =
        !moment.empty() && moment.front().step == frame->step && moment.front().time_s == frame->time_s;
    if (!same && !moment.empty()) {
      visit(moment);
      moment.clear();
    }
    const auto former = std::ranges::find(moment, frame->lane, &Frame::lane);
    if (former != moment.end())
      *former = std::move(*frame);
    else
      moment.push_back(std::move(*frame));
  }
  if (!moment.empty()) visit(moment);
}

std::string lane_name(std::string_view field, std::int32_t lane, std::int32_t lanes) {
  return lanes <= 1 ? std::string(field) : fmt::format("{}_lane{}", field, lane);
}

std::int32_t lanes_of_header(const std::string& header_json) {
  const auto header = json_or_discarded(header_json);
  if (!header.is_object()) return 0;
  const auto lanes = header.find("lanes");
  return lanes != header.end() && lanes->is_number_integer() ? lanes->get<std::int32_t>() : 0;
}

void check_fit(const std::filesystem::path& path, const Geometry& geometry, const Frame& frame) {
  const auto fits = [](const auto& field, std::size_t count) {
    return field.empty() || field.size() == count;
  };
  const std::size_t elements = geometry.position.size();
  if (!fits(frame.displacement, elements) || !fits(frame.velocity, elements) ||
      !fits(frame.elastic_energy, elements) || !fits(frame.rotation, elements) || !fits(frame.damage_factor, geometry.crossing.size()))
    throw base::WorldError("use", path,
                           fmt::format("the frame of step {} does not fit the geometry", frame.step));
}

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
  if (const auto* row = std::get_if<GaugeRow>(&record)) lane(row->lane).gauges.push_back(*row);
  if (const auto* event = std::get_if<ReleaseEvent>(&record)) lane(event->lane).events.push_back(*event);
  if (auto* curve = std::get_if<RateCurve>(&record)) lane(curve->lane).rates = std::move(curve->points);
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
