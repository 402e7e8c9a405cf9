#include "engine/measurement/instruments.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/base/ownership.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/measurement/specimen_properties.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/records.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/record.hpp"
#include "engine/theory/strip_transient.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rift::measurement {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::filesystem::path& run, const std::string& text) {
  throw scene::InputError({scene::Issue{.file = run.string(), .key = {}, .text = text}});
}

fracture::CrackPath path_in(const Json& header) {
  fracture::CrackPath path{{}, header.value("tips", 1)};
  for (const auto& [x, y] : results::path_of(header)) path.point.emplace_back(x, y);
  return path;
}

fracture::RateScale scale_in(const Json& header, int lane) {
  const Json& scale = header.at("rate_scales").at(lane);
  return {.thickness = header.at("thickness_m"),
          .g_i0 = scale.at("g_i0_j_m2"),
          .length = header.at("length_m"),
          .g_i0_slope = scale.at("g_i0_slope_j_m3"),
          .tips = header.value("tips", 1)};
}

template <class Row>
std::vector<Row> of_lane(const std::vector<Row>& rows, int lane) {
  std::vector<Row> kept;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(kept),
               [&](const Row& row) { return row.lane == lane; });
  return kept;
}

/// By the first sample whose tip is on the measured way.
double clock_of(const scene::Scene& scene, const std::vector<results::Sample>& samples) {
  if (scene.crack.history.empty()) return 0.0;
  const history::SmoothedHistory course = scene::smoothed_history(scene);
  for (const results::Sample& s : samples)
    if (s.velocity_m_s > 0.0 && s.tip_m > scene.crack.start)
      return course.first_time + history::time_of_arrival(course.history, s.tip_m) - s.time_s;
  return 0.0;
}

/// E and nu that the lane's specimen shows; why there are none in `why`.
ElasticPlate own_plate(scene::Preset preset, const scene::Scene& lane, base::Cache& cache,
                       const simulation::StageProgress& progress, std::string& why) {
  preset.scene = lane, preset.lanes.clear();
  const simulation::Prepared plate = simulation::prepare(preset, cache, progress);
  ElasticPlate own{.density = plate.density};  // a plate that nothing holds across: plane stress
  try {
    const simulation::OwnConstants pulled = pulled_constants(plate, plate.lane.front(), cache,
                                                             simulation::stage(progress, "static pulls"));
    own.young_modulus = pulled.young_modulus(), own.poisson_ratio = pulled.poisson_ratio();
  } catch (const std::runtime_error& error) {  // of statics, or too few elements at an end
    if (dynamic_cast<const base::Interrupted*>(&error)) throw;
    why = std::string("K needs the plate's own E and ν, and it cannot be pulled: ") + error.what();
  }
  return own;
}

/// The strip that theory::strip_transient is of: five times as long as high, pulled evenly, its crack half
/// way up and of one velocity from the free end.
bool is_paper_strip(const scene::Scene& scene) {
  const double height = scene.specimen.height;
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
  return near(scene.specimen.length, 5.0 * height) && scene.crack.path.point.empty() &&
         near(scene::path_height_m(scene), 0.5 * height) && scene.crack.tips == 1 &&
         scene.crack.start == 0.0 && scene::keeps_its_velocity(scene) && !scene::grip_moves(scene) &&
         scene.loading.tilt == 0.0 && scene.loading.shear == 0.0;
}

std::vector<ArrivingStretch> arriving_of(const Instruments& seen, const scene::Scene& scene) {
  std::vector<ArrivingStretch> all;
  if (!is_paper_strip(scene)) return all;
  for (const theory::TransientStretch& t : theory::strip_transient(scene::highest_velocity(scene))) {
    ArrivingStretch stretch{t.from * seen.plate.x(), t.to * seen.plate.x(), 0, 0.0, t.over_g_i0};
    if (seen.samples.empty() || seen.samples.back().tip_m < (1.0 - 1e-3) * stretch.to) continue;
    for (const IntensityPoint& p : seen.intensity) {
      if (!p.k || p.tip < stretch.from || p.tip > stretch.to) continue;
      ++stretch.moments;
      stretch.over_g_i0 += p.k->release_rate / (seen.g_i0 + seen.g_i0_slope * p.tip);
    }
    stretch.over_g_i0 /= stretch.moments;
    if (stretch.moments > 0 && !std::isnan(stretch.expected)) all.push_back(stretch);
  }
  return all;
}

std::vector<Eigen::Vector2d> places_of(const results::Geometry& geometry) {
  std::vector<Eigen::Vector2d> at;
  for (const auto& p : geometry.position) at.emplace_back(p[0], p[1]);
  return at;
}

std::vector<std::optional<lattice::PlaneMotion>> look(const Camera& camera, const results::Frame& frame) {
  return camera.see(frame.tip_m, [&](int i) {
    const auto& u = frame.displacement[i];
    return Eigen::Vector3d(u[0], u[1], u[2]);
  });
}

}  // namespace

