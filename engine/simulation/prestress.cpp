#include "engine/base/interrupted.hpp"
#include "engine/calibration/calibrate.hpp"
#include "engine/fracture/crack_path.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/packing/packing.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/own_constants.hpp"
#include "engine/simulation/prepare.hpp"
#include "engine/theory/references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rift::simulation {
namespace {

std::vector<lattice::Vector6> cached_motions(const std::string& key, std::size_t elements, base::Cache& cache,
                                             bool& from_cache,
                                             const std::function<std::vector<lattice::Vector6>()>& solve) {
  std::vector<lattice::Vector6> q(elements);
  if (const auto numbers = base::recall(cache, "statics", key); numbers && numbers->size() == 6 * elements) {
    for (std::size_t i = 0; i < elements; ++i)
      q[i] = Eigen::Map<const lattice::Vector6>(numbers->data() + 6 * i);
    return q;
  }
  from_cache = false;
  q = solve();
  base::remember(cache, "statics", key, {q.front().data(), 6 * elements});
  return q;
}

lattice::MicroMaterial reference_micro(const scene::Preset& preset, base::Cache& cache,
                                       const StageProgress& progress) {
  const scene::Scene& scene = preset.scene;
  const scene::Scene::Material& m = scene.material;
  if (m.stiffness == scene::StiffnessChoice::explicit_values)
    return {*m.micro_young_modulus, *m.micro_poisson_ratio, *m.micro_radius_ratio};
  if (m.stiffness != scene::StiffnessChoice::calibrated) return lattice::bulk_micro_material;
  try {
    return calibration::calibrate(scene, m.young_modulus, m.poisson_ratio, cache,
                                  stage(progress, "calibration"))
        .micro;
  } catch (const calibration::OutOfReach& error) {
    throw scene::InputError({scene::issue_at(preset, "material.poisson_ratio", error.what())});
  } catch (const packing::PackingError& error) {
    throw scene::InputError(
        {scene::issue_at(preset, "calibration.elements",
                         fmt::format("{}, in one of the {} cylinders of calibration.packings", error.what(),
                                     scene.calibration.packings))});
  }
}

/// Whether the beams' modulus is scaled to the specimen's own.
bool is_scaled(const scene::Scene& scene) {
  return scene.material.stiffness == scene::StiffnessChoice::in_situ ||
         scene.material.stiffness == scene::StiffnessChoice::bulk;
}

std::vector<lattice::Vector6> scaled(const std::vector<lattice::Vector6>& unit, double displacement) {
  std::vector<lattice::Vector6> q(unit);
  for (lattice::Vector6& v : q) v *= displacement;
  return q;
}

/// Solutions of the statics, each known by all that it depends on. All stiffnesses carry the same factor
/// E_mu, so E_mu is not among it and all are solved with the same one, to the same bits; the linear ones are
/// for 1 m and serve any displacement.
struct Statics {
  const lattice::Lattice lattice;
  const scene::Scene& scene;
  base::Cache& cache;
  bool& from_cache;
  std::string lattice_key;
  const StageProgress& progress;
  int expected = 1, solved = 0;  // solutions; those that the cache holds are not counted

