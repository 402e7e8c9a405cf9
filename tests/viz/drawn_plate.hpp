#pragma once

#include "engine/results/archive.hpp"
#include "engine/results/journal.hpp"
#include "tests/temporary_folder.hpp"
#include "viz/field.hpp"
#include "viz/layout.hpp"
#include "viz/renderer.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>

/// A run whose pictures are known: a plate of 40 x 8 touching elements, pulled evenly, cut along its middle
/// from the left.
namespace rift::viz::drawn_plate {

constexpr int columns = 40, rows = 8;
constexpr float diameter = 1e-3F;
constexpr double length = columns * 1e-3, height = rows * 1e-3, pulled = 0.4e-3;

inline int element(int column, int row) { return row * columns + column; }

/// Vertical beams join the rows; those from row 3 to row 4 cross the path.
inline results::Geometry geometry() {
  results::Geometry g;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto x = static_cast<float>(column) + 0.5F, y = static_cast<float>(row) + 0.5F;
      g.position.push_back({x * diameter, y * diameter, 0});
      g.radius.push_back(0.5F * diameter);
    }
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (row == rows / 2 - 1) g.crossing.push_back(static_cast<std::int32_t>(g.beam.size()));
      g.beam.push_back({element(column, row), element(column, row + 1)});
    }
  return g;
}

inline nlohmann::ordered_json header(int lanes = 1) {
  nlohmann::ordered_json scenarios = nlohmann::ordered_json::array();
  for (int k = 0; k < lanes; ++k)
    scenarios.push_back({{"technique", k == 0 ? "simple" : "progressive"}, {"crack_velocity_over_cr", 0.5}});
  return {{"preset_name", "drawn.toml"},
          {"lanes", lanes},
          {"length_m", length},
          {"height_m", height},
          {"thickness_m", 1e-3},
          {"displacement_m", pulled},
          {"density_kg_m3", 1000.0},
          {"solid_fraction", 0.5},
          {"rayleigh_speed_m_s", 2000.0},
          {"tips", 1},
          {"path", {{0.0, 0.5 * height}, {length, 0.5 * height}}},
          {"scenarios", scenarios}};
}

inline double tip_at_moment(int moment) { return 4e-3 * moment; }

/// Of moment k the tip is at 4 k mm: behind it the halves have sprung back to their grips, ahead the plate is
/// stretched evenly.
inline results::Frame frame(int moment, int lane = 0) {
  const results::Geometry g = geometry();
  results::Frame f;
  f.step = moment;
  f.time_s = 1e-6 * moment;
  f.lane = lane;
  f.tip_m = tip_at_moment(moment);
  for (const auto& p : g.position) {
    const bool open = p[0]<f.tip_m, upper = p[1]> 0.5 * height;
    const double uy = open ? (upper ? pulled : 0) : pulled * p[1] / height;
    f.displacement.push_back({0, static_cast<float>(uy), 0});
    f.velocity.push_back({static_cast<float>(10 * moment), 0, 0});
  }
  for (int column = 0; column < columns; ++column)
    f.damage_factor.push_back(column < 4 * moment ? 0.0F : column < 4 * moment + 2 ? 0.5F : 1.0F);
  return f;
}

/// One gauge, right of the middle, that is stretched more and more.
constexpr std::array<double, 2> gauge{22e-3, 6e-3};
inline results::GaugeRow gauge_row(int moment, int lane) {
  return {.step = moment,
          .time_s = 1e-6 * moment,
          .lane = lane,
          .gauge = 0,
          .x_m = gauge[0],
          .y_m = gauge[1],
          .uy_m = 1e-5 * moment,
          .strain_yy = 1e-3 * moment};
}

/// `moments` of them, with energy balances, a gauge and release rates, in a folder of a run that has ended.
inline std::filesystem::path write_run(const std::filesystem::path& run, int moments = 6, int lanes = 1,
                                       double contact_j = 0.0) {
  std::filesystem::create_directories(run);
  results::JournalWriter journal(run / results::journal_name);
  journal.write(results::RunHeader{header(lanes).dump()});
  journal.write(geometry());
  for (int k = 0; k < moments; ++k)
    for (int lane = 0; lane < lanes; ++lane) {
      results::Sample s;
      s.step = k;
      s.time_s = 1e-6 * k;
      s.lane = lane;
      s.tip_m = tip_at_moment(k);
      s.velocity_m_s = 1000;
      s.elastic_j = 10.0 - k;
      s.kinetic_translation_j = 0.25 * k;
      s.fracture_j = 0.75 * k;
      s.contact_j = contact_j * k;
      journal.write(s);
      journal.write(gauge_row(k, lane));
      journal.write(frame(k, lane));
    }
  for (int lane = 0; lane < lanes; ++lane) {
    results::RateCurve curve{lane, {}};
    for (int k = 1; k + 1 < moments; ++k) curve.points.push_back({tip_at_moment(k), 0.75});
    journal.write(curve);
  }
  journal.write(results::RunEnd{"{}"});
  journal.close();
  return run;
}

inline Job job_for(const std::filesystem::path& run, int lanes = 1) {
  Job job;
  for (int k = 0; k < lanes; ++k)
    job.panes.push_back({run, k, k == 0 ? "simple release" : "progressive release"});
  job.look.title = "A drawn plate";
  job.look.range = {0, pulled};
  job.width = 640;
  job.height = 360;
  return job;
}

inline std::filesystem::path programs() { return std::filesystem::path(RIFT_EXE).parent_path(); }

/// The frame of a moment.
inline Image drawn(const Job& job, int moment, Gl gl = Gl::osmesa) {
  Renderer renderer(job, gl, false, programs());
  renderer.ask(1e-6 * moment);
  return renderer.next();
}

/// The colour at a place counted from the lower left corner.
inline Colour pixel(const Image& image, double x, double y) {
  const auto column = static_cast<int>(x), row = image.height - 1 - static_cast<int>(y);
  const std::uint8_t* at = &image.rgb[3 * (static_cast<std::size_t>(row) * image.width + column)];
  return {at[0] / 255.0, at[1] / 255.0, at[2] / 255.0};
}

inline double apart(const Colour& a, const Colour& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// Where a point of the plate is drawn, by the layout alone.
inline std::array<double, 2> place_of(const Job& job, const std::array<double, 2>& point,
                                      const std::array<double, 2>& tip) {
  const Extent plate{length, height + job.look.magnification * pulled, 0.5 * height};
  const Box picture = layout_of(job, plate).panes.front().picture;
  return to_pixels(axes_of(job.look), window_of(job.look, picture, plate, tip), picture,
                   {point[0], point[1], 0});
}

}  // namespace rift::viz::drawn_plate
