#include "engine/stability/free_vibration.hpp"

#include "engine/ensemble/ensemble.hpp"
#include "engine/simulation/march.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace rift::stability {
namespace {

constexpr lattice::MicroMaterial micro{10e9, 0.3, 0.5};
constexpr double density = 1000.0;

/// @param[in] reach  beams join centres nearer than this many spacings
lattice::Lattice joined(packing::Specimen s, double reach, double cut_at) {
  const int n = static_cast<int>(s.centre.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      const Eigen::Vector3d between = s.centre[j] - s.centre[i];
      if (between.norm() > reach * small_spacing) continue;
      if ((s.centre[i].y() < cut_at) != (s.centre[j].y() < cut_at)) continue;
      if (std::abs(between.z()) > 0.1 * small_spacing && between.norm() > 1.1 * small_spacing) continue;
      s.beam.push_back({i, j});
    }
  s.radius.assign(s.centre.size(), 0.5 * small_spacing);
  s.packing.mean_radius = 0.5 * small_spacing;
  return lattice::make_lattice(s, micro, density);
}

}  // namespace

lattice::Lattice small_chain(int elements) {
  packing::Specimen s;
  s.box = {.length = elements * small_spacing, .height = small_spacing, .thickness = small_spacing};
  for (int k = 0; k < elements; ++k)
    s.centre.emplace_back((k + 0.5) * small_spacing, 0.5 * small_spacing, 0.5 * small_spacing);
  s.grip.assign(s.centre.size(), packing::Grip::none);
  s.grip.front() = packing::Grip::bottom;
  return joined(std::move(s), 1.1, -1.0);
}

lattice::Lattice small_block(int nx, int ny, int nz, bool cut) {
  packing::Specimen s;
  s.box = {.length = nx * small_spacing, .height = ny * small_spacing, .thickness = nz * small_spacing};
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z) {
        s.centre.emplace_back((x + 0.5) * small_spacing, (y + 0.5) * small_spacing,
                              (z + 0.5) * small_spacing);
        s.grip.push_back(y == 0        ? packing::Grip::bottom
                         : y == ny - 1 ? packing::Grip::top
                                       : packing::Grip::none);
      }
  const int rows_below_the_cut = ny / 2;
  return joined(std::move(s), 1.5, cut ? rows_below_the_cut * small_spacing : -1.0);
}

