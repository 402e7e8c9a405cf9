#include "engine/lattice/gauge.hpp"

#include "engine/scene/issue.hpp"
#include "tests/engine/lattice/hand_made.hpp"
#include "tests/engine/simulation/small_plate.hpp"

namespace rift::simulation {
namespace {

std::vector<Eigen::Vector2d> scattered(int count) {
  lattice::hand_made::Draw draw(3);
  std::vector<Eigen::Vector2d> at;
  for (int i = 0; i < count; ++i) {
    const double x = draw.between(0, 1), y = draw.between(0, 1);
    at.emplace_back(x, y);
  }
  return at;
}

TEST(LocalPlane, ReadsALinearFieldExactly) {
  const auto at = scattered(200);
  const Eigen::Vector2d middle(0.4, 0.55);
  const auto plane = lattice::local_plane(at, middle, 0.25);
  ASSERT_TRUE(plane);
  EXPECT_LT(plane->point.size(), at.size());
  const lattice::PlaneMotion m = lattice::motion_in(*plane, [&](int i) -> Eigen::Vector3d {
    return {1.0 + 2.0 * at[i].x() - 3.0 * at[i].y(), 5.0 * at[i].x() + 7.0 * at[i].y(), -1.0};
  });
  EXPECT_NEAR(m.u.x(), 1.0 + 2.0 * 0.4 - 3.0 * 0.55, 1e-13);
  EXPECT_NEAR(m.u.z(), -1.0, 1e-13);
  EXPECT_NEAR(m.strain_xx(), 2.0, 1e-12);
  EXPECT_NEAR(m.strain_yy(), 7.0, 1e-12);
  EXPECT_NEAR(m.strain_xy(), 1.0, 1e-12);
}

TEST(LocalPlane, RefusesTooFewPointsAndALineOfThem) {
  EXPECT_FALSE(lattice::local_plane(scattered(200), {0.4, 0.5}, 0.02));
  std::vector<Eigen::Vector2d> line;
  for (int i = 0; i < 50; ++i) line.emplace_back(0.02 * i, 0.5 + 1e-4 * (i % 2));
  EXPECT_FALSE(lattice::local_plane(line, {0.5, 0.5}, 0.3));
}

// Far ahead of the crack a pulled strip strains along y alone, from the first row on; and the grip's force is
// that of the energy it has put in.
TEST(Gauges, ShowTheStrainOfThePulledPlate) {
  Prepared p =
      small_plate({"output.gauges=[[\"36 mm\", \"9 mm\"], [\"36 mm\", \"3 mm\"]]", "output.gauge_length=8"});
  ASSERT_EQ(p.gauge.size(), 2U);
  std::vector<results::GaugeRow> rows;
  std::vector<results::Sample> samples;
  Observer observer{.sample = [&](const results::Sample& s) { samples.push_back(s); },
                    .gauge = [&](const results::GaugeRow& row) { rows.push_back(row); }};
  march(p, observer);
  ASSERT_EQ(rows.size(), 2 * samples.size());
  EXPECT_EQ(rows[0].gauge, 0);
  EXPECT_EQ(rows[1].gauge, 1);
  EXPECT_EQ(rows[3].step, samples[1].step);
  EXPECT_EQ(rows[3].time_s, samples[1].time_s);
  // Two gauges one above the other: their mean strain is what the displacement between their middles says.
  const double between = (rows[0].uy_m - rows[1].uy_m) / 6e-3;
  // Some 16 elements of a random packing lie under each: single gauges scatter by a tenth.
  EXPECT_NEAR(0.5 * (rows[0].strain_yy + rows[1].strain_yy), between, 0.15 * between);
  EXPECT_GT(between, 0.05);  // the gripped elements do not strain: more is left for the others
  EXPECT_NEAR(rows[0].uy_m + rows[1].uy_m, 0.6e-3, 0.03e-3);
  EXPECT_NEAR(rows[0].strain_xx, 0.0, 0.01);
  EXPECT_EQ(rows[0].vy_m_s, 0.0);
  const double energy = p.static_energy, force = samples.front().grip_force_n;
  EXPECT_NEAR(0.5 * force * 0.6e-3, energy, 1e-6 * energy);  // linear: U = F delta / 2
}

TEST(Gauges, VelocityIsTheRateOfTheDisplacement) {
  const Prepared p = small_plate({"output.gauges=[[\"20 mm\", \"9 mm\"]]", "output.samples=2000"});
  std::vector<results::GaugeRow> rows;
  march(p, {.gauge = [&](const results::GaugeRow& row) { rows.push_back(row); }});
  double largest = 0.0, worst = 0.0;
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    const double rate = (rows[k + 1].uy_m - rows[k - 1].uy_m) / (rows[k + 1].time_s - rows[k - 1].time_s);
    largest = std::max(largest, std::abs(rate));
    worst = std::max(worst, std::abs(rate - rows[k].vy_m_s));
  }
  EXPECT_GT(largest, 1.0);
  EXPECT_LT(worst, 0.05 * largest);
}

std::string refused(const std::vector<std::string>& overrides) try {
  small_plate(overrides);
  return "taken";
} catch (const scene::InputError& error) {
  return scene::to_text(error.issues.front());
}

TEST(Gauges, InTheCracksWayOrTooSmallAreRefused) {
  EXPECT_NE(refused({"output.gauges=[[\"20 mm\", \"6.2 mm\"]]"}).find("the crack runs 0.2 mm away"),
            std::string::npos);
  EXPECT_NE(refused({"output.gauges=[[\"0.1 mm\", \"11.9 mm\"]]", "output.gauge_length=4"})
                .find("too few elements"),
            std::string::npos);
  const scene::Preset outside =
      scene::read_preset_text("", "x.toml", {"output.gauges=[[\"20 mm\", \"62 mm\"]]"});
  ASSERT_EQ(outside.issues.size(), 1U);
  EXPECT_NE(scene::to_text(outside.issues[0]).find("(20 mm, 62 mm) lies outside the plate"),
            std::string::npos);
}

}  // namespace
}  // namespace rift::simulation
