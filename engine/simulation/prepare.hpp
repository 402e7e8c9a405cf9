#pragma once

#include "engine/base/cache.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/fracture/crack_path.hpp"
#include "engine/fracture/release.hpp"
#include "engine/fracture/release_rate.hpp"
#include "engine/lattice/gauge.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/lane.hpp"
#include "engine/simulation/schedule.hpp"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rift::simulation {

/// Told what is being done and the fraction of it done; answers false to stop (Interrupted is thrown then).
using StageProgress = std::function<bool(std::string_view stage, double done)>;

/// What tells of one stage; `progress` must outlive it.
inline base::ProgressCallback stage(const StageProgress& progress, const char* name) {
  return [&progress, name](double done) { return !progress || progress(name, done); };
}

/// The specimen cannot be made: none of its scenarios can run.
struct SpecimenRefused : scene::InputError {
  explicit SpecimenRefused(scene::Issue issue) : InputError({std::move(issue)}) {}
};

/// Some of the lanes cannot run; without them the others can.
struct LanesRefused : scene::InputError {
  using Issues = std::map<std::size_t, std::vector<scene::Issue>>;  // by lane
  explicit LanesRefused(Issues found);
  Issues of;
};

/// One scenario of a run: what it releases, and when it is looked at, in the lattice's time.
struct LanePlan {
  scene::Scene scene;
  LaneUnits units;
  fracture::LaneScenario scenario;
  double lead = 0;                 // [s] from the start of the crack to a measured history's first row
  double crack_end = 0;            // tip position [m]
  std::array<double, 2> window{};  // tip positions [m]
  double strength_wished = 0;      // of beams that break by themselves, before the lattice's limit [Pa]
  TimeStep step;                   // its own, whatever marches beside it
  std::size_t beams_damped = 0;    // by itself
  Schedule schedule;               // in steps of the run
};

/// All that a run needs before its first step; what a dry run looks at. Its lanes share lattice, pre-stress,
/// path and step.
struct Prepared {
  scene::Preset preset;
  double density = 0, rayleigh_speed = 0;  // [kg/m3], [m/s]
  packing::Specimen specimen;
  lattice::MicroMaterial micro;  // of the lattice: scaled in situ, whose units serve "bulk" too, or explicit
  lattice::Lattice lattice;
  double strip_modulus = 0;   // of this specimen with these beams, by linear kinematics [Pa]
  double pulled = 0;          // displacement of the top grip as the crack starts [m]
  double grip_force = 0;      // with which it pulls along y then [N], of the lattice
  double static_energy = 0;   // of the plate at rest, notch cut, pulled [J]
  fracture::RateScale scale;  // b, G_I0, L, tips
  std::vector<lattice::Vector6>
      displacement;  // at the start of the run: at rest and pulled, or none for a ramp
  fracture::CrackPath path;
  /// N forces and moments of opposite tractions of 1 Pa on top and bottom; none where grips hold the plate.
  std::vector<lattice::Vector6> outside;
  std::vector<int> rollers;  // elements that roll on the left or the right face
  std::vector<lattice::Gauge> gauge;
  std::vector<LanePlan> lane;
  std::vector<lattice::DampedBeam> damped;  // those that any lane damps
  lattice::StableStep stable;               // of the lattice without damping
  TimeStep step;                            // the smallest that a lane asks for
  bool packing_from_cache = false, statics_from_cache = false;
  double wall_packing_s = 0, wall_prestress_s = 0;
};

/// The same for two scenes of one specimen, and for no others.
std::string specimen_key(const scene::Scene& scene);

/// Specimen (packing cached), lattice, pre-stress (cached), crack, step and schedule of a preset without
/// issues. Throws InputError where the lattice cannot be what the preset asks for (SpecimenRefused,
/// LanesRefused or another), Interrupted where progress says stop.
Prepared prepare(const scene::Preset& preset, base::Cache& cache, const StageProgress& progress = {});