  std::vector<lattice::Vector6> unit(const std::vector<char>& present, const std::string& notch,
                                     const lattice::Pull& pull = {1.0}) {
    return cached_motions("statics 3 of " + lattice_key + notch + key_of(pull), lattice.centre.size(), cache,
                          from_cache, [&] {
                            auto q = lattice::stretched_at_rest(lattice, present, pull, telling());
                            ++solved;
                            return q;
                          });
  }
  std::vector<lattice::Vector6> at_rest(const std::vector<char>& present, const std::string& notch,
                                        double displacement) {
    const scene::Scene::Loading& l = scene.loading;
    if (scene.solver.kinematics == lattice::Kinematics::linear)
      return scaled(unit(present, notch, {1.0, l.tilt, l.shear}), displacement);
    const lattice::Pull pull(displacement, l.tilt, l.shear);
    const std::string key = fmt::format("corotational statics 2 of {}{} by {:a}{}", lattice_key, notch,
                                        pull.middle, key_of(pull));
    return cached_motions(key, lattice.centre.size(), cache, from_cache, [&] {
      auto q = lattice::stretched_at_rest_corotational(lattice, present, pull, telling());
      ++solved;
      return q;
    });
  }
  base::ProgressCallback telling() const {
    return [this](double done) {
      const double all = std::max(expected, solved + 1);
      return !progress || progress("pre-stress", (solved + done) / all);
    };
  }
  /// What of a pull is not along y and even.
  static std::string key_of(const lattice::Pull& pull) {
    std::string key;
    if (pull.tilt != 0.0) key += fmt::format(" tilt {:a}", pull.tilt);
    if (pull.shear != 0.0) key += fmt::format(" shear {:a}", pull.shear);
    return key;
  }
};

/// The displacement under which the top grip pulls with a force [N], by secants from the linear one: a
/// lattice of any kinematics is nearly linear between grips. Throws StaticsError.
/// @param[in] lattice  with the beams' own modulus
double displacement_under(double force, Statics& statics, const lattice::Lattice& lattice,
                          const std::vector<char>& present, const std::string& notch) {
  constexpr int most = 20;
  constexpr double good = 1e-10;  // of the force
  const scene::Scene::Loading& l = statics.scene.loading;
  const double unit_force = lattice::grip_force(lattice, present, lattice::Kinematics::linear,
                                                statics.unit(present, notch, {1.0, l.tilt, l.shear}));
  if (!(unit_force > 0.0))
    throw lattice::StaticsError(l.shear != 0.0
                                    ? "with this loading.shear no displacement pulls the grip along y"
                                    : "the notch cuts the plate, and the grips have nothing to pull");
  double displacement = force / unit_force;
  const lattice::Kinematics kinematics = statics.scene.solver.kinematics;
  if (kinematics == lattice::Kinematics::linear) return displacement;
  for (int k = 0; k < most; ++k) {
    const double pull =
        lattice::grip_force(lattice, present, kinematics, statics.at_rest(present, notch, displacement));
    if (std::abs(pull - force) <= good * std::abs(force)) return displacement;
    displacement *= force / pull;
  }
  throw lattice::StaticsError(fmt::format("no displacement gives a force of {:g} N", force));
}

/// Of a central crack it is that of the specimen's own Poisson's ratio and of the height that is strained.
/// @param[in] strip  energy of the pre-stressed strip over its area [J/m2]
fracture::RateScale scale_against(const Prepared& p, double strip, base::Cache& cache,
                                  const StageProgress& progress) {
  const scene::Scene& scene = p.preset.scene;
  fracture::RateScale scale{.thickness = p.lattice.box.thickness,
                            .g_i0 = strip,
                            .length = p.lattice.box.length,
                            .tips = scene.crack.tips};
  if (scene.output.g_i0_reference == scene::ReleaseRateReference::griffith) {
    const OwnConstants own = own_constants(p, cache, stage(progress, "static pulls"));
    scale.g_i0 = 0.0;
    scale.g_i0_slope =
        theory::griffith_slope(strip, own.between_grips, own.poisson_ratio(), theory::Plane::stress);
  }
  return scale;
}

/// Which beams a notch cuts, for the key of a cached solution.
std::string notch_key(const scene::Scene& scene) {
  return fmt::format(" path {} notch {:a}{}", path_key(scene), scene.crack.start,
                     scene.crack.tips == 2 ? " from the middle" : "");
}

void make_lattice_of(Prepared& p) {
  p.lattice = lattice::make_lattice(p.specimen, p.micro, p.density);
  p.lattice.grips_turn = p.preset.scene.loading.grip_rotation == scene::GripRotation::free;
  refuse_out_of_range(p, lattice_numbers(p));
}

}  // namespace

