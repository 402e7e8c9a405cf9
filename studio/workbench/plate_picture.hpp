#pragma once

#include "studio/screen/screen_picture.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

/// The plate of a run as a real picture, in place of its cells: the last stored moment, also while the run
/// goes on. Who shows it knows no renderer.
class PlatePicture {
 public:
  virtual ~PlatePicture() = default;
  /// What is to be seen where; called again and again.
  virtual void look(const Area& place, const PictureRoom& room, const std::vector<int>& lanes,
                    bool velocity) = 0;
  [[nodiscard]] virtual std::optional<ScreenPicture> picture() const = 0;
  /// Becomes readable when look() has something to do; or -1.
  [[nodiscard]] virtual int descriptor() const = 0;
  /// Why there is none; empty where there is one or soon will be.
  [[nodiscard]] virtual std::string trouble() const = 0;
};

/// Of the run in a folder; empty in a build without the renderer.
using MakePlatePicture = std::function<std::unique_ptr<PlatePicture>(const std::filesystem::path& run)>;

}  // namespace rift::studio
