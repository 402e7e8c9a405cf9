#include "engine/results/records.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace rift::results {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the journal stores the memory of a little-endian machine");
static_assert(sizeof(RatePoint) == 5 * sizeof(double), "stored as it lies in memory");
static_assert(sizeof(std::array<float, 3>) == 12 && sizeof(std::array<double, 3>) == 24 && sizeof(std::array<std::int32_t, 2>) == 8);

/// Appends numbers and arrays to a payload.
struct Encoder {
  std::string bytes;

  template <typename T>
  void operator()(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  template <typename T>
  void operator()(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    (*this)(static_cast<std::uint64_t>(values.size()));
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  void operator()(const std::string& text) { bytes.append(text); }
  /// What older journals do not have, at the end of its record.
  template <typename T>
  void where_any(const std::vector<T>& values) {
    if (!values.empty()) (*this)(values);
  }
  void where_any(double value) { (*this)(value); }
  /// The second has its place behind the first, which is then written even where it is empty.
  template <typename A, typename B>
  void where_any(const std::vector<A>& first, const std::vector<B>& second) {
    if (!first.empty() || !second.empty()) (*this)(first);
    where_any(second);
  }
};

/// Takes numbers and arrays off a payload; `good` falls where it holds less than they need.
struct Decoder {
  std::string_view bytes;
  bool good = true;

  bool take(void* target, std::size_t size) {
    good = good && size <= bytes.size();
    if (!good) return false;
    if (size > 0) std::memcpy(target, bytes.data(), size);
    bytes.remove_prefix(size);
    return true;
  }
  template <typename T>
  void operator()(T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    take(&value, sizeof(T));
  }
  template <typename T>
  void operator()(std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::uint64_t count = 0;
    if (!take(&count, sizeof(count))) return;
    good = count <= bytes.size() / sizeof(T);  // before the allocation: the count may lie
    if (!good) return;
    values.resize(count);
    take(values.data(), count * sizeof(T));
  }
  template <typename T>
  void where_any(T& value) {
    if (!bytes.empty()) (*this)(value);
  }
  template <typename A, typename B>
  void where_any(A& first, B& second) {
    where_any(first);
    where_any(second);
  }
  void operator()(std::string& text) {
    text = bytes;
    bytes = {};
  }
};

// One list of fields per kind serves both directions, so that they cannot drift apart.

template <typename Codec, typename R>
void fields(Codec& code, R& record) {
  using T = std::remove_const_t<R>;
  const auto all = [&code](auto&... field) { (code(field), ...); };
  if constexpr (std::is_same_v<T, RunHeader>) {
    all(record.json);
  } else if constexpr (std::is_same_v<T, Geometry>) {
    all(record.position, record.radius, record.beam, record.crossing);
  } else if constexpr (std::is_same_v<T, Sample>) {
    all(record.step, record.time_s, record.phase, record.lane, record.tip_m, record.velocity_m_s,
        record.elastic_j, record.kinetic_translation_j, record.kinetic_rotation_j, record.step_correction_j,
        record.fracture_j, record.damping_j, record.numerical_damping_j, record.work_external_j,
        record.residual);
    code.where_any(record.contact_j);
    code.where_any(record.grip_force_n);
  } else if constexpr (std::is_same_v<T, Frame>) {
    all(record.step, record.time_s, record.lane, record.tip_m, record.displacement, record.velocity,
        record.damage_factor);
    code.where_any(record.elastic_energy, record.rotation);
  } else if constexpr (std::is_same_v<T, ReleaseEvent>) {
    all(record.beam, record.lane, record.time_s, record.position_m, record.energy_j);
    code.where_any(record.x_m);
    code.where_any(record.y_m);
    code.where_any(record.tension);
  } else if constexpr (std::is_same_v<T, RateCurve>) {
    all(record.lane, record.points);
  } else if constexpr (std::is_same_v<T, GaugeRow>) {
    all(record.step, record.time_s, record.lane, record.gauge, record.x_m, record.y_m, record.ux_m,
        record.uy_m, record.uz_m, record.vx_m_s, record.vy_m_s, record.vz_m_s, record.strain_xx,
        record.strain_yy, record.strain_xy);
  } else if constexpr (std::is_same_v<T, Mechanics>) {
    all(record.centre, record.radius, record.mass, record.inertia, record.grip, record.axial, record.bending,
        record.twist, record.crossing_position);
  } else {
    static_assert(std::is_same_v<T, RunEnd>);
    all(record.summary_json);
  }
}

/// Counts that agree with one another and indices that point into the arrays they index.
bool is_valid(const Geometry& geometry) {
  const auto elements = static_cast<std::int64_t>(geometry.position.size());
  const auto beams = static_cast<std::int64_t>(geometry.beam.size());
  if (geometry.radius.size() != geometry.position.size()) return false;
  for (const auto& [a, b] : geometry.beam)
    if (a < 0 || b < 0 || a >= elements || b >= elements) return false;
  for (std::size_t i = 0; i < geometry.crossing.size(); ++i) {
    if (geometry.crossing[i] < 0 || geometry.crossing[i] >= beams) return false;
    if (i > 0 && geometry.crossing[i] <= geometry.crossing[i - 1]) return false;
  }
  return true;
}

bool is_valid(const Sample& sample) { return sample.phase <= Phase::fracture && sample.lane >= 0; }
bool is_valid(const Frame& frame) { return frame.lane >= 0; }
bool is_valid(const ReleaseEvent& event) { return event.lane >= 0 && event.beam >= 0; }
bool is_valid(const RateCurve& curve) { return curve.lane >= 0; }
bool is_valid(const GaugeRow& row) { return row.lane >= 0 && row.gauge >= 0; }
bool is_valid(const Mechanics& m) {
  const std::size_t elements = m.centre.size(), beams = m.axial.size();
  const auto held = [](std::uint8_t grip) { return grip <= 2; };
  return m.radius.size() == elements && m.mass.size() == elements && m.inertia.size() == elements &&
         m.grip.size() == elements && m.bending.size() == beams && m.twist.size() == beams &&
         std::all_of(m.grip.begin(), m.grip.end(), held);
}
bool is_valid(const RunHeader&) { return true; }
bool is_valid(const RunEnd&) { return true; }

template <std::size_t I = 0>
std::optional<Record> decode_kind(std::size_t index, std::string_view payload) {
  if constexpr (I == std::variant_size_v<Record>) {
    return std::nullopt;
  } else {
    if (index != I) return decode_kind<I + 1>(index, payload);
    std::variant_alternative_t<I, Record> record;
    Decoder decoder{payload};
    fields(decoder, record);
    if (!decoder.good || !decoder.bytes.empty() || !is_valid(record)) return std::nullopt;
    return record;
  }
}

}  // namespace

std::uint32_t kind_of(const Record& record) { return static_cast<std::uint32_t>(record.index()) + 1; }

std::string encode(const Record& record) {
  Encoder encoder;
  std::visit([&encoder](const auto& one) { fields(encoder, one); }, record);
  return std::move(encoder.bytes);
}

std::optional<Record> decode(std::uint32_t kind, std::string_view payload) {
  if (kind == 0) return std::nullopt;
  return decode_kind(kind - 1, payload);
}

void from_version_1(Record& record) {
  auto* curve = std::get_if<RateCurve>(&record);
  if (!curve) return;
  for (RatePoint& p : curve->points) {
    const auto [tip, balance, fracture, with_damping, without_rotation] = p;
    p = {.tip_m = tip,
         .ratio = with_damping,
         .ratio_fracture = fracture,
         .ratio_paper = without_rotation + (with_damping - balance),
         .ratio_difference = balance - fracture};
  }
}

CellFields cell_fields(const Geometry& geometry, const Frame& frame) {
  assert(frame.damage_factor.size() == geometry.crossing.size());
  const std::size_t elements = geometry.position.size();
  CellFields fields{std::vector<float>(elements + geometry.beam.size(), 1.0F),
                    std::vector<std::uint8_t>(elements + geometry.beam.size(), 0)};
  for (std::size_t i = 0; i < frame.damage_factor.size(); ++i) {
    const std::size_t cell = elements + static_cast<std::size_t>(geometry.crossing[i]);
    fields.damage_factor[cell] = frame.damage_factor[i];
    fields.broken[cell] = frame.damage_factor[i] == 0.0F;
  }
  return fields;
}

namespace {

using Point = std::array<double, 2>;

double distance(const Point& a, const Point& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

Point point_at(const std::vector<Point>& path, double arc) {
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const double piece = distance(path[k], path[k + 1]);
    if (arc > piece && k + 2 < path.size()) {
      arc -= piece;
      continue;
    }
    const double part = piece > 0 ? arc / piece : 0;
    return {path[k][0] + part * (path[k + 1][0] - path[k][0]),
            path[k][1] + part * (path[k + 1][1] - path[k][1])};
  }
  return path.front();
}

}  // namespace

std::vector<Point> path_of(const nlohmann::ordered_json& header) {
  return header.at("path").get<std::vector<Point>>();
}

std::vector<Point> tips_at(const nlohmann::ordered_json& header, double tip_m) {
  const std::vector<Point> path = path_of(header);
  if (header.value("tips", 1) == 0) return {};
  if (header.value("tips", 1) == 1) return {point_at(path, tip_m)};
  double length = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) length += distance(path[k], path[k + 1]);
  return {point_at(path, 0.5 * length - tip_m), point_at(path, 0.5 * length + tip_m)};
}

}  // namespace rift::results
