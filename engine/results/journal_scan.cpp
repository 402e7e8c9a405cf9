#include "engine/results/journal_scan.hpp"

#include "engine/results/agreement.hpp"

#include <fmt/format.h>

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

}  // namespace rift::results
