#pragma once

#include "engine/results/schema.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// What a journal is made of, and the bytes each kind of record is stored as (docs/results-format.md).
namespace rift::results {

/// First record: what is being run, as JSON text (effective preset, version, ...).
struct RunHeader {
  std::string json;
};

/// The release rate of one lane against its tip, computed when the run has ended.
struct RateCurve {
  std::int32_t lane = 0;
  std::vector<RatePoint> points;
};

/// Last record of a run that ended by itself: its summary as JSON text.
struct RunEnd {
  std::string summary_json;
};

/// The order of the alternatives is the kind's number in the file, from 1; new kinds go last.
using Record = std::variant<RunHeader, Geometry, Sample, Frame, ReleaseEvent, RateCurve, RunEnd, GaugeRow>;

/// The kind's number in the file, from 1.
[[nodiscard]] std::uint32_t kind_of(const Record& record);

/// The payload of a record, little-endian.
[[nodiscard]] std::string encode(const Record& record);

/// The record of this kind and payload; nothing where the kind is unknown or the payload's own counts do not
/// add up to its size. Allocates no more than a small multiple of the payload, whatever its counts claim.
[[nodiscard]] std::optional<Record> decode(std::uint32_t kind, std::string_view payload);

}  // namespace rift::results
