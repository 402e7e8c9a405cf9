#pragma once

#include "studio/reports/instruments_report.hpp"
#include "studio/reports/study_report.hpp"

#include <string>
#include <vector>

namespace rift::studio {

struct NamedMap {
  std::string name, caption;
  HeatMap map;
};

/// Grip force, strains and velocities of the gauges, stress intensities and release rates, measured curves
/// laid over. What has no points is left out.
std::vector<NamedChart> instrument_charts(const InstrumentsReport& report);

/// Displacement and strain across the crack as the camera saw them, half way and at the end.
std::vector<NamedMap> field_maps(const InstrumentsReport& report);

/// How a quantity is drawn: its values times `factor`, in `unit`.
struct TraceScale {
  double factor = 1;
  std::string unit;
};
TraceScale scale_of(scene::Dimension dimension);

}  // namespace rift::studio