/// The same for scenarios other than the preset's own, one lane each; they differ in what lanes may differ
/// in, or by being in-situ and bulk.
Prepared prepare(const scene::Preset& preset, const std::vector<scene::Scene>& lanes, base::Cache& cache,
                 const StageProgress& progress = {});

/// Goes on with other lanes over the same lattice and pre-stress, such as some of its own: damped beams, step
/// and schedules are theirs again. Cheap: the step that each asks for is in its plan. Throws InputError where
/// that takes too many steps.
void take_lanes(Prepared& prepared, std::vector<LanePlan> lanes);

// The pre-stress (prestress.cpp).

/// Micro modulus, pre-stress and G_I0. The modulus and G_I0 belong to the strip without its notch; the
/// modulus is that of small strains with either kinematics.
/// Asks for the specimen, the density and the path. Throws InputError where no beams fit the material,
/// StaticsError.
void build_prestress(Prepared& p, base::Cache& cache, const StageProgress& progress);

/// Names all that the lattice's stiffnesses depend on, and that with its masses; what of a scene makes the
/// path of its crack. Parts of the keys under which what follows from them is cached.
std::string statics_key(const Prepared& prepared);
std::string dynamics_key(const Prepared& prepared);
std::string path_key(const scene::Scene& scene);

/// What the clamped strip of a continuum with the preset's E and nu would show [Pa].
double continuum_strip_modulus(const scene::Scene& scene);

/// Beams whose damping can matter to any of the lanes: none, those near the path, or all.
std::vector<lattice::DampedBeam> damped_beams(const Prepared& prepared, std::span<const LanePlan> lanes);

/// What of a scene makes a lane's scenario, in the lattice's units: the law of its release, its damping, a
/// speed.
fracture::ReleaseLaw release_law(const scene::Scene& scene, const lattice::Lattice& lattice);
void set_damping(fracture::LaneScenario& scenario, const scene::Scene& scene);
/// The law of beams that break by themselves, with the strength that the lattice resolves.
fracture::CohesiveMaterial breaking_material(const Prepared& prepared, const scene::Scene& scene,
                                             const LaneUnits& units);
double lattice_speed(const Prepared& prepared, const scene::Speed& speed, const LaneUnits& units);

/// The largest stable step [s] where the beams are damped as much as any of the lanes damps them.
double damped_limit(const Prepared& prepared, std::vector<lattice::DampedBeam> damped,
                    std::span<const LanePlan> lanes, const base::ProgressCallback& told = {});

/// What a lane's release rate is measured against, in its own units.
fracture::RateScale scale_of(const Prepared& prepared, const LanePlan& lane);

/// Speed of the waves in a lane's plate over that of the material's: 1 in situ, sqrt(E_mu / in-situ E_mu)
/// else.
double wave_speed_ratio(const Prepared& prepared, const LanePlan& lane);

// What follows from a scene with its lattice, and the numbers that it may be; asked for as soon as each is
// known, before anything is computed with it.

/// The key by which the preset says how the plate is loaded.
const char* load_key(const scene::Scene& scene);

/// Throws InputError with all that are out of their ranges.
void refuse_out_of_range(const Prepared& p, const std::vector<scene::DerivedNumber>& numbers);

/// Masses, inertias and stiffnesses of the lattice, the least and the greatest of each: such that neither
/// they nor their reciprocals leave what the precision of the run holds.
std::vector<scene::DerivedNumber> lattice_numbers(const Prepared& p);

/// The strain that the grip's displacement makes, where it follows from a force or a curve.
std::vector<scene::DerivedNumber> pull_numbers(const Prepared& p);

/// G_I0, the energy stored and the grip's force, whatever their signs.
std::vector<scene::DerivedNumber> prestress_numbers(const Prepared& p);

std::vector<scene::DerivedNumber> critical_step_numbers(const Prepared& p);

/// The step, and how many of them each lane takes.
std::vector<scene::DerivedNumber> step_numbers(const Prepared& p);

}  // namespace rift::simulation
