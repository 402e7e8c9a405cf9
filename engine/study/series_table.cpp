#include "engine/study/series_table.hpp"

#include <charconv>
#include <fstream>
#include <limits>
#include <string_view>

namespace rift::study {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    fields.push_back(line.substr(from, to - from));
    from = to + 1;
  }
  return fields;
}

double number(std::string_view field) {
  double value = undefined;
  std::from_chars(field.data(), field.data() + field.size(), value);
  return value;
}

}  // namespace

SeriesTable read_series(const std::filesystem::path& path) {
  SeriesTable table;
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) return table;
  std::vector<std::string> names;
  for (std::string_view name : fields_of(line)) names.emplace_back(name);
  while (std::getline(file, line)) {
    const std::vector<std::string_view> fields = fields_of(line);
    if (fields.size() != names.size()) continue;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (names[k] == "phase") {
        table.phase.emplace_back(fields[k]);
      } else {
        table.column[names[k]].push_back(number(fields[k]));
      }
    }
  }
  return table;
}

Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 3) return {undefined, undefined};
  const auto n = static_cast<double>(x.size());
  double mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) mx += x[k] / n, my += y[k] / n;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mx) * (x[k] - mx);
    xy += (x[k] - mx) * (y[k] - my);
    yy += (y[k] - my) * (y[k] - my);
  }
  return {xy / xx, yy > 0.0 ? xy * xy / (xx * yy) : 1.0};
}

}  // namespace rift::study
