#pragma once

#include "engine/scene/preset.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

/// The lists of [study] while they are edited: each as one line, "0.3 c_r, 0.5 c_r".
class EditedGrid {
 public:
  struct List {
    std::string axis, values;
    bool operator==(const List&) const = default;
  };

  explicit EditedGrid(const std::vector<scene::GridAxis>& of_file);

  [[nodiscard]] const std::vector<List>& lists() const { return lists_; }
  /// The values of an axis; nothing where it is not varied.
  [[nodiscard]] std::optional<std::string> values_of(std::string_view axis) const;
  [[nodiscard]] bool is_changed(std::string_view axis) const { return values_of(axis) != of_file(axis); }
  /// How many axes differ from those of the file.
  [[nodiscard]] int changed() const;
  [[nodiscard]] std::vector<scene::GridAxis> grid() const;
  /// The axes that are not varied, in the order of their table.
  [[nodiscard]] std::vector<std::string_view> others() const;

  void set(std::string_view axis, std::string values);
  /// Varies an axis: over the file's values, else over that of the scene alone.
  void add(std::string_view axis, const scene::Scene& scene);
  void drop(std::string_view axis);
  /// As it is in the file.
  void take_back(std::string_view axis);

 private:
  [[nodiscard]] std::optional<std::string> of_file(std::string_view axis) const;

  std::vector<List> lists_, of_file_;
};

}  // namespace rift::studio
