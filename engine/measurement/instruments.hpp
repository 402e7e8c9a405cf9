#pragma once

#include "engine/measurement/intensity.hpp"
#include "engine/simulation/prepare.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What the instruments of a test would have shown of a run: a camera, gauges, the grip's load cell.
namespace rift::measurement {

/// Lengths in mean radii.
struct InstrumentOptions {
  int lane = 0;
  double grid = 4.0;                 // between the camera's points
  double subset = 4.0;               // radius of what each is read over
  double inner = 8.0, outer = 36.0;  // of the ring around the tip that K is fitted to
};

/// What arrives at the tip over a stretch of its way, beside an independent computation of the same strip.
struct ArrivingStretch {
  double from = 0, to = 0;  // tip positions [m]
  int moments = 0;          // that have a K
  double over_g_i0 = 0;     // G of the field over G_I0, mean over them
  double expected = 0;      // of theory::strip_transient
};

struct Instruments {
  Grid grid;
  double subset = 0;  // radius [m]
  Ring ring;
  Eigen::Vector3d plate = Eigen::Vector3d::Zero();  // length, height, thickness [m]
  double mean_radius = 0;                           // [m]
  int elements = 0;
  bool of_layers = false;                 // the thickness follows from the elements
  double clock = 0;                       // of a measured history: its time less the run's [s]
  double g_i0 = 0, g_i0_slope = 0;        // G_I0 of the plate [J/m2], and per tip position [J/m3]
  std::vector<results::Sample> samples;   // of the lane
  std::vector<results::GaugeRow> gauges;  // of the lane
  ElasticPlate own;                       // E and nu that the specimen shows when it is pulled
  std::vector<IntensityPoint> intensity;  // of each moment
  std::vector<ArrivingStretch> arriving;  // of the paper's strip, where it is one
  std::string no_intensity;               // why there are none
  bool grip_moves = false;                // while the crack runs: G_I0 is that of its start
  bool finished = false;                  // the run has come to its end
};

/// Which --inner and --grid, and how many elements of the same plate, would let a ring fit where none did, in
/// a sentence; empty where some moment has its K, or it was no ring that was missing.
std::string ring_that_fits(const Instruments& seen, const InstrumentOptions& options);

/// Reads a run, unfinished ones too, at the moments of its frames. The specimen is made again, from the cache
/// where it is there, and pulled: K needs its own E and nu.
/// @param see  is given each moment's field, in time
/// @param progress  answers false to stop: Interrupted is thrown
/// Throws WorldError where there is no run, InputError where it has no such lane or no displacements.
Instruments read_instruments(const std::filesystem::path& run, const InstrumentOptions& options,
                             base::Cache& cache, const simulation::StageProgress& progress,
                             const std::function<void(const Grid&, const SeenField&)>& see);

}  // namespace rift::measurement
