#include "engine/measurement/specimen_properties.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/statics.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>

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

constexpr std::size_t numbers_of_wave = 4;

/// Waves as the cache keeps them.
std::vector<double> numbers_of(const std::vector<Wave>& waves) {
  std::vector<double> numbers;
  for (const Wave& w : waves)
    numbers.insert(numbers.end(), {static_cast<double>(w.kind), w.wavelength, w.speed, w.misfit});
  return numbers;
}

std::vector<Wave> waves_of(const std::vector<double>& numbers) {
  std::vector<Wave> waves;
  for (std::size_t k = 0; k + numbers_of_wave <= numbers.size(); k += numbers_of_wave)
    waves.push_back({static_cast<WaveKind>(static_cast<int>(numbers[k])), numbers[k + 1], numbers[k + 2],
                     numbers[k + 3]});
  return waves;
}

/// The waves of the first lane's plate, whose pulls promise `own`.
std::vector<Wave> cached_waves(const simulation::Prepared& p, const theory::WaveSpeeds& own,
                               base::Cache& cache, const simulation::StageProgress& progress, int threads) {
  lattice::MicroMaterial micro = p.micro;
  micro.young_modulus *= p.lane.front().units.energy;
  const std::string key =
      fmt::format("waves 1 of {} beams {:a}", simulation::dynamics_key(p), micro.young_modulus);
  if (const auto known = base::recall(cache, "constants", key)) return waves_of(*known);
  const lattice::Lattice plate =
      simulation::free_plate(p, micro, cache, simulation::stage(progress, "packing"));
  const double dt = 0.5 * p.stable.critical * p.lane.front().units.time;
  std::vector<Wave> waves = measured_waves(plate, dt, own, threads, simulation::stage(progress, "waves"));
  base::remember(cache, "constants", key, numbers_of(waves));
  return waves;
}

}  // namespace

double SpecimenProperties::speed(WaveKind kind) const {
  for (const Wave& wave : waves)
    if (wave.kind == kind) return wave.speed;
  return std::numeric_limits<double>::quiet_NaN();
}

simulation::OwnConstants pulled_constants(const simulation::Prepared& p, const simulation::LanePlan& lane,
                                          base::Cache& cache, const base::ProgressCallback& told,
                                          int threads) {
  simulation::OwnConstants own = simulation::own_constants(p, cache, told, threads);
  own.young_along *= lane.units.energy, own.young_across *= lane.units.energy;
  return own;
}

std::optional<simulation::OwnConstants> known_constants(const simulation::Prepared& p,
                                                        const simulation::LanePlan& lane,
                                                        base::Cache& cache) {
  std::optional<simulation::OwnConstants> own = simulation::known_constants(p, cache);
  if (own) own->young_along *= lane.units.energy, own->young_across *= lane.units.energy;
  return own;
}

SpecimenProperties measure_specimen(const simulation::Prepared& p, base::Cache& cache,
                                    const simulation::StageProgress& progress, int threads) {
  const scene::Scene::Material& m = p.preset.scene.material;
  SpecimenProperties found;
  found.nominal = theory::wave_speeds(m.young_modulus, m.poisson_ratio, p.density, m.plane);
  found.pulled =
      pulled_constants(p, p.lane.front(), cache, simulation::stage(progress, "static pulls"), threads);
  found.own = theory::wave_speeds(found.pulled.young_modulus(), found.pulled.poisson_ratio(), p.density,
                                  theory::Plane::stress);
  found.waves = cached_waves(p, found.own, cache, progress, threads);
  return found;
}

nlohmann::ordered_json json_of(const SpecimenProperties& found, double mean_radius) {
  nlohmann::ordered_json waves = nlohmann::ordered_json::array();
  for (const Wave& wave : found.waves)
    waves.push_back({{"kind", name_of(wave.kind)},
                     {"wavelength_m", wave.wavelength},
                     {"wavelength_over_radius", wave.wavelength / mean_radius},
                     {"speed_m_s", wave.speed}});
  return {{"measured_young_modulus_along_pa", found.pulled.young_along},
          {"measured_poisson_ratio_along", found.pulled.poisson_along},
          {"measured_young_modulus_across_pa", found.pulled.young_across},
          {"measured_poisson_ratio_across", found.pulled.poisson_across},
          {"between_grips_m", found.pulled.between_grips},
          {"own_dilatational_speed_m_s", found.own.dilatational},
          {"own_shear_speed_m_s", found.own.shear},
          {"own_rayleigh_speed_m_s", found.own.rayleigh},
          {"nominal_dilatational_speed_m_s", found.nominal.dilatational},
          {"nominal_shear_speed_m_s", found.nominal.shear},
          {"nominal_rayleigh_speed_m_s", found.nominal.rayleigh},
          {"measured_dilatational_speed_m_s", found.speed(WaveKind::dilatational)},
          {"measured_shear_speed_m_s", found.speed(WaveKind::shear)},
          {"measured_rayleigh_speed_m_s", found.speed(WaveKind::rayleigh)},
          {"waves", waves}};
}

}  // namespace rift::measurement
