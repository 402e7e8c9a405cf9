#pragma once

#include "engine/base/cache.hpp"
#include "engine/packing/packing.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace rift::calibration {

/// Tasks that know nothing of each other, shared out to threads, the largest first: each is done by one
/// thread from beginning to end. The first that throws ends the rest; its exception leaves.
/// @param[in] work     of each task, in any unit
/// @param[in] threads  0 for one per available CPU
/// @param[in] task     k, the thread's number from 0, and whom to tell the fraction of the task that is done
void side_by_side(
    const std::vector<double>& work, int threads, const base::ProgressCallback& progress,
    const std::function<void(std::size_t k, int thread, const base::ProgressCallback& tell)>& task);

/// The beams of a lattice but for their modulus, to which all its moduli are proportional.
struct BeamShape {
  double radius_ratio = 0.3;   // r_mu
  double poisson_ratio = 0.3;  // nu_mu
};

/// What a cylinder shows in compression with beams of unit modulus.
struct Response {
  double young_over_micro = 0;  // E_M / E_mu, from the strain of the middle half
  double ends_over_micro = 0;   // the same from the shortening between the loaded elements
  double poisson_ratio = 0;     // from the linear fit of the radial displacements of the middle half
};

/// One packing with all the beams that are tried in it.
struct CylinderTest {
  packing::PackingRequest packing;  // in a cylinder
  double contact_tolerance = 1;
  std::vector<BeamShape> beams;
};

struct CylinderResult {
  packing::PackingRequest packing;
  double coordination = 0, core_coordination = 0;  // of all elements; of those away from the walls
  double solid_fraction = 0;
  int rattlers = 0;
  std::vector<BeamShape> beams;
  std::vector<Response> responses;  // of the beams, in their order
};

/// Presses all cylinders statically   [paper, appendix]. What the cache holds is not computed again; several
/// cylinders are pressed at once, one a thread, the largest first. Results in the order of the tests, the
/// same whatever the threads. Throws PackingError, StaticsError or Interrupted.
/// @param[in] threads  0 for one per available CPU
std::vector<CylinderResult> press_cylinders(const std::vector<CylinderTest>& tests, base::Cache& cache,
                                            const base::ProgressCallback& progress = {}, int threads = 0);

/// Mean of the coordination of the elements further than `away` from the walls [as the box]; of all elements
/// where none is.
double core_coordination(const packing::Packing& packing, const packing::Box& box,
                         const std::vector<std::array<int, 2>>& contacts, double away);

}  // namespace rift::calibration
