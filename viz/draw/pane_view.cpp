#include "viz/draw/pane_view.hpp"

#include "engine/results/records.hpp"
#include "viz/draw/boundaries.hpp"

#include <fmt/format.h>
#include <vtkCamera.h>
#include <vtkLookupTable.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::viz {
namespace {

/// The elements; seen from the front of the whole plate pores between them are closed, so that none glitters.
std::vector<Ball> balls_drawn(const Look& look, const results::Geometry& geometry,
                              const std::vector<std::int32_t>& shown, const nlohmann::ordered_json& header) {
  const float scale = sphere_scale(look);
  std::vector<Ball> balls;
  if (look.camera == Camera::plate && look.beams != Beams::all) {
    const double pulled = look.magnification * header.value("displacement_m", 0.0);
    balls = pore_fillers(geometry, shown, scale,
                         std::max(1.0, 1.0 + pulled / header.at("height_m").get<double>()));
  }
  for (const std::int32_t i : shown) balls.push_back({i, geometry.position[i], scale * geometry.radius[i]});
  return balls;
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

constexpr double not_stored = std::numeric_limits<double>::quiet_NaN();

std::array<double, 3> of_element(const std::vector<std::array<float, 3>>& field, std::int32_t i) {
  if (field.empty()) return {not_stored, not_stored, not_stored};
  return {field[i][0], field[i][1], field[i][2]};
}

/// 1 less the least factor among some beams; 0 where the path crosses none of them.
template <typename Among>
double damage_of(const results::Geometry& g, const results::Frame& frame, Among among) {
  if (frame.damage_factor.empty()) return not_stored;
  float least = 1;
  for (std::size_t k = 0; k < g.crossing.size(); ++k)
    if (among(g.crossing[k])) least = std::min(least, frame.damage_factor[k]);
  return 1 - least;
}

Picked element(const results::Geometry& g, const results::Frame& frame, std::int32_t i) {
  Picked picked{Picked::Kind::element, -1, i};
  picked.position_m = {g.position[i][0], g.position[i][1], g.position[i][2]};
  picked.displacement_m = of_element(frame.displacement, i);
  picked.velocity_m_s = of_element(frame.velocity, i);
  picked.elastic_j = frame.elastic_energy.empty() ? not_stored : frame.elastic_energy[i];
  picked.released_s = not_stored;
  picked.damage = damage_of(g, frame, [&](std::int32_t b) { return g.beam[b][0] == i || g.beam[b][1] == i; });
  return picked;
}

/// What moves is the mean of its two elements.
Picked beam(const results::Geometry& g, const results::Frame& frame, std::int32_t b) {
  const auto [i, j] = g.beam[b];
  Picked picked = element(g, frame, i);
  const Picked other = element(g, frame, j);
  picked.kind = Picked::Kind::beam;
  picked.index = b, picked.first = i, picked.second = j;
  for (auto member : {&Picked::position_m, &Picked::displacement_m, &Picked::velocity_m_s})
    for (int axis = 0; axis < 3; ++axis)
      (picked.*member)[axis] = 0.5 * ((picked.*member)[axis] + (other.*member)[axis]);
  picked.elastic_j = not_stored;
  picked.damage = damage_of(g, frame, [&](std::int32_t k) { return k == b; });
  return picked;
}

}  // namespace

PaneView::PaneView(const Job& job, const Layout& layout, std::size_t place_in_frame, const Extent& plate,
                   LaneReader& reader, vtkLookupTable& colours, vtkRenderWindow& window, vtkRenderer& overlay)
    : look_(job.look), place_(layout.panes[place_in_frame]), plate_(plate), reader_(reader), window_(window) {
  place(*renderer_, place_.picture, job);
  window_.AddRenderer(renderer_);
  const results::Geometry& geometry = reader.geometry();
  shown_ = elements_shown(look_, geometry);
  if (look_.spheres)
    renderer_->AddActor(
        &spheres_.emplace(balls_drawn(look_, geometry, shown_, reader.header()), colours).actor());
  if (look_.beams != Beams::none) {
    const ColourMap& field_colours = find_colour_map(look_.colours) != nullptr
                                         ? *find_colour_map(look_.colours)
                                         : colour_map_of(*find_field(look_.field));
    const bool same = look_.field == "damage";  // one quantity has one code of colours
    renderer_->AddActor(
        &beams_.emplace(geometry, look_.beams, same ? field_colours : softening(), same).actor());
  }
  if (look_.texts) add_texts(job.panes[place_in_frame].title, layout.text_px, overlay);
  for (std::size_t k = 0; k < results::tips_at(reader.header(), 0).size(); ++k) {
    dots_.push_back(dot(std::max(8.0, 0.55 * layout.text_px)));
    overlay.AddActor2D(dots_.back());
  }
}

PaneView::~PaneView() { window_.RemoveRenderer(renderer_); }

void PaneView::add_texts(const std::string& title, int text, vtkRenderer& overlay) {
  title_ = text_at(place_.title.x0, place_.title.y0 + 0.2 * text, text, Align::left, title, true);
  overlay.AddActor2D(title_);
  fit(*title_, overlay, place_.title.width());
  const bool below = place_.moment.x0 == place_.title.x0;
  moment_ = text_at(below ? place_.moment.x0 : place_.moment.x1, place_.moment.y0 + 0.2 * text, text,
                    below ? Align::left : Align::right, widest_caption(reader_.has_history()));
  overlay.AddActor2D(moment_);
  fit(*moment_, overlay, place_.moment.width());
  if (look_.boundaries && look_.camera != Camera::free) {  // they stand on the frame and not on the plate
    const Window shown = window_of(look_, place_.picture, plate_, {0, 0});
    const auto corner = [&](double x, double y) {
      return to_pixels(axes_of(look_), shown, place_.picture, {x, y, 0});
    };
    const auto low = corner(0, 0), high = corner(plate_.length, 2 * plate_.middle);
    add_boundaries(overlay, {low[0], low[1], high[0], high[1]}, text, reader_.header());
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
  if (beams_)
    beams_->set_width(
        std::max(1.5, 0.35 * reader_.geometry().radius.front() * place_.picture.height() / shown.height));
  for (std::size_t k = 0; k < tips.size(); ++k) {
    const auto [x, y] = to_pixels(axes_of(look_), shown, place_.picture, {tips[k][0], tips[k][1], 0});
    dots_[k]->SetPosition(x, y);
    dots_[k]->SetVisibility(holds(place_.picture, {x, y}));
  }
  if (moment_ != nullptr) moment_->SetInput(caption(moment).c_str());
  answer_ = {place_.picture, shown, moment.since_start_s, moment.tip_m, moment.velocity_m_s, moment.is_last};
}

Picked PaneView::at(const std::array<double, 2>& pixel) const {
  const results::Geometry& g = reader_.geometry();
  const results::Frame& frame = reader_.frame();
  const bool moves = look_.magnification != 0;
  const Standing standing{g,
                          moves ? std::span(frame.displacement) : std::span<const std::array<float, 3>>{},
                          magnification_of(look_),
                          axes_of(look_),
                          answer_.window,
                          answer_.picture};
  Picked picked;
  if (const auto i = element_at(standing, shown_, sphere_scale(look_), pixel)) {
    picked = element(g, frame, *i);
  } else if (const auto b = beam_at(standing, look_.beams, pixel)) {
    picked = beam(g, frame, *b);
    for (const results::ReleaseEvent& event : reader_.events())
      if (event.beam == *b) picked.released_s = event.time_s - reader_.start_s();
  } else {
    return picked;
  }
  const double time_s = (reader_.start_s() + answer_.since_start_s) * (1 + 1e-12);
  if (const auto row = nearest_gauge(reader_.gauges(), picked.position_m, time_s)) picked.gauge = *row;
  return picked;
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
  const Axes axes = axes_of(look_);
  const double away = 10 * plate_.length;
  vtkCamera& camera = *renderer_->GetActiveCamera();
  camera.ParallelProjectionOn();
  camera.SetFocalPoint(shown.x, shown.y, 0);
  camera.SetPosition(shown.x + away * axes.out[0], shown.y + away * axes.out[1], away * axes.out[2]);
  camera.SetViewUp(axes.up.data());
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
