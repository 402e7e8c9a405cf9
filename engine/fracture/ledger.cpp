#include "engine/fracture/ledger.hpp"

#include <algorithm>

namespace rift::fracture {

double residual_of(const Ledger& ledger, const LatticeEnergy& energy) {
  const double lost = ledger.fracture + ledger.damping + ledger.numerical_damping + ledger.contact;
  const double missing = energy.total() - ledger.energy_start - ledger.work_external + lost;
  if (missing == 0.0) return 0.0;  // books just opened on an unloaded lattice
  return missing / ledger.largest;
}

results::Sample balance(Ledger& ledger, const LatticeEnergy& energy) {
  ledger.largest = std::max(ledger.largest, energy.total());
  results::Sample sample;
  sample.elastic_j = energy.elastic;
  sample.kinetic_translation_j = energy.kinetic_translation;
  sample.kinetic_rotation_j = energy.kinetic_rotation;
  sample.step_correction_j = energy.step_correction;
  sample.fracture_j = ledger.fracture;
  sample.damping_j = ledger.damping;
  sample.numerical_damping_j = ledger.numerical_damping;
  sample.contact_j = ledger.contact;
  sample.work_external_j = ledger.work_external;
  sample.residual = residual_of(ledger, energy);
  return sample;
}

}  // namespace rift::fracture