namespace {

using Eigen::VectorXd;

constexpr double far = 1e6;  // grown or shrunk

std::vector<lattice::Vector6> by_element(const VectorXd& q) {
  std::vector<lattice::Vector6> motion(static_cast<std::size_t>(q.size() / 6));
  for (std::size_t i = 0; i < motion.size(); ++i) motion[i] = q.segment<6>(6 * static_cast<long>(i));
  return motion;
}

/// An ensemble of one lane that nothing damages, at rest and moved out of its equilibrium.
ensemble::Ensemble released(const lattice::Lattice& lattice, const VectorXd& from, double dt, double beta,
                            ensemble::Precision precision) {
  ensemble::Ensemble s(lattice, {}, dt, {fracture::LaneScenario{}}, {.precision = precision});
  s.release_from(by_element(from));
  s.set_beta(beta);
  return s;
}

double larger(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

/// Position (times omega) and speed of a mode, from those of all elements.
struct ModalState {
  const lattice::Lattice& lattice;
  const lattice::HighestMode& mode;

  Eigen::Vector2d of(ensemble::Ensemble& s) const {
    Eigen::Vector2d state = Eigen::Vector2d::Zero();
    for (int i = 0; i < static_cast<int>(lattice.mass.size()); ++i) {
      lattice::Vector6 weight = mode.shape.segment<6>(6L * i);
      weight.head<3>() *= lattice.mass[i], weight.tail<3>() *= lattice.inertia[i];
      state += Eigen::Vector2d(mode.omega * weight.dot(s.motion(i, 0)), weight.dot(s.velocity(i, 0)));
    }
    return state;
  }
};

Observed vibrate_in(const lattice::Lattice& lattice, const lattice::HighestMode& mode, double dt, double beta,
                    std::int64_t steps, ensemble::Precision precision) {
  ensemble::Ensemble s =
      released(lattice, mode.shape * (1e-6 / mode.shape.cwiseAbs().maxCoeff()), dt, beta, precision);
  const ModalState modal{lattice, mode};
  Eigen::Vector2d before = modal.of(s);
  const double start = before.norm();
  Eigen::Matrix2d products = Eigen::Matrix2d::Zero(), squares = Eigen::Matrix2d::Zero();
  Observed seen;
  seen.residual = 0.0;
  for (; seen.steps < steps && before.norm() < far * start && before.norm() > start / far; ++seen.steps) {
    s.step();
    const Eigen::Vector2d after = modal.of(s);
    products += after * before.transpose() / before.squaredNorm();
    squares += before * before.transpose() / before.squaredNorm();
    before = after;
    if (seen.steps % 16 == 0) seen.residual = larger(seen.residual, std::abs(s.balance(0).error));
  }
  const Eigen::Matrix2d step = products * squares.inverse();
  const lattice::ModeStep measured{0.5 * step.trace(), step.determinant()};
  seen.growth = measured.growth();
  const bool single = precision == ensemble::Precision::single_precision;
  seen.claims.push_back(claim_near("turn of the mode in a step [rad]", measured.turn(),
                                   lattice::step_of_mode(mode.omega * dt, beta).turn(),
                                   single ? 1e-3 : 1e-6));
  return seen;
}

}  // namespace

Observed vibrate(const lattice::Lattice& lattice, const lattice::HighestMode& mode, double dt, double beta,
                 std::int64_t steps, ensemble::Precision precision) {
  Observed seen = vibrate_in(lattice, mode, dt, beta, steps, precision);
  seen.limit = simulation::ledger_limit(lattice::Kinematics::linear, precision);
  const double rounding =
      growth_tolerance * (precision == ensemble::Precision::double_precision ? 1.0 : 10.0);
  if (seen.growth > rounding)
    seen.residual = std::numeric_limits<double>::quiet_NaN();  // of nothing that is kept
  seen.ending = seen.growth > rounding        ? CaseEnd::diverges
                : seen.residual <= seen.limit ? CaseEnd::closes
                                              : CaseEnd::open;
  return seen;
}

Observed vibrate_freely(const lattice::Lattice& lattice, double dt, std::int64_t steps,
                        ensemble::Precision precision) {
  std::mt19937_64 random(7);
  VectorXd q = lattice::root_mobility(lattice);
  for (double& x : q) x *= static_cast<double>(random() >> 11) * 0x1.0p-53 - 0.5;
  q *= 1e-6 / q.cwiseAbs().maxCoeff();
  Observed seen;
  seen.limit = simulation::ledger_limit(lattice::Kinematics::linear, precision);
  ensemble::Ensemble s = released(lattice, q, dt, 1.0, precision);
  seen.residual = 0.0;
  double kinetic = 0.0;
  int looks = 0;
  for (; seen.steps < steps; ++seen.steps) {
    s.step();
    if (seen.steps % std::max<std::int64_t>(steps / 100, 1) != 0) continue;
    const fracture::EnergyBalance now = s.balance(0);
    seen.residual = larger(seen.residual, std::abs(now.error));
    const double moving = now.kinetic_translation + now.kinetic_rotation;
    kinetic += moving / (moving + now.elastic - now.step_correction), ++looks;
  }
  // A hundred looks at cos^2 of one mode's phase, the fewest there can be, are known to 0.035.
  seen.claims.push_back(claim_near("kinetic share of K + U - C in the mean", kinetic / looks, 0.5, 0.1));
  seen.ending = seen.residual <= seen.limit ? CaseEnd::closes : CaseEnd::open;
  return seen;
}

}  // namespace rift::stability
