#include "viz/draw/scene.hpp"

#include "viz/draw/annotation.hpp"
#include "viz/draw/beam_lines.hpp"
#include "viz/draw/spheres.hpp"

#include <vtkRenderWindow.h>

#include <algorithm>

namespace rift::viz {
namespace {

/// The largest plate of the panes, as its displacements magnify it.
Extent extent_of(const LaneReaders& readers, const Look& look) {
  Extent plate;
  for (const auto& reader : readers) {
    const auto& header = reader->header();
    const double height = header.at("height_m").get<double>();
    const double pulled = look.camera == Camera::side ? 1 : look.magnification;
    plate.length = std::max(plate.length, header.at("length_m").get<double>());
    plate.height = std::max(plate.height, height + pulled * header.value("displacement_m", 0.0));
    plate.middle = std::max(plate.middle, 0.5 * height);
  }
  return plate;
}

constexpr double all_times = 1e300;

double most_energy(const LaneReader& reader) {
  double most = 0;
  for (const results::Sample& s : reader.samples_until(all_times))
    most = std::max({most, s.elastic_j, s.kinetic_translation_j + s.kinetic_rotation_j, s.fracture_j,
                     s.damping_j, s.contact_j});
  return most;
}

const ColourMap& map_of(const Look& look) {
  const ColourMap* named = find_colour_map(look.colours);
  return named != nullptr ? *named : colour_map_of(*find_field(look.field));
}

void put_on_top(vtkRenderer& renderer, vtkRenderWindow& window) {
  renderer.SetLayer(1);
  renderer.InteractiveOff();
  window.AddRenderer(&renderer);
}

}  // namespace

Scene::Scene(const Job& job, const LaneReaders& readers, vtkRenderWindow& window)
    : job_(job),
      reader_(readers),
      window_(window),
      plate_(extent_of(readers, job.look)),
      layout_(layout_of(job, plate_)),
      colours_(lookup_table(map_of(job.look), job.look.range)) {
  put_on_top(*overlay_, window_);
  add_panes();
  if (job_.look.texts) add_title();
  if (job_.look.chart != Chart::none) add_charts();
}

Scene::~Scene() {
  for (const auto& place : chart_place_) window_.RemoveRenderer(place);
  if (scales_ != nullptr) window_.RemoveRenderer(scales_);
  pane_.clear();
  window_.RemoveRenderer(overlay_);
}

void Scene::add_panes() {
  for (std::size_t k = 0; k < job_.panes.size(); ++k)
    pane_.push_back(
        std::make_unique<PaneView>(job_, layout_, k, plate_, *reader_[k], *colours_, window_, *overlay_));
}

void Scene::add_title() {
  const auto title = text_at(layout_.title.x0, layout_.title.y0, static_cast<int>(1.35 * layout_.text_px),
                             Align::left, job_.look.title, true);
  overlay_->AddActor2D(title);
  const double share = job_.look.scheme.empty() ? 1.0 : 0.55;  // of the line; the scheme has the rest
  fit(*title, *overlay_, share * layout_.title.width());
  const auto scheme = text_at(layout_.title.x1, layout_.title.y0 + 0.2 * layout_.text_px, layout_.text_px,
                              Align::right, job_.look.scheme);
  overlay_->AddActor2D(scheme);
  fit(*scheme, *overlay_, (0.98 - share) * layout_.title.width());
}

/// The bars that change with the range and the camera.
void Scene::show_scales(const std::array<double, 2>& range) {
  const Box& box = layout_.panes.front().picture;
  const double height = window_of(job_.look, box, plate_, {0, 0}).height;
  if (scales_ != nullptr && scaled_ == std::array{range[0], range[1], height}) return;
  scaled_ = {range[0], range[1], height};
  if (scales_ != nullptr) window_.RemoveRenderer(scales_);
  scales_ = vtkSmartPointer<vtkRenderer>::New();
  put_on_top(*scales_, window_);
  const Field& field = *find_field(job_.look.field);
  if (seen_from_front(job_.look))
    add_scale_bar(*scales_, layout_.scale_bar, layout_.text_px, height / box.height());
  add_colour_bar(*scales_, layout_.colour_bar, layout_.text_px, field, map_of(job_.look), range);
  if (job_.look.beams != Beams::none && field.name != "damage")
    add_colour_bar(*scales_, layout_.beam_bar, layout_.text_px, beam_damage(), softening(), {0, 1});
}

void Scene::add_charts() {
  double lasts = 0;
  BudgetLines lines;
  for (const auto& reader : reader_) {
    lasts = std::max(lasts, reader->lasts_s());
    const BudgetLines own = budget_lines(reader->samples_until(all_times));
    lines.damping = lines.damping || own.damping, lines.contact = lines.contact || own.contact;
  }
  const bool whole = job_.look.chart == Chart::whole;
  std::vector<KeyEntry> key = budget_key(lines);
  if (whole)
    for (KeyEntry& entry : ratio_key(reader_.size())) key.push_back(std::move(entry));
  add_key(*overlay_, layout_.key, layout_.text_px, key);
  const bool free = std::all_of(reader_.begin(), reader_.end(),
                                [](const auto& reader) { return reader->breaks_by_itself(); });
  const char* since = free ? "the loads' start" : "the crack's start";
  for (const Box& box : layout_.chart)
    chart_.push_back(
        std::make_unique<BudgetChart>(chart_place(box), box, layout_.text_px, since, lasts, lines, whole));
  if (whole)
    ratio_ = std::make_unique<RatioChart>(chart_place(layout_.ratio), layout_.ratio, layout_.text_px,
                                          reader_.size(), plate_.length);
}

/// A renderer of its own for a chart.
vtkRenderer& Scene::chart_place(const Box& box) {
  const auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetViewport(box.x0 / job_.width, box.y0 / job_.height, box.x1 / job_.width, box.y1 / job_.height);
  renderer->SetBackground(1, 1, 1);
  window_.AddRenderer(renderer);
  chart_place_.push_back(renderer);
  return *renderer;
}

void Scene::show_charts(double since_start_s) {
  double most = 0;
  for (const auto& reader : reader_) most = std::max(most, most_energy(*reader));
  const double until_s = ratio_ == nullptr ? since_start_s : all_times;
  for (std::size_t k = 0; k < chart_.size(); ++k)
    chart_[k]->show(reader_[k]->samples_until(until_s), reader_[k]->start_s(),
                    pane_[k]->answer().since_start_s, most);
  if (ratio_ == nullptr) return;
  std::vector<std::span<const results::RatePoint>> rates;
  for (const auto& reader : reader_) rates.emplace_back(reader->rates());
  ratio_->show(rates, pane_.front()->answer().tip_m);
}

void Scene::show(double since_start_s, const std::vector<Moment>& moments,
                 const std::array<double, 2>& range) {
  colours_->SetTableRange(range[0], range[1]);
  if (job_.look.texts) show_scales(range);
  for (std::size_t k = 0; k < pane_.size(); ++k) pane_[k]->show(moments[k]);
  if (!chart_.empty()) show_charts(since_start_s);
}

}  // namespace rift::viz
