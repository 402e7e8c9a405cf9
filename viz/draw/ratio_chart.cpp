#include "viz/draw/ratio_chart.hpp"

#include <fmt/format.h>
#include <vtkAxis.h>
#include <vtkPen.h>

#include <algorithm>
#include <array>

namespace rift::viz {
namespace {

/// Of a pane. Colours after Okabe and Ito (2008), none of which is of the budget's.
struct PaneLine {
  std::array<unsigned char, 3> colour;
  int pen;
};
constexpr std::array<PaneLine, 4> pane_lines{{{{0, 0, 0}, vtkPen::SOLID_LINE},
                                              {{86, 180, 233}, vtkPen::SOLID_LINE},
                                              {{0, 0, 0}, vtkPen::DASH_LINE},
                                              {{86, 180, 233}, vtkPen::DASH_LINE}}};

const PaneLine& line_of(std::size_t pane) { return pane_lines[pane % pane_lines.size()]; }

}  // namespace

std::vector<KeyEntry> ratio_key(std::size_t panes) {
  std::vector<KeyEntry> key;
  for (std::size_t k = 0; panes > 1 && k < panes; ++k) {
    const auto& [colour, pen] = line_of(k);
    key.push_back({fmt::format("ratio of plate {}", k + 1),
                   {colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0},
                   pen != vtkPen::SOLID_LINE});
  }
  return key;
}

RatioChart::RatioChart(vtkRenderer& renderer, const Box& box, int text_px, std::size_t panes, double length_m)
    : moment_(*chart_, text_px) {
  constexpr double mm = 1e-3;
  style(*chart_->GetAxis(vtkAxis::BOTTOM), text_px, "tip [mm]", 0, length_m / mm);
  style(*chart_->GetAxis(vtkAxis::LEFT), text_px, "G_ID/G_I0", 0, 1);
  for (std::size_t k = 0; k < panes; ++k)
    line_.emplace_back(*chart_, line_of(k).colour, 0.16 * text_px, line_of(k).pen);
  put(*chart_, box, renderer);
}

void RatioChart::show(const std::vector<std::span<const results::RatePoint>>& rates, double tip_m) {
  constexpr double mm = 1e-3, least_top = 1.2, most_top = 3;
  double top = least_top;
  for (std::size_t k = 0; k < line_.size(); ++k) {
    std::vector<std::array<double, 2>> points;
    for (const results::RatePoint& p : rates[k]) {
      points.push_back({p.tip_m / mm, p.ratio});
      top = std::max(top, std::min(p.ratio, most_top));
    }
    line_[k].show(points);
  }
  chart_->GetAxis(vtkAxis::LEFT)->SetRange(0, top);
  moment_.show(tip_m / mm, top);
}

}  // namespace rift::viz
