#include "engine/study/resources.hpp"

#include "engine/simulation/schedule.hpp"

#include <string>
#include <vector>

namespace rift::study {

LatticeSize expected_size(const scene::Scene& scene) {
  constexpr double beams_per_element = 3.0;
  const double elements = scene.specimen.elements;
  return {.elements = elements, .beams = beams_per_element * elements};
}

Moments expected_moments(const scene::Scene& scene) {
  const int phases = scene.loading.method == scene::LoadingMethod::ramp ? 2 : 1;
  return {.frames = static_cast<double>(scene.output.frames),
          .samples = static_cast<double>(phases * scene.output.samples + simulation::window_samples)};
}

namespace {

// Bytes   [measured on runs of quickstart, path_pressed and study_release]
constexpr double of_a_series_row = 290.0;  // a line of series.csv, in numbers that read back to the same bits
constexpr double of_a_kept_sample = 300.0;  // in journal and archive together
constexpr double of_a_summary = 6e3;
constexpr double of_a_scenario_drawn = 1.6e5;  // its share of a study's charts and page

/// Of a lane's fields at one moment, in journal and archive together. The journal keeps the factors of
/// crossing beams alone, and those of all in the archive are nearly all 1, which is compressed to little.
double frame_bytes(const scene::Scene& scene, const LatticeSize& size) {
  constexpr double vector = 12.0, number = 4.0, factor = 0.25;
  double bytes = 0.0;
  for (const std::string& field : scene.output.fields)
    bytes += field == "damage"   ? factor * (size.beams + size.elements)
             : field == "energy" ? 2.0 * number * size.elements
                                 : 2.0 * vector * size.elements;
  return bytes;
}

}  // namespace

double disk_bytes_of_run(const scene::Scene& scene, const LatticeSize& size, std::span<const Moments> lanes) {
  constexpr double geometry = 48.0;
  // In journal and archive together, of which the latter has axes and lengths too and is compressed.
  constexpr double mechanics_of_element = 98.0, mechanics_of_beam = 84.0;
  constexpr double scene_and_names =
      6e4;  // texts of the scene, names and attributes of the archive's datasets
  double bytes = scene_and_names + (geometry + mechanics_of_beam) * size.beams +
                 (geometry + mechanics_of_element) * size.elements;
  for (const Moments& lane : lanes)
    bytes += lane.frames * frame_bytes(scene, size) + lane.samples * (of_a_series_row + of_a_kept_sample) +
             of_a_summary;
  return bytes;
}

double expected_disk_bytes(std::span<const scene::Scene> lanes) {
  std::vector<Moments> moments;
  for (const scene::Scene& lane : lanes) moments.push_back(expected_moments(lane));
  return disk_bytes_of_run(lanes.front(), expected_size(lanes.front()), moments);
}

double disk_bytes_of_scenario(const scene::Scene& scene) {
  return of_a_summary + of_a_scenario_drawn + expected_moments(scene).samples * of_a_series_row;
}

double expected_memory_bytes(const scene::Scene& scene) {
  // What 'rift check --no-cache' measured with 2,000, 5,000 and 20,000 elements.
  constexpr double program = 1.5e7, element = 1.9e3;
  return program + element * scene.specimen.elements;
}

}  // namespace rift::study
