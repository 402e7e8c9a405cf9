#include "engine/results/crack_tip.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace rift::results {
namespace {

using Point = std::array<double, 2>;

double distance(const Point& a, const Point& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

Point point_at(const std::vector<Point>& path, double arc) {
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const double piece = distance(path[k], path[k + 1]);
    if (arc > piece && k + 2 < path.size()) {
      arc -= piece;
      continue;
    }
    const double part = piece > 0 ? arc / piece : 0;
    return {path[k][0] + part * (path[k + 1][0] - path[k][0]),
            path[k][1] + part * (path[k + 1][1] - path[k][1])};
  }
  return path.front();
}

}  // namespace

std::vector<Point> path_of(const nlohmann::ordered_json& header) {
  return header.at("path").get<std::vector<Point>>();
}

std::vector<Point> tips_at(const nlohmann::ordered_json& header, double tip_m) {
  const std::vector<Point> path = path_of(header);
  if (header.value("tips", 1) == 0) return {};
  if (header.value("tips", 1) == 1) return {point_at(path, tip_m)};
  double length = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) length += distance(path[k], path[k + 1]);
  return {point_at(path, 0.5 * length - tip_m), point_at(path, 0.5 * length + tip_m)};
}

}  // namespace rift::results
