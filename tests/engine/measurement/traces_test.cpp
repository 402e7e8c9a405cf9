#include "engine/measurement/traces.hpp"

#include "engine/scene/issue.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace rift::measurement {
namespace {

/// Two gauges, a grip that lets go, one field without a fit.
Instruments some_instruments() {
  Instruments seen;
  seen.clock = 1e-6;
  for (int k = 0; k < 5; ++k) {
    results::Sample row{.step = k, .time_s = 1e-6 * k};
    row.grip_force_n = 100.0 - 10.0 * k;
    seen.samples.push_back(row);
    for (int g = 0; g < 2; ++g) {
      results::GaugeRow gauge{.step = k, .time_s = 1e-6 * k, .lane = 0, .gauge = g};
      gauge.strain_yy = 0.01 * (g + 1), gauge.vy_m_s = k;
      seen.gauges.push_back(gauge);
    }
    IntensityPoint point{.time = 1e-6 * k, .k = {}};
    if (k > 0) point.k = StressIntensity{.opening = 1e6 * k, .sliding = -1e5, .release_rate = 7.0 * k};
    seen.intensity.push_back(point);
  }
  return seen;
}

const Trace& named(const std::vector<Trace>& traces, const std::string& name) {
  for (const Trace& trace : traces)
    if (trace.name == name) return trace;
  throw std::runtime_error("no trace " + name);
}

TEST(Traces, AreOfGripGaugesAndFieldInTheMeasurementsClock) {
  const auto traces = traces_of(some_instruments());
  EXPECT_EQ(traces.size(), 1 + 2 * 7 + 3U);
  const Trace& grip = named(traces, "grip_force");
  EXPECT_EQ(grip.value, (std::vector<double>{100, 90, 80, 70, 60}));
  EXPECT_DOUBLE_EQ(grip.time[2], 3e-6);
  EXPECT_EQ(named(traces, "gauge1_strain_yy").value, std::vector<double>(5, 0.02));
  EXPECT_EQ(named(traces, "gauge0_vy").value, (std::vector<double>{0, 1, 2, 3, 4}));
  const std::vector<double>& k = named(traces, "k_i").value;
  ASSERT_EQ(k.size(), 5U);
  EXPECT_TRUE(std::isnan(k[0])) << "where nothing was fitted nothing is made up";
  EXPECT_EQ(k[1], 1e6);
  EXPECT_EQ(named(traces, "g_field").value[4], 28.0);
}

class TracesFile : public testing::Test {
 protected:
  std::vector<Trace> read(const std::string& text) {
    write_text(folder_.path() / "measured.csv", text);
    return read_traces(folder_.path() / "measured.csv", traces_of(some_instruments()));
  }
  /// The first line of what is said, after the folder.
  std::string said(const std::string& text) {
    try {
      read(text);
    } catch (const scene::InputError& error) {
      return std::string(error.what()).substr(folder_.path().string().size() + 1);
    }
    return "nothing";
  }
  TemporaryFolder folder_;
};

TEST_F(TracesFile, HoldsCurvesInTheirUnits) {
  const auto traces = read("# load cell\ntime [us];grip_force [kN];gauge1_vy [mm/s]\n0;1.5;2\n2;1.25;3\n");
  ASSERT_EQ(traces.size(), 2U);
  EXPECT_EQ(traces[0].name, "grip_force");
  EXPECT_EQ(traces[0].value, (std::vector<double>{1500, 1250}));
  EXPECT_EQ(traces[1].time, (std::vector<double>{0, 2e-6}));
  EXPECT_EQ(traces[1].value, (std::vector<double>{2e-3, 3e-3}));
  EXPECT_EQ(read("time [us];gauge0_strain_yy [um/m]\n0;500\n")[0].value, std::vector<double>{500e-6});
  EXPECT_EQ(read("time [us];gauge0_strain_yy [%]\n0;0.5\n")[0].value, std::vector<double>{0.5e-2});
  EXPECT_EQ(read("time [us];gauge0_strain_yy\n0;0.5\n")[0].value, std::vector<double>{0.5});
  EXPECT_EQ(read("time [us];k_i [MPa m1/2]\n0;1.5\n")[0].value, std::vector<double>{1.5e6});
}

TEST_F(TracesFile, NamesEachDefectWithItsLine) {
  EXPECT_EQ(said("time [us];grip_force [kN]\n0;1\n3;2\n2;2\n"),
            "measured.csv:4: time does not grow: 2 us after 3 us");
  EXPECT_EQ(said("time [us];grip_force [kN]\n0;1\n0;2\n"),
            "measured.csv:3: time does not grow: 0 s after 0 s");
  EXPECT_EQ(said("time [us];grip_forces [kN]\n0;1\n"),
            "measured.csv:1: unknown column 'grip_forces', did you mean 'grip_force'?");
  EXPECT_EQ(said("time [us];gauge2_strain_yy\n0;1\n"),
            "measured.csv:1: unknown column 'gauge2_strain_yy', did you mean 'gauge0_strain_yy'?");
  EXPECT_EQ(said("time [us];grip_force [mm]\n0;1\n"),
            "measured.csv:1: column 'grip_force': unknown unit 'mm' for a force: use kN, N or mN");
  EXPECT_EQ(said("time [us];gauge0_strain_yy [banana]\n0;1\n"),
            "measured.csv:1: column 'gauge0_strain_yy': unknown unit 'banana' for a strain: use m/m, %, mm/m "
            "or um/m");
  EXPECT_EQ(said("time [us];load [N]\n0;1\n"),
            "measured.csv: holds nothing to compare with: it has 'load', the run 'grip_force', "
            "'gauge0_strain_yy', 'gauge0_strain_xx', 'gauge0_strain_xy' and more");
  EXPECT_EQ(said("time [us];gauge0_strain_yy;gauge7_strain_yy\n0;1;1\n"),
            "measured.csv: the run has no 'gauge7_strain_yy'");
  EXPECT_EQ(said("time [s];grip_force [N]\n1467394337;1\n1467394338;1\n").substr(0, 60),
            "measured.csv:2: time 1467394337 s counts from a clock's epoc");
  EXPECT_EQ(said("time [us]\n0\n"), "measured.csv: holds nothing to compare with");
  EXPECT_EQ(said("grip_force [N]\n0\n"),
            "measured.csv:1: the header has no column time [ms]: it has 'grip_force'");
  EXPECT_EQ(said("time [us];grip_force [N]\n0;nan\n"), "measured.csv:2: grip_force 'nan' is not finite");
}

TEST(ReadTraces, NamesAFileThatIsNotThere) {
  EXPECT_THROW(read_traces("nowhere.csv", {}), scene::InputError);
}

TEST(DistanceBetween, IsTakenWhereBothAre) {
  const Trace run{"grip_force", scene::Dimension::force, {1, 2, 3}, {10, 20, 10}};
  const Trace measured{"grip_force", scene::Dimension::force, {0, 1.5, 2.5, 3, 4}, {0, 16, 18, 10, 0}};
  const auto d = distance_between(run, measured);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->points, 3);
  EXPECT_DOUBLE_EQ(d->rms, std::sqrt((1.0 + 9.0 + 0.0) / 3));
  EXPECT_DOUBLE_EQ(d->largest, 3.0);
  EXPECT_DOUBLE_EQ(d->span, 8.0);
  const Trace torn{"k_i", scene::Dimension::stress_intensity, {1, 2, 3, 4}, {10, std::nan(""), 10, 10}};
  EXPECT_EQ(
      distance_between(torn, {"k_i", scene::Dimension::stress_intensity, {1.5, 2.5, 3.5}, {1, 1, 1}})->points,
      1);
  EXPECT_FALSE(distance_between(run, {"grip_force", scene::Dimension::force, {5, 6}, {1, 2}}));
}

}  // namespace
}  // namespace rift::measurement