std::string ring_that_fits(const Instruments& seen, const InstrumentOptions& options) {
  constexpr double comfortable =
      2.0;  // inner radii that are clear, with points enough between them and the edge
  double clear = 0.0;
  for (const IntensityPoint& p : seen.intensity) {
    if (p.k) return {};
    if (p.why != NoFit::fast && p.why != NoFit::tip) clear = std::max(clear, p.clear);
  }
  if (clear <= 0.0) return {};
  const double wanted = comfortable * seen.ring.inner;
  if (clear > wanted) return fmt::format("--grid {:g} puts more points into it", 0.5 * options.grid);
  const double inner = std::floor(10.0 * clear / (comfortable * seen.mean_radius)) / 10.0;
  // Radii go with N^-1/2 where the thickness follows from the layers, else with N^-1/3   [model.md §1].
  const double elements = seen.elements * std::pow(wanted / clear, seen.of_layers ? 2.0 : 3.0);
  return fmt::format(
      "{:.3g} mm are clear around the tip and the ring wants {:.3g}, twice --inner. '--inner {:g} --grid "
      "{:g}' "
      "suits this run, specimen.elements = {:.0f} another one",
      1e3 * clear, 1e3 * wanted, inner, 0.5 * options.grid, 100.0 * std::ceil(elements / 100.0));
}

Instruments read_instruments(const std::filesystem::path& run, const InstrumentOptions& options,
                             base::Cache& cache, const simulation::StageProgress& progress,
                             const std::function<void(const Grid&, const SeenField&)>& see) {
  const scene::Preset preset = simulation::preset_of_run(run);
  const std::filesystem::path journal = run / results::journal_name;
  const base::HeldFile held(journal);
  const results::JournalScan scan = results::scan_journal(journal);
  const Json header = results::read_json(scan.header_json, journal);
  if (options.lane < 0 || options.lane >= scan.lanes)
    refuse(run, fmt::format("has no lane {}: it has {}", options.lane,
                            scan.lanes == 1 ? "one" : fmt::format("0 to {}", scan.lanes - 1)));
  const scene::Scene& scene = preset.lanes.empty() ? preset.scene : preset.lanes.at(options.lane);
  const Eigen::Vector2d size(header.at("length_m"), header.at("height_m"));
  const double radius = header.at("mean_radius_m");
  const bool zone = scene.crack.technique == fracture::Technique::progressive;
  const fracture::RateScale scale = scale_in(header, options.lane);
  Instruments seen{.grid = grid_over(size.x(), size.y(), options.grid * radius),
                   .subset = options.subset * radius,
                   .ring = {.inner = options.inner * radius,
                            .outer = options.outer * radius,
                            .beside_faces = options.subset * radius,
                            .zone = zone ? scene.crack.damage_zone_ratio * radius : 0.0},
                   .plate = {size.x(), size.y(), header.at("thickness_m")},
                   .mean_radius = radius,
                   .elements = scene.specimen.elements,
                   .of_layers = scene.specimen.layers.has_value(),
                   .g_i0 = scale.g_i0,
                   .g_i0_slope = scale.g_i0_slope,
                   .samples = of_lane(scan.samples, options.lane),
                   .gauges = of_lane(scan.gauges, options.lane),
                   .own = {},
                   .intensity = {},
                   .arriving = {},
                   .no_intensity = {},
                   .grip_moves = scene::grip_moves(scene),
                   .finished = scan.summary_json.has_value()};
  seen.own = own_plate(preset, scene, cache, progress, seen.no_intensity);
  seen.clock = clock_of(scene, seen.samples);
  const fracture::CrackPath path = path_in(header);
  const Camera camera(places_of(*scan.geometry), seen.grid.point, seen.subset, parted_by(path));
  const IntensityReading reading(path, size, seen.own, scene::rayleigh_speed(scene), seen.ring, seen.samples,
                                 scale);
  std::int64_t read = 0;
  bool any = false;
  const auto take = [&](const results::Frame& frame) {
    if (progress && !progress("frames", static_cast<double>(read++) / static_cast<double>(scan.frames)))
      throw base::Interrupted("the frames were read");
    if (frame.lane != options.lane || frame.displacement.empty()) return;
    const SeenField field{frame.time_s, frame.tip_m, look(camera, frame)};
    if (seen.no_intensity.empty()) seen.intensity.push_back(reading.at(field, seen.grid.point));
    see(seen.grid, field);
    any = true;
  };
  results::for_each_moment(journal, *scan.geometry, [&](std::span<const results::Frame> moment) {
    for (const results::Frame& frame : moment) take(frame);
  });
  results::check_same_run(held);
  if (!any) refuse(run, "stores no displacements: set output.frames and output.fields");
  seen.arriving = arriving_of(seen, scene);
  return seen;
}

}  // namespace rift::measurement
