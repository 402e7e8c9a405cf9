#pragma once

#include "studio/charts/chart.hpp"
#include "studio/reports/instruments_report.hpp"

#include <string>
#include <vector>

namespace rift::studio {

/// How a quantity is shown: its values times `factor`, in `unit`, which is enhanced text.
struct TraceScale {
  double factor = 1;
  std::string unit;
};
TraceScale scale_of(scene::Dimension dimension);

/// Grip force, strains and velocities of the gauges, stress intensities and release rates, and measured
/// curves.
std::vector<NamedChart> instrument_charts(const InstrumentsReport& report);

/// Displacement and strain across the crack as the camera saw them, half way and at the end.
std::vector<NamedChart> field_maps(const InstrumentsReport& report);

}  // namespace rift::studio
