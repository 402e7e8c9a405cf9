#include "tests/engine/simulation/small_plate.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  if (void* p = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)) return p;
  throw std::bad_alloc();
}

}  // namespace

// All of this program's memory comes from here. GCC 12 does not see that the two sides belong together.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new[](std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace rift::ensemble {
namespace {

long allocations_in_steps(const simulation::Prepared& p, lattice::Kinematics kinematics, Precision precision,
                          int scenarios) {
  std::vector<fracture::LaneScenario> lanes = simulation::four_laws(p);
  lanes.resize(scenarios);
  Ensemble s = simulation::ready(p, lanes, p.step.dt,
                                 {.kinematics = kinematics, .precision = precision, .threads = 2});
  s.set_beta(0.95);
  s.set_grip_speed(1.0);
  const long before = allocations;
  for (int n = 0; n < 150; ++n) s.step();
  const long during = allocations - before;
  EXPECT_GT(s.fracture_energy(10, 0), 0.0);  // beams were released meanwhile
  return during;
}

TEST(Step, AllocatesNothing) {
  const simulation::Prepared p = simulation::small_plate({"damping.alpha=0.001", "damping.region=all"});
  for (const lattice::Kinematics kinematics :
       {lattice::Kinematics::linear, lattice::Kinematics::corotational})
    for (const Precision precision : {Precision::double_precision, Precision::single_precision})
      for (const int scenarios : {1, 4})
        EXPECT_EQ(allocations_in_steps(p, kinematics, precision, scenarios), 0);
  const long before = allocations;
  const std::vector<double> one(3, 0.0);
  EXPECT_EQ(allocations - before, 1);  // the guard is awake
  EXPECT_EQ(one.size(), 3U);
}

}  // namespace
}  // namespace rift::ensemble