std::string statics_key(const Prepared& p) {
  return fmt::format(
      "{} tolerance {:a}{}{} micro {:a} {:a} {:a}", packing::key_of(scene::request_of(p.preset.scene)),
      p.preset.scene.specimen.contact_tolerance, p.preset.scene.loading.traction ? " free" : "",
      p.preset.scene.loading.grip_rotation == scene::GripRotation::free ? " grips turn" : "",
      p.micro.young_modulus, p.micro.poisson_ratio, p.micro.radius_ratio);
}

std::string dynamics_key(const Prepared& p) {
  return fmt::format("{} density {:a}", statics_key(p), p.density);
}

std::string path_key(const scene::Scene& scene) {
  std::string path;
  if (scene.crack.path.point.empty())
    path = fmt::format("{:a}", scene::path_height_m(scene));
  else
    for (const auto& [x, y] : scene::path_points_m(scene)) path += fmt::format("({:a} {:a})", x, y);
  if (scene.crack.release_order != fracture::ReleaseOrder::crossing)
    path += " by " + scene::word_of("crack.release_order", scene.crack.release_order);
  return path;
}

double continuum_strip_modulus(const scene::Scene& scene) {
  const double nu = scene.material.poisson_ratio;
  return scene.material.young_modulus / (1.0 - nu * nu);
}

void build_prestress(Prepared& p, base::Cache& cache, const StageProgress& progress) {
  const scene::Scene& scene = p.preset.scene;
  const lattice::Kinematics kinematics = scene.solver.kinematics;
  p.micro = reference_micro(p.preset, cache, progress);
  base::tell_or_stop(stage(progress, "pre-stress"), 0.0, "solving the pre-stress");
  p.statics_from_cache = true;
  make_lattice_of(p);
  Statics statics{p.lattice, scene, cache, p.statics_from_cache, statics_key(p), progress};
  const bool own_pull = kinematics == lattice::Kinematics::corotational || scene.loading.tilt != 0.0 ||
                        scene.loading.shear != 0.0;  // the unit one does not serve
  statics.expected = 1 + (own_pull ? 1 : 0) + (scene.crack.start > 0.0 ? 1 : 0);
  const std::vector<char> present(p.lattice.beam.size(), 1);
  const std::vector<lattice::Vector6> unit = statics.unit(present, "");
  if (is_scaled(scene)) {
    p.micro.young_modulus *= continuum_strip_modulus(scene) / lattice::strip_modulus(p.lattice, unit, 1.0);
    make_lattice_of(p);
  }
  p.strip_modulus = lattice::strip_modulus(p.lattice, unit, 1.0);
  std::vector<char> notched(present);
  std::string notch;
  if (scene.crack.start > 0.0) notch = notch_key(scene);
  for (const fracture::Crossing& c : fracture::crossings(p.path, p.lattice))
    if (fracture::in_notch(c, scene.crack.start)) notched[c.beam] = 0;
  if (scene.loading.traction) {
    p.displacement.assign(p.lattice.centre.size(), lattice::Vector6::Zero());
    p.scale = scale_against(p, *scene.breaking.release_rate, cache, progress);
    return;
  }
  const std::optional<double> force = scene::force_at_start(scene);
  p.pulled = force ? displacement_under(*force, statics, p.lattice, notched, notch)
                   : scene::displacement_at_start(scene);
  refuse_out_of_range(p, pull_numbers(p));
  p.displacement = statics.at_rest(present, "", p.pulled);
  p.scale = scale_against(
      p, lattice::energy_per_length(p.lattice, kinematics, p.displacement) / p.lattice.box.thickness, cache,
      progress);
  if (!notch.empty()) p.displacement = statics.at_rest(notched, notch, p.pulled);
  p.grip_force = lattice::grip_force(p.lattice, notched, kinematics, p.displacement);
  p.static_energy = lattice::elastic_energy(p.lattice, notched, kinematics, p.displacement);
  refuse_out_of_range(p, prestress_numbers(p));
  if (scene.loading.method == scene::LoadingMethod::ramp)
    p.displacement.assign(p.displacement.size(), lattice::Vector6::Zero());
}

}  // namespace rift::simulation
