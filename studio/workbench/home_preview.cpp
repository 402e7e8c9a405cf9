#include "studio/workbench/home_preview.hpp"

#include "engine/results/archive.hpp"
#include "studio/screen/plate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

constexpr auto chosen_for_a_moment = std::chrono::milliseconds(300);

}  // namespace

void HomePreview::toggle() {
  on_ = !on_;
  let_go();
}

void HomePreview::let_go() {
  take_away();
  chosen_.clear();
}

/// What is still being packed ends in the background.
void HomePreview::take_away() {
  plate_.show_cells();
  run_.reset();
  if (specimen_) {
    specimen_->stop();
    given_up_.push_back(std::move(specimen_));
  }
  trouble_.clear();
  begun_ = false;
}

void HomePreview::look(const std::filesystem::path& chosen, bool is_run) {
  std::erase_if(given_up_, [](const auto& one) { return one->ended(); });
  if (!on_) return;
  if (chosen != chosen_) {
    take_away();
    chosen_ = chosen;
    since_ = Clock::now();
  }
  if (chosen_.empty()) return;
  if (!begun_ && Clock::now() - since_ > chosen_for_a_moment) begin(is_run);
  if (specimen_) specimen_->look();
  const bool there = run_ || (specimen_ && specimen_->there() && !specimen_->ended());
  if (there && trouble_.empty() && plate_.can() && !plate_.on() && plate_.room().pictures)
    trouble_ = plate_.show({run_ ? chosen_ : specimen_->run()});
  plate_.look(place_, {.lanes = {0}});
}

void HomePreview::begin(bool is_run) try {
  begun_ = true;
  if (!is_run) {
    specimen_ = std::make_unique<SpecimenPreview>(context_, chosen_);
  } else if (std::filesystem::exists(chosen_ / results::journal_name)) {
    run_.emplace(chosen_);
  } else {
    trouble_ = "a study has no plate of its own";
  }
} catch (const std::exception& error) {
  trouble_ = error.what();
}

const Live* HomePreview::live() const {
  if (run_) return &run_->live();
  return specimen_ && specimen_->live().geometry != nullptr ? &specimen_->live() : nullptr;
}

void HomePreview::draw(Canvas& canvas, const Area& area, Glyphs glyphs) {
  place_ = {};
  if (area.empty() || !on_) return;
  const Live* shown = live();
  const std::string state = !trouble_.empty() ? trouble_ : specimen_ ? specimen_->state() : std::string();
  if (!state.empty() || shown == nullptr) {
    draw_paragraph(canvas, area, state, {Ink::dim});
    return;
  }
  const results::Geometry& geometry = *shown->geometry;
  canvas.text(area.x, area.y,
              fmt::format("{:.4g} x {:.4g} mm, {} elements, {} beams", 1e3 * shown->length,
                          1e3 * shown->height, geometry.position.size(), geometry.beam.size()),
              {}, area.width);
  canvas.text(area.x, area.y + 1,
              run_ ? "vertical displacement at the last stored moment"
                   : "vertical displacement as the crack starts",
              {Ink::dim}, area.width);
  constexpr double around = 1.3;  // of a picture, beside its plate
  const double rows = around * area.width / 2 * (shown->height + shown->pulled) / std::max(1e-9, shown->length);
  place_ = {area.x, area.y + 2, area.width, std::min(area.height - 2, static_cast<int>(std::ceil(rows)))};
  if (place_.empty()) return;
  if (plate_.in_pixels()) return plate_.draw_trouble(canvas, place_);
  if (shown->lanes.empty()) return;
  const LiveLane& lane = shown->lanes.front();
  draw_plate(canvas, place_, geometry, lane.displacement,
             {.length = shown->length, .height = shown->height, .pulled = shown->pulled, .tips = lane.tips},
             glyphs);
}

}  // namespace rift::studio
