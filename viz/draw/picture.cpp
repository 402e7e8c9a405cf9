#include "viz/draw/picture.hpp"

#include <vtkRenderer.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace rift::viz {
namespace {

/// The same of all jobs that one scene can show.
Job scene_of(Job job) {
  Look& look = job.look;
  const bool from_front = seen_from_front(look);  // else other elements are drawn
  look.view = {};
  look.view.turn = look.camera == Camera::free && !from_front ? 1 : 0;
  look.range = {};
  look.range_of_moment = false;
  return job;
}

/// Of the values of all panes at one moment. Where all are the same any range shows it.
std::array<double, 2> range_at(const std::vector<Moment>& moments, const Field& field) {
  std::vector<float> values;
  for (const Moment& moment : moments) values.insert(values.end(), moment.value.begin(), moment.value.end());
  const std::array<double, 2> range = range_of(field, values);
  return range[1] > range[0] ? range : std::array{range[0] - field.unit_in_si, range[0] + field.unit_in_si};
}

}  // namespace

Picture::Picture(const Job& job) : job_(job) {
  open(job_.panes);
  window_->SetReadyForRendering(true);
  window_->SetIsCurrent(true);
  window_->SetOwnContext(0);
  window_->SetMapped(1);
  window_->SetMultiSamples(0);
  window_->SetSize(job_.width, job_.height);
  if (!window_->InitializeFromCurrentContext()) throw std::runtime_error("VTK cannot use this OpenGL");
  window_->SetNumberOfLayers(2);
  background_->SetBackground(1, 1, 1);
  window_->AddRenderer(background_);
  build();
}

Picture::~Picture() = default;

void Picture::open(const std::vector<Pane>& panes) {
  const auto same = [](const Pane& a, const Pane& b) { return a.run == b.run && a.lane == b.lane; };
  if (std::equal(panes.begin(), panes.end(), open_.begin(), open_.end(), same)) return;
  reader_.clear();
  for (const Pane& pane : panes) reader_.push_back(std::make_unique<LaneReader>(pane));
  open_ = panes;
}

void Picture::build() { scene_ = std::make_unique<Scene>(job_, reader_, *window_); }

void Picture::change(const Job& job) {
  const bool same_scene = to_json(scene_of(job)) == to_json(scene_of(job_));
  if (same_scene) {
    job_ = job;  // the scene looks at it
    return;
  }
  scene_.reset();
  job_ = job;
  open(job_.panes);
  build();
}

void Picture::draw(double since_start_s, std::span<std::uint8_t> rgb) {
  std::vector<Moment> moments;
  for (const auto& reader : reader_) moments.push_back(reader->at(since_start_s, job_.look));
  range_ = job_.look.range_of_moment ? range_at(moments, *find_field(job_.look.field)) : job_.look.range;
  scene_->show(since_start_s, moments, range_);
  window_->Render();
  read(rgb);
}

Answer Picture::answer() const {
  Answer answer;
  answer.width = job_.width, answer.height = job_.height;
  answer.range = range_;
  answer.panes = static_cast<std::int32_t>(std::min(scene_->panes().size(), most_panes));
  for (std::int32_t k = 0; k < answer.panes; ++k) answer.pane[k] = scene_->panes()[k]->answer();
  return answer;
}

Picked Picture::at(const std::array<double, 2>& pixel) const {
  for (std::size_t k = 0; k < scene_->panes().size(); ++k) {
    const PaneView& pane = *scene_->panes()[k];
    if (!holds(pane.answer().picture, pixel)) continue;
    Picked picked = pane.at(pixel);
    picked.pane = static_cast<std::int32_t>(k);
    return picked;
  }
  return {};
}

void Picture::read(std::span<std::uint8_t> rgb) {
  window_->GetPixelData(0, 0, job_.width - 1, job_.height - 1, 0, pixels_, 0);
  const std::size_t row = std::size_t{3} * job_.width;
  const unsigned char* from = pixels_->GetPointer(0);
  for (int y = 0; y < job_.height; ++y)
    std::memcpy(rgb.data() + y * row, from + (job_.height - 1 - y) * row, row);
}

}  // namespace rift::viz
