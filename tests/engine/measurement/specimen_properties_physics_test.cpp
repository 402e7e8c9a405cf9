#include "engine/measurement/specimen_properties.hpp"
#include "tests/expectations.hpp"
#include "tests/shared_cache.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rift::measurement {
namespace {

/// A piece of the paper's plate, in which waves know nothing of what was fitted: the beams are scaled to the
/// clamped strip's modulus alone.
TEST(SpecimenProperties, OfAPlateAreConsistentWithElasticity) {
  scene::Preset preset = scene::read_preset_text(R"(
[specimen]
length = "100 mm"
height = "40 mm"
elements = 10000
[crack]
velocity = "0.5 c_r"
)",
                                                 "x.toml");
  ASSERT_TRUE(preset.issues.empty());
  const simulation::Prepared plate = simulation::prepare(preset, shared_cache());
  const SpecimenProperties own = measure_specimen(plate, shared_cache());
  EXPECT_NEAR(own.pulled.young_along / own.pulled.young_across, 1.0, 0.08);
  EXPECT_NEAR(own.pulled.young_along, 10e9, 0.8e9);
  const theory::WaveSpeeds expected =
      theory::wave_speeds(own.pulled.young_across, own.pulled.poisson_across, plate.density, theory::Plane::stress);
  EXPECT_NEAR(own.speed(WaveKind::dilatational) / expected.dilatational, 1.0, 0.04);
  EXPECT_NEAR(own.speed(WaveKind::shear) / expected.shear, 1.0, 0.04);
  EXPECT_NEAR(own.speed(WaveKind::rayleigh) / expected.rayleigh, 1.0,
              0.06);  // of a wave of 50 radii
  for (const Wave& wave : not_empty(own.waves))
    EXPECT_LE(wave.misfit, 0.1);  // short ones are scattered, and left out
  // The shortest wave is slower: its depth is that of a few elements, and the edge's have lost contacts.
  const auto shortest = std::find_if(own.waves.rbegin(), own.waves.rend(),
                                     [](const Wave& wave) { return wave.kind == WaveKind::rayleigh; });
  EXPECT_LT(shortest->speed, 0.98 * own.speed(WaveKind::rayleigh));
}

}  // namespace
}  // namespace rift::measurement
