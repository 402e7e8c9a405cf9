#include "engine/packing/sphere_packing.hpp"

#include "engine/packing/pair_kernels.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rift::packing {
namespace {

using Sphere = SpherePacking::Sphere;
using Vector = SpherePacking::Vector;

std::vector<Sphere> at_random(const Box& box, int count, unsigned seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  std::vector<Sphere> spheres;
  for (int k = 0; k < count; ++k) {
    const double x = box.length * uniform(), y = box.height * uniform(), z = box.thickness * uniform();
    spheres.push_back({x, y, z, 0.8 + 0.4 * uniform()});
  }
  return spheres;
}

struct Expected {
  std::vector<Vector> force;
  std::int64_t half_contacts = 0;
  double contact_force = 0;
};

/// Over all pairs there are.
template <bool periodic>
Expected by_all_pairs(const SpherePacking& spheres) {
  Expected expected;
  for (const Sphere& s : spheres.sphere) {
    const Eigen::Vector3d push = wall_push(spheres.box, {s.x, s.y, s.z}, spheres.scale * s.shape);
    expected.force.push_back({push.x(), push.y(), push.z()});
  }
  for (int i = 0; i < spheres.size(); ++i)
    for (int j = i + 1; j < spheres.size(); ++j) {
      const Vector d = minimum_image<periodic>(spheres.box, spheres.sphere[i], spheres.sphere[j]);
      const double distance = std::hypot(d.x, d.y, d.z),
                   overlap = spheres.scale * (spheres.sphere[i].shape + spheres.sphere[j].shape) - distance;
      if (overlap <= 0.0) continue;
      Vector &f = expected.force[i], &g = expected.force[j];
      const double push = overlap / distance;
      f.x -= push * d.x, f.y -= push * d.y, f.z -= push * d.z;
      g.x += push * d.x, g.y += push * d.y, g.z += push * d.z;
      expected.half_contacts += 2, expected.contact_force += 2.0 * overlap;
    }
  return expected;
}

void expect_forces(const SpherePacking& spheres, const Expected& expected) {
  EXPECT_EQ(spheres.sums.half_contacts, expected.half_contacts);
  EXPECT_NEAR(spheres.sums.contact_force / expected.contact_force, 1.0, 1e-13);
  for (int i = 0; i < spheres.size(); ++i) {
    const Vector &f = spheres.force[i], &e = expected.force[i];
    EXPECT_NEAR(std::hypot(f.x - e.x, f.y - e.y, f.z - e.z), 0.0, 1e-13) << i;  // of some ten contacts
  }
}

// Plates have one layer of cells, blocks several; 700 spheres are three chunks.
TEST(SpherePacking, PushesAsAllPairsTogetherDo) {
  for (const Box& box : {Box{60.0, 12.0, 4.0, Shape::plate}, Box{14.0, 14.0, 14.0, Shape::block},
                         Box{14.0, 15.0, 14.0, Shape::cylinder}}) {
    SpherePacking spheres = make_sphere_packing(box, 0.9, at_random(box, 700, 11));
    base::ThreadPool pool(0, spheres.chunks());
    for (const double scale : {0.9, 0.95, 1.0}) {
      spheres.scale = scale;
      evaluate_forces(spheres, pool);
      expect_forces(spheres, by_all_pairs<false>(spheres));
    }
  }
}

TEST(SpherePacking, PushesThroughTheFacesOfAPeriodicBox) {
  const Box box{14.0, 15.0, 16.0, Shape::periodic};
  SpherePacking spheres = make_sphere_packing(box, 0.9, at_random(box, 700, 12));
  base::ThreadPool pool(0, spheres.chunks());
  evaluate_forces(spheres, pool);
  expect_forces(spheres, by_all_pairs<true>(spheres));
}

// A pair stands once where both ends are in the chunk, and in both chunks else.
TEST(SpherePacking, ListsEachPairForTheElementsThatItPushes) {
  const Box box{60.0, 12.0, 4.0, Shape::plate};
  SpherePacking spheres = make_sphere_packing(box, 0.9, at_random(box, 700, 13));
  base::ThreadPool pool(1, 1);
  evaluate_forces(spheres, pool);
  std::vector<std::array<int, 2>> listed, expected;
  for (const SpherePacking::Chunk& chunk : spheres.chunk) {
    EXPECT_TRUE(std::is_sorted(chunk.candidate.begin(), chunk.candidate.end(),
                               [](const auto& a, const auto& b) { return a.i < b.i; }));
    for (const auto& [i, j] : chunk.candidate) listed.push_back({i, j});
  }
  for (const SpherePacking::Chunk& chunk : spheres.chunk)
    for (int i = chunk.begin; i < chunk.end; ++i)
      for (int j = 0; j < spheres.size(); ++j) {
        const Sphere &s = spheres.sphere[i], &o = spheres.sphere[j];
        const bool near =
            std::hypot(o.x - s.x, o.y - s.y, o.z - s.z) <= spheres.scale * (s.shape + o.shape) + spheres.skin;
        if (near && (chunk.owns(j) ? j > i : true)) expected.push_back({i, j});
      }
  std::sort(listed.begin(), listed.end());
  EXPECT_EQ(listed, expected);
}

/// Of the size that is needed, with some numbers.
void fill(PairGroup::Of<double>& numbers, std::mt19937_64& engine, double low, double high) {
  for (double& x : numbers) x = low + (high - low) * static_cast<double>(engine() >> 11) * 0x1.0p-53;
}

// The test is compiled for the least instruction set, the kernels' clone that runs for the best.
TEST(PairKernels, GiveTheBitsOfPlainArithmetic) {
  std::mt19937_64 engine(14);
  PairGroup pairs;
  ContactGroup contacts;
  for (auto* numbers : {&pairs.x, &pairs.y, &pairs.z, &contacts.x, &contacts.y, &contacts.z})
    fill(*numbers, engine, -1.0, 1.0);
  fill(pairs.reach, engine, 0.5, 1.5);
  fill(contacts.reach, engine, 1.5, 2.5);
  fill(contacts.squared, engine, 0.0, 2.0);
  contacts.squared[7] = 0.0;  // two centres at one place
  const ContactGroup before = contacts;
  constexpr int count = 251;
  find_gaps(pairs, count);
  find_forces(contacts, count);
  for (int k = 0; k < count; ++k) {
    const double squared = pairs.x[k] * pairs.x[k] + pairs.y[k] * pairs.y[k] + pairs.z[k] * pairs.z[k];
    EXPECT_EQ(pairs.squared[k], squared);
    EXPECT_EQ(pairs.gap[k], squared - pairs.reach[k] * pairs.reach[k]);
    const double distance = std::sqrt(std::max(before.squared[k], std::numeric_limits<double>::min()));
    const double overlap = before.reach[k] - distance, push = overlap / distance;
    EXPECT_EQ(contacts.overlap[k], overlap);
    EXPECT_EQ(contacts.x[k], before.x[k] * push);
    EXPECT_EQ(contacts.y[k], before.y[k] * push);
    EXPECT_EQ(contacts.z[k], before.z[k] * push);
  }
}

}  // namespace
}  // namespace rift::packing
