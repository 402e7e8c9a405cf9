#pragma once

#include "studio/report/chart.hpp"

#include <string>

namespace rift::studio {

/// A chart of release rates against velocity with Broberg, Freund and the strip limit in it, and nothing else
/// yet.
Chart chart_of_references(const std::string& title);

}  // namespace rift::studio
