#include "engine/lattice/free_body.hpp"

#include <numeric>

namespace rift::lattice {
namespace {

StaticSystem tied(const Lattice& lattice) {
  std::vector<int> number(lattice.centre.size());
  std::iota(number.begin(), number.end(), 0);
  StaticSystem system = assemble(lattice, std::move(number), std::vector<char>(lattice.beam.size(), 1),
                                 [&](int b) { return stiffness_of(lattice.beam[b]); });
  const int unknowns =
      lattice.box.shape == packing::Shape::periodic ? 3 : 6;  // a lattice that repeats cannot turn
  for (int c = 0; c < unknowns; ++c) system.k.coeffRef(c, c) *= 2.0;
  return system;
}

}  // namespace

FreeBody::FreeBody(const Lattice& lattice) : system_(tied(lattice)), solver_(system_) {}

std::vector<Vector6> FreeBody::at_rest(const std::vector<Vector6>& load, double tolerance,
                                       const base::FractionTold& told) {
  return motions_in(system_, solver_.solve(loads_on(system_, load), tolerance, told));
}

}  // namespace rift::lattice
