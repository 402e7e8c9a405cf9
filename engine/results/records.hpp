#pragma once

#include "engine/results/schema.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rift::results {

// What a journal is made of, and the bytes each kind of record is stored as (docs/results-format.md).

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
using Record = std::variant<RunHeader, Geometry, Sample, Frame, ReleaseEvent, RateCurve, RunEnd, GaugeRow,
                            Mechanics>;

/// The kind's number in the file, from 1.
[[nodiscard]] std::uint32_t kind_of(const Record& record);

/// The payload of a record, little-endian.
[[nodiscard]] std::string encode(const Record& record);

/// The record of this kind and payload; nothing where the kind is unknown or the payload's own counts do not
/// add up to its size. Allocates no more than a small multiple of the payload, whatever its counts claim.
[[nodiscard]] std::optional<Record> decode(std::uint32_t kind, std::string_view payload);

/// Replaces what version 1 of the journal called a release rate: tip, balance without damping, fracture,
/// balance with damping, balance without damping and rotation.
void from_version_1(Record& record);

/// What a viewer colours cells by, in its order of cells: the N vertices, then the B beams.
struct CellFields {
  std::vector<float> damage_factor;  // N + B; 1 for vertices and for beams that the path does not cross
  std::vector<std::uint8_t> broken;  // N + B; 1 where the damage factor is 0
};

/// Spreads the frame's factors, one per crossing beam, over all cells.
/// Asserts that the frame fits the geometry and has damage factors.
[[nodiscard]] CellFields cell_fields(const Geometry& geometry, const Frame& frame);

/// The polyline that the crack follows in the x-y plane [m], as the run's header has it.
[[nodiscard]] std::vector<std::array<double, 2>> path_of(const nlohmann::ordered_json& header);

/// Where the tips are [m]. @param tip_m  arc length of the tip; with two tips the half length of the crack
[[nodiscard]] std::vector<std::array<double, 2>> tips_at(const nlohmann::ordered_json& header, double tip_m);

}  // namespace rift::results
