#pragma once

#include "engine/ensemble/ensemble.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace rift::ensemble {

/// An ensemble whose beams prescribed tips release along a path, with the tips at hand.
struct CrackedEnsemble : Ensemble {
  CrackedEnsemble(const lattice::Lattice& lattice, const fracture::CrackPath& path, double notch_end,
                  double dt, const std::vector<fracture::LaneScenario>& scenarios,
                  const EnsembleOptions& options = {})
      : CrackedEnsemble(lattice, path, notch_end, dt, scenarios, options,
                        std::make_shared<PrescribedTips>(dt)) {}

  double tip(int lane) const { return tips->tip(lane); }
  Eigen::Vector3d normal(int k) const {
    return {damageable()[k].normal.x(), damageable()[k].normal.y(), 0.0};
  }

  std::shared_ptr<PrescribedTips> tips;

 private:
  CrackedEnsemble(const lattice::Lattice& lattice, const fracture::CrackPath& path, double notch_end,
                  double dt, const std::vector<fracture::LaneScenario>& scenarios,
                  const EnsembleOptions& options, std::shared_ptr<PrescribedTips> rule)
      : Ensemble(lattice, fracture::damageable_beams(path, lattice, notch_end), dt, scenarios, options, rule),
        tips(std::move(rule)) {}
};

}  // namespace rift::ensemble
