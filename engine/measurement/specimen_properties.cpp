#include "engine/measurement/specimen_properties.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/calibration/pull.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/packing/packing.hpp"
#include "engine/scene/derived.hpp"

#include <limits>

namespace rift::measurement {
namespace {

/// Of the plate at rest with its beams as the first lane's law leaves them when the tip is at `tip` [J].
double energy_cut_to(const simulation::Prepared& p, double tip, const base::ProgressCallback& told) {
  const lattice::Kinematics kinematics = p.preset.scene.solver.kinematics;
  const scene::Scene::Loading& loading = p.preset.scene.loading;
  const lattice::Pull pull(p.pulled, loading.tilt, loading.shear);
  lattice::Lattice lattice = p.lattice;
  std::vector<char> present(lattice.beam.size(), 1);
  for (const fracture::Crossing& c : fracture::crossings(p.path, lattice)) {
    const double left = fracture::stiffness_left(p.lane.front().scenario.law, tip, c.position);
    present[c.beam] = left > 0.0;
    lattice::Beam& beam = lattice.beam[c.beam];
    beam.axial *= left, beam.bending *= left, beam.twist *= left;
  }
  const std::vector<lattice::Vector6> q =
      kinematics == lattice::Kinematics::linear
          ? lattice::stretched_at_rest(lattice, present, pull, told)
          : lattice::stretched_at_rest_corotational(lattice, present, pull, told);
  return lattice::elastic_energy(lattice, present, kinematics, q);
}

}  // namespace

std::vector<double> quasi_static_rates(const simulation::Prepared& p, const std::vector<double>& tip,
                                       const base::ProgressCallback& told) {
  const auto solving = [&](std::size_t k) -> base::ProgressCallback {
    return [&told, k, all = static_cast<double>(tip.size())](double done) {
      return !told || told((static_cast<double>(k) + done) / all);
    };
  };
  std::vector<double> rate;
  double before = energy_cut_to(p, tip.front(), solving(0));
  for (std::size_t k = 1; k < tip.size(); ++k) {
    const double now = energy_cut_to(p, tip[k], solving(k));
    rate.push_back((before - now) / (p.scale.thickness * (tip[k] - tip[k - 1]) * p.scale.tips));
    before = now;
  }
  return rate;
}

double quasi_static_ratio(const simulation::Prepared& p, const std::array<double, 2>& window,
                          const base::ProgressCallback& told) {
  const double faces = p.scale.thickness * (window[1] - window[0]) * p.scale.tips;
  const double before = energy_cut_to(p, window[0], [&](double done) { return !told || told(0.5 * done); });
  const double after =
      energy_cut_to(p, window[1], [&](double done) { return !told || told(0.5 + 0.5 * done); });
  return (before - after) / (faces * fracture::mean_g_i0(p.scale, window[0], window[1]));
}

namespace {

const char* name_of(WaveKind kind) {
  return kind == WaveKind::dilatational ? "dilatational" : kind == WaveKind::shear ? "shear" : "rayleigh";
}

/// The plate that hangs together, in the first lane's units.
lattice::Lattice free_plate(const simulation::Prepared& p, base::Cache& cache,
                            const base::ProgressCallback& told) {
  bool found = false;
  const scene::Scene& scene = p.preset.scene;
  const packing::PackingRequest request = scene::request_of(scene);
  const packing::Specimen specimen = packing::make_free_specimen(
      packing::cached_packing(request, cache, found, told), request.box, scene.specimen.contact_tolerance);
  lattice::MicroMaterial micro = p.micro;
  micro.young_modulus *= p.lane.front().units.energy;
  return lattice::make_lattice(specimen, micro, p.density);
}

}  // namespace

double SpecimenProperties::speed(WaveKind kind) const {
  for (const Wave& wave : waves)
    if (wave.kind == kind) return wave.speed;
  return std::numeric_limits<double>::quiet_NaN();
}

SpecimenProperties measure_specimen(const simulation::Prepared& p, base::Cache& cache,
                                    const simulation::StageProgress& progress, int threads) {
  const auto telling = [&](const char* stage, double from, double share) -> base::ProgressCallback {
    return [&progress, stage, from, share](double done) {
      return !progress || progress(stage, from + share * done);
    };
  };
  const scene::Scene::Material& m = p.preset.scene.material;
  const lattice::Lattice plate = free_plate(p, cache, telling("packing", 0.0, 1.0));
  SpecimenProperties found;
  found.nominal = theory::wave_speeds(m.young_modulus, m.poisson_ratio, p.density, m.plane);
  base::tell_or_stop(telling("static pulls", 0.0, 1.0), 0.0, "pulling the plate");
  lattice::FreeBody body(plate, threads);
  const calibration::Pulled along = calibration::pull(plate, body, 0, 1.0, telling("static pulls", 0.0, 0.5));
  const calibration::Pulled across =
      calibration::pull(plate, body, 1, 1.0, telling("static pulls", 0.5, 0.5));
  found.young_along = along.gauge_modulus, found.poisson_along = along.poisson_ratio.y();
  found.young_across = across.gauge_modulus, found.poisson_across = across.poisson_ratio.x();
  const theory::WaveSpeeds expected =
      theory::wave_speeds(found.young_along, found.poisson_along, p.density, theory::Plane::stress);
  const double dt = 0.5 * p.stable.critical * p.lane.front().units.time;
  found.waves = measured_waves(plate, dt, expected, threads, telling("waves", 0.0, 1.0));
  return found;
}

nlohmann::ordered_json json_of(const SpecimenProperties& found, double mean_radius) {
  nlohmann::ordered_json waves = nlohmann::ordered_json::array();
  for (const Wave& wave : found.waves)
    waves.push_back({{"kind", name_of(wave.kind)},
                     {"wavelength_m", wave.wavelength},
                     {"wavelength_over_radius", wave.wavelength / mean_radius},
                     {"speed_m_s", wave.speed}});
  return {{"measured_young_modulus_along_pa", found.young_along},
          {"measured_poisson_ratio_along", found.poisson_along},
          {"measured_young_modulus_across_pa", found.young_across},
          {"measured_poisson_ratio_across", found.poisson_across},
          {"nominal_dilatational_speed_m_s", found.nominal.dilatational},
          {"nominal_shear_speed_m_s", found.nominal.shear},
          {"nominal_rayleigh_speed_m_s", found.nominal.rayleigh},
          {"measured_dilatational_speed_m_s", found.speed(WaveKind::dilatational)},
          {"measured_shear_speed_m_s", found.speed(WaveKind::shear)},
          {"measured_rayleigh_speed_m_s", found.speed(WaveKind::rayleigh)},
          {"waves", waves}};
}

}  // namespace rift::measurement
