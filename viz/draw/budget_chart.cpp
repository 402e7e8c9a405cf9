#include "viz/draw/budget_chart.hpp"

#include <vtkAxis.h>
#include <vtkFloatArray.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace rift::viz {
namespace {

/// A line of the budget. Colours after Okabe and Ito (2008), apart for the colour-blind.
struct Entry {
  const char* name;
  double results::Sample::*energy;
  std::array<unsigned char, 3> colour;
  int line = vtkPen::SOLID_LINE;  // kinetic and fracture are near to one another for the colour-blind
};
constexpr Entry entries[] = {
    {"elastic", &results::Sample::elastic_j, {0, 114, 178}},
    {"kinetic", &results::Sample::kinetic_translation_j, {230, 159, 0}, vtkPen::DASH_LINE},
    {"fracture", &results::Sample::fracture_j, {213, 94, 0}},
    {"damping", &results::Sample::damping_j, {0, 158, 115}, vtkPen::DASH_DOT_LINE},
    {"contact", &results::Sample::contact_j, {204, 121, 167}, vtkPen::DOT_LINE}};
constexpr double microsecond = 1e-6;

std::vector<Entry> shown(const BudgetLines& lines) {
  std::vector<Entry> some;
  for (const Entry& entry : entries) {
    if (entry.energy == &results::Sample::damping_j && !lines.damping) continue;
    if (entry.energy == &results::Sample::contact_j && !lines.contact) continue;
    some.push_back(entry);
  }
  return some;
}

double energy_of(double results::Sample::*energy, const results::Sample& s) {
  const bool kinetic = energy == &results::Sample::kinetic_translation_j;
  return s.*energy + (kinetic ? s.kinetic_rotation_j : 0);
}

}  // namespace

BudgetLines budget_lines(std::span<const results::Sample> samples) {
  constexpr double enough = 1e-3;
  double stored = 0, contact = 0;
  BudgetLines lines;
  for (const results::Sample& s : samples) {
    lines.damping = lines.damping || s.damping_j != 0;
    stored = std::max(stored, s.elastic_j), contact = std::max(contact, std::abs(s.contact_j));
  }
  lines.contact = contact > enough * stored;
  return lines;
}

std::vector<KeyEntry> budget_key(const BudgetLines& lines) {
  std::vector<KeyEntry> key;
  for (const Entry& entry : shown(lines))
    key.push_back({entry.name,
                   {entry.colour[0] / 255.0, entry.colour[1] / 255.0, entry.colour[2] / 255.0},
                   entry.line != vtkPen::SOLID_LINE});
  return key;
}

BudgetChart::BudgetChart(vtkRenderer& renderer, const Box& box, int text_px, const std::string& since,
                         double lasts_s, const BudgetLines& lines, bool with_moment) {
  vtkNew<vtkFloatArray> time;
  time->SetName("t");
  table_->AddColumn(time);
  const bool is_wide = box.width() > 24 * text_px;
  const std::string title = is_wide ? "time since " + since + " [µs]" : "time [µs]";
  style(*chart_->GetAxis(vtkAxis::BOTTOM), text_px, title.c_str(), 0, lasts_s / microsecond);
  style(*chart_->GetAxis(vtkAxis::LEFT), text_px, "energy [J]", 0, 1);
  for (const Entry& entry : shown(lines)) {
    vtkNew<vtkFloatArray> column;
    column->SetName(entry.name);
    table_->AddColumn(column);
    energy_.push_back(entry.energy);
    vtkPlot* line = chart_->AddPlot(vtkChart::LINE);
    line->SetInputData(table_, 0, static_cast<vtkIdType>(energy_.size()));
    line->SetColor(entry.colour[0], entry.colour[1], entry.colour[2], 255);
    line->SetWidth(static_cast<float>(0.16 * text_px));
    line->GetPen()->SetLineType(entry.line);
  }
  if (with_moment) moment_.emplace(*chart_, text_px);
  put(*chart_, box, renderer);
}

void BudgetChart::show(std::span<const results::Sample> samples, double start_s, double moment_s,
                       double most_j) {
  chart_->GetAxis(vtkAxis::LEFT)->SetRange(0, 1.05 * most_j);
  if (moment_) moment_->show(moment_s / microsecond, 1.05 * most_j);
  // A line has two points: the first row stands twice.
  const std::size_t rows = samples.empty() ? 0 : samples.size() + 1;
  table_->SetNumberOfRows(static_cast<vtkIdType>(rows));
  for (std::size_t row = 0; row < rows; ++row) {
    const results::Sample& s = samples[row == 0 ? 0 : row - 1];
    const auto r = static_cast<vtkIdType>(row);
    table_->SetValue(r, 0, (s.time_s - start_s) / microsecond);
    for (std::size_t k = 0; k < energy_.size(); ++k)
      table_->SetValue(r, static_cast<vtkIdType>(k + 1), energy_of(energy_[k], s));
  }
  for (std::size_t k = 0; k < energy_.size(); ++k)
    chart_->GetPlot(static_cast<vtkIdType>(k))->SetVisible(rows > 0);
  table_->Modified();
}

}  // namespace rift::viz
