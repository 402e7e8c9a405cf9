#pragma once

#include "studio/screen/screen_picture.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

/// What of the runs a picture shows.
struct PlateView {
  std::vector<int> lanes = {};  // of each run; none: all
  bool velocity = false;   // colours of the vertical velocity, not of the displacement
  bool titles = false;     // and times above the plates, where texts in a picture can be read
  double until = 1;        // which of the stored moments: 0 the first, 1 the last
};

/// The plates of runs as a real picture, in place of their cells; also while they go on. Who shows it knows
/// no renderer.
class PlatePicture {
 public:
  virtual ~PlatePicture() = default;
  /// What is to be seen where; called again and again.
  virtual void look(const Area& place, const PictureRoom& room, const PlateView& view) = 0;
  [[nodiscard]] virtual std::optional<ScreenPicture> picture() const = 0;
  /// Becomes readable when look() has something to do; or -1.
  [[nodiscard]] virtual int descriptor() const = 0;
  /// Why there is none; empty where there is one or soon will be.
  [[nodiscard]] virtual std::string trouble() const = 0;
};

/// Of the runs in some folders; empty in a build without the renderer.
using MakePlatePicture =
    std::function<std::unique_ptr<PlatePicture>(const std::vector<std::filesystem::path>& runs)>;

}  // namespace rift::studio
