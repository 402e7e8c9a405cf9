#pragma once

#include <cstdint>
#include <vector>

namespace rift::viz {

/// A disc as it is drawn, seen from the front [m].
struct Disc {
  double x = 0, y = 0, radius = 0;
};

/// A raster over the plate, on which discs are laid down: it knows which of its cells are covered.
class CoveredCells {
 public:
  /// @param cell  their side [m]
  CoveredCells(const std::vector<Disc>& discs, double cell);

  /// The share of the disc's cells that nothing covers yet; they are covered then. A cell belongs to the disc
  /// where its middle does.
  double cover(const Disc& disc);

  /// The middles of cells that are bare: groups of neighbours that covered cells surround.
  [[nodiscard]] std::vector<std::vector<Disc>> enclosed() const;

 private:
  [[nodiscard]] int column_at(double x) const;
  [[nodiscard]] int row_at(double y) const;
  /// The bare cells that are joined to this one by sides and corners; they are marked as seen.
  [[nodiscard]] std::vector<std::size_t> group_of(std::size_t cell, std::vector<bool>& seen) const;

  double cell_, x0_ = 0, y0_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<bool> taken_;
};

}  // namespace rift::viz
