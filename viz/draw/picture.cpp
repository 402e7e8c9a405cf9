#include "viz/draw/picture.hpp"

#include "viz/draw/beam_lines.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace rift::viz {
namespace {

/// The largest plate of the panes, as its displacements magnify it.
Extent extent_of(const std::vector<std::unique_ptr<LaneReader>>& readers, const Look& look) {
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

double most_energy(LaneReader& reader) {
  double most = 0;
  for (const results::Sample& s : reader.samples_until(1e300))
    most = std::max({most, s.elastic_j, s.fracture_j, s.damping_j, s.contact_j});
  return most;
}

}  // namespace

Picture::Picture(const Job& job) : job_(job) {
  for (const Pane& pane : job_.panes) reader_.push_back(std::make_unique<LaneReader>(pane, job_.look));
  plate_ = extent_of(reader_, job_.look);
  layout_ = layout_of(job_, plate_);

  window_->SetReadyForRendering(true);
  window_->SetIsCurrent(true);
  window_->SetOwnContext(0);
  window_->SetMapped(1);
  window_->SetMultiSamples(0);
  window_->SetSize(job_.width, job_.height);
  if (!window_->InitializeFromCurrentContext()) throw std::runtime_error("VTK cannot use this OpenGL");
  overlay_->SetLayer(1);
  overlay_->InteractiveOff();
  window_->SetNumberOfLayers(2);
  background_->SetBackground(1, 1, 1);
  window_->AddRenderer(background_);
  window_->AddRenderer(overlay_);
  add_panes();
  if (job_.look.chart) add_charts();
}

Picture::~Picture() = default;

void Picture::add_panes() {
  const Field& field = *find_field(job_.look.field);
  const ColourMap* named = find_colour_map(job_.look.colours);
  const ColourMap& map = named != nullptr ? *named : colour_map_of(field);
  const auto colours = lookup_table(map, job_.look.range);
  for (std::size_t k = 0; k < job_.panes.size(); ++k)
    pane_.push_back(
        std::make_unique<PaneView>(job_, layout_, k, plate_, *reader_[k], *colours, *window_, *overlay_));
  if (job_.look.camera != Camera::side) {
    const Box& box = layout_.panes.front().picture;
    add_scale_bar(*overlay_, layout_.scale_bar, layout_.text_px,
                  window_of(job_.look, box, plate_, {0, 0}).height / box.height());
  }
  add_colour_bar(*overlay_, layout_.colour_bar, layout_.text_px, field, map, job_.look.range);
  if (job_.look.beams != Beams::none && field.name != "damage")
    add_colour_bar(*overlay_, layout_.beam_bar, layout_.text_px, beam_damage(), softening(), {0, 1});
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

void Picture::add_charts() {
  double lasts = 0, most = 0;
  BudgetLines lines;
  for (const auto& reader : reader_) {
    lasts = std::max(lasts, reader->lasts_s());
    most = std::max(most, most_energy(*reader));
    const BudgetLines own = budget_lines(reader->samples_until(1e300));
    lines.damping = lines.damping || own.damping, lines.contact = lines.contact || own.contact;
  }
  add_key(*overlay_, layout_.key, layout_.text_px, budget_key(lines));
  for (const Box& box : layout_.chart) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(box.x0 / job_.width, box.y0 / job_.height, box.x1 / job_.width,
                          box.y1 / job_.height);
    renderer->SetBackground(1, 1, 1);
    window_->AddRenderer(renderer);
    chart_.push_back(std::make_unique<BudgetChart>(*renderer, box, layout_.text_px, lasts, most, lines));
  }
}

void Picture::draw(double since_start_s, std::span<std::uint8_t> rgb) {
  for (std::size_t k = 0; k < pane_.size(); ++k) {
    pane_[k]->show(reader_[k]->at(since_start_s));
    if (!chart_.empty()) chart_[k]->show(reader_[k]->samples_until(since_start_s), reader_[k]->start_s());
  }
  window_->Render();
  read(rgb);
}

void Picture::read(std::span<std::uint8_t> rgb) {
  window_->GetPixelData(0, 0, job_.width - 1, job_.height - 1, 0, pixels_, 0);
  const std::size_t row = std::size_t{3} * job_.width;
  const unsigned char* from = pixels_->GetPointer(0);
  for (int y = 0; y < job_.height; ++y)
    std::memcpy(rgb.data() + y * row, from + (job_.height - 1 - y) * row, row);
}

}  // namespace rift::viz
