#include "viz/draw/pane_view.hpp"

#include "engine/results/records.hpp"
#include "viz/draw/boundaries.hpp"
#include "viz/front_layer.hpp"

#include <fmt/format.h>
#include <vtkCamera.h>
#include <vtkLookupTable.h>
#include <vtkRenderWindow.h>

#include <cmath>
#include <numeric>

namespace rift::viz {
namespace {

std::vector<std::int32_t> elements_shown(const Look& look, const results::Geometry& geometry) {
  if (look.camera != Camera::side && look.beams != Beams::all) return front_layer(geometry);
  std::vector<std::int32_t> all(geometry.position.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Where every beam is drawn, elements are small balls between them; seen from far they are drawn a little
/// larger than they are and pores are closed, so that no gap between them glitters.
std::vector<Ball> balls_drawn(const Look& look, const results::Geometry& geometry,
                              const nlohmann::ordered_json& header) {
  const std::vector<std::int32_t> shown = elements_shown(look, geometry);
  const bool from_far = look.camera == Camera::plate && look.beams != Beams::all;
  const float scale = look.beams == Beams::all ? 0.6F : from_far ? 1.15F : 1.0F;
  std::vector<Ball> balls;
  if (from_far) {
    const double pulled = look.magnification * header.value("displacement_m", 0.0);
    balls = pore_fillers(geometry, shown, scale,
                         std::max(1.0, 1.0 + pulled / header.at("height_m").get<double>()));
  }
  for (const std::int32_t i : shown) balls.push_back({i, geometry.position[i], scale * geometry.radius[i]});
  return balls;
}

/// The side camera magnifies what leaves the plane and nothing else.
std::array<float, 3> magnification_of(const Look& look) {
  const auto m = static_cast<float>(look.magnification);
  return look.camera == Camera::side ? std::array{1.0F, 1.0F, m} : std::array{m, m, m};
}

/// The longest caption that a lane may have, by which its size is chosen once and for all.
std::string widest_caption(bool has_history) {
  return std::string("t = 0000.0 µs   ") + (has_history ? "history \u22120000.0 µs   " : "") +
         "tip 000.0 mm   0000 m/s = 0.00 × Rayleigh speed   (end)";
}

void place(vtkRenderer& renderer, const Box& box, const Job& job) {
  renderer.SetViewport(box.x0 / job.width, box.y0 / job.height, box.x1 / job.width, box.y1 / job.height);
  renderer.SetBackground(1, 1, 1);
}

}  // namespace

PaneView::PaneView(const Job& job, const Layout& layout, std::size_t place_in_frame, const Extent& plate,
                   LaneReader& reader, vtkLookupTable& colours, vtkRenderWindow& window, vtkRenderer& overlay)
    : look_(job.look), place_(layout.panes[place_in_frame]), plate_(plate), reader_(reader) {
  place(*renderer_, place_.picture, job);
  window.AddRenderer(renderer_);
  const results::Geometry& geometry = reader.geometry();
  const Window shown = window_of(look_, place_.picture, plate, {0, 0});
  const double metres_per_pixel = shown.height / place_.picture.height();
  if (look_.spheres)
    renderer_->AddActor(&spheres_.emplace(balls_drawn(look_, geometry, reader.header()), colours).actor());
  if (look_.beams != Beams::none) {
    const double pixels = std::max(1.5, 0.35 * geometry.radius.front() / metres_per_pixel);
    const ColourMap& field_colours = find_colour_map(look_.colours) != nullptr
                                         ? *find_colour_map(look_.colours)
                                         : colour_map_of(*find_field(look_.field));
    const bool same = look_.field == "damage";  // one quantity has one code of colours
    renderer_->AddActor(
        &beams_.emplace(geometry, look_.beams, pixels, same ? field_colours : softening(), same).actor());
  }
  const int text = layout.text_px;
  title_ = text_at(place_.title.x0, place_.title.y0 + 0.2 * text, text, Align::left,
                   job.panes[place_in_frame].title, true);
  overlay.AddActor2D(title_);
  fit(*title_, overlay, place_.title.width());
  const bool below = place_.moment.x0 == place_.title.x0;
  moment_ = text_at(below ? place_.moment.x0 : place_.moment.x1, place_.moment.y0 + 0.2 * text, text,
                    below ? Align::left : Align::right, widest_caption(reader.has_history()));
  overlay.AddActor2D(moment_);
  fit(*moment_, overlay, place_.moment.width());
  if (look_.boundaries) {
    const auto corner = [&](double x, double y) {
      return to_pixels(look_, shown, place_.picture, plate, {x, y});
    };
    const auto low = corner(0, 0), high = corner(plate.length, 2 * plate.middle);
    add_boundaries(overlay, {low[0], low[1], high[0], high[1]}, text, reader.header());
  }
  for (std::size_t k = 0; k < results::tips_at(reader.header(), 0).size(); ++k) {
    dots_.push_back(dot(std::max(8.0, 0.55 * text)));
    overlay.AddActor2D(dots_.back());
  }
}

void PaneView::show(const Moment& moment) {
  const std::array<float, 3> magnification = magnification_of(look_);
  if (spheres_) spheres_->show(moment.displacement, moment.value, magnification);
  if (beams_) beams_->show(moment.displacement, moment.damage_factor, magnification);
  const auto tips = carried_tips(moment);
  const Window shown = window_of(look_, place_.picture, plate_,
                                 tips.empty() ? std::array{0.5 * plate_.length, plate_.middle} : tips.back());
  look_at(shown);
  for (std::size_t k = 0; k < tips.size(); ++k) {
    const auto [x, y] = to_pixels(look_, shown, place_.picture, plate_, tips[k]);
    dots_[k]->SetPosition(x, y);
  }
  moment_->SetInput(caption(moment).c_str());
}

/// The tips where the lattice around them has been carried, as it is drawn.
std::vector<std::array<double, 2>> PaneView::carried_tips(const Moment& moment) const {
  auto tips = results::tips_at(reader_.header(), moment.tip_m);
  if (moment.displacement.empty()) return tips;
  const results::Geometry& geometry = reader_.geometry();
  const auto magnification = magnification_of(look_);
  const double near = 5 * geometry.radius.front();
  for (auto& tip : tips) {
    double sum[2] = {0, 0};
    int count = 0;
    for (std::size_t i = 0; i < geometry.position.size(); ++i) {
      if (std::hypot(geometry.position[i][0] - tip[0], geometry.position[i][1] - tip[1]) > near) continue;
      for (int axis = 0; axis < 2; ++axis) sum[axis] += moment.displacement[i][axis];
      ++count;
    }
    for (int axis = 0; axis < 2 && count > 0; ++axis) tip[axis] += magnification[axis] * sum[axis] / count;
  }
  return tips;
}

void PaneView::look_at(const Window& shown) {
  const double tilt = look_.camera == Camera::side ? side_tilt : 0, away = 10 * plate_.length;
  vtkCamera& camera = *renderer_->GetActiveCamera();
  camera.ParallelProjectionOn();
  camera.SetFocalPoint(shown.x, shown.y, 0);
  camera.SetPosition(shown.x, shown.y - away * std::sin(tilt), away * std::cos(tilt));
  camera.SetViewUp(0, std::cos(tilt), std::sin(tilt));
  camera.SetParallelScale(0.5 * shown.height);
  camera.SetClippingRange(away - 2 * plate_.length, away + 2 * plate_.length);
}

std::string PaneView::caption(const Moment& moment) const {
  if (results::tips_at(reader_.header(), 0).empty()) return {};
  const double rayleigh = reader_.header().value("rayleigh_speed_m_s", 0.0);
  const auto tenths = [](double value) {
    const double rounded = std::round(10 * value) / 10;
    return fmt::format("{}{:.1f}", rounded < 0 ? "\u2212" : "", std::abs(rounded));
  };
  std::string text = fmt::format("t = {} µs   ", tenths(moment.since_start_s * 1e6));
  if (std::isfinite(moment.history_s))
    text += fmt::format("history {} µs   ", tenths(moment.history_s * 1e6));
  text += fmt::format("tip {} mm", tenths(moment.tip_m * 1e3));
  if (rayleigh > 0)
    text += fmt::format("   {:.0f} m/s = {:.2f} × Rayleigh speed", moment.velocity_m_s,
                        moment.velocity_m_s / rayleigh);
  return moment.is_last ? text + "   (end)" : text;
}

}  // namespace rift::viz
