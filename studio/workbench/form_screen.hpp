#pragma once

#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"
#include "studio/screen/prompt.hpp"
#include "studio/workbench/dry_run_thread.hpp"
#include "studio/workbench/edited_grid.hpp"
#include "studio/workbench/screen.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

/// A preset as a form: the axes of its study and every parameter of the table with unit, range and doc,
/// checked while it is typed, and beside it what follows from it.
class FormScreen : public Screen {
 public:
  FormScreen(AppContext& context, std::filesystem::path preset);

  void draw(Canvas& canvas, Glyphs glyphs) override;
  Navigation press(const KeyEvent& event) override;
  Navigation look() override;
  [[nodiscard]] bool typing() const override {
    return value_.typing() || name_.typing() || search_.typing() || leave_.typing() || adding_ || details_;
  }
  [[nodiscard]] Where where() const override { return Where::form; }

 private:
  struct Row {
    enum class Kind : std::uint8_t { heading, axis, add_axis, parameter } kind;
    std::string name;                             // of a table or an axis
    const scene::Parameter* parameter = nullptr;  // what is set, or what the axis varies
  };
  struct Change {
    std::string key, value;
    bool operator==(const Change&) const = default;
  };
  /// What is edited, to know whether it has been saved.
  struct Edits {
    std::vector<Change> changes;
    std::vector<EditedGrid::List> lists;
    bool operator==(const Edits&) const = default;
  };

  void list_rows();
  void list_study(bool all);
  void choose(Row::Kind kind, std::string_view name);
  void check();
  [[nodiscard]] std::vector<std::string> overrides() const;
  [[nodiscard]] Edits edits() const { return {changes_, grid_.lists()}; }
  [[nodiscard]] int changed() const { return static_cast<int>(changes_.size()) + grid_.changed(); }
  [[nodiscard]] const Row* chosen() const;
  [[nodiscard]] std::optional<std::string> change_of(std::string_view key) const;
  [[nodiscard]] std::string value_of(const Row& row) const;
  [[nodiscard]] std::string issue_of(const Row& row) const;
  [[nodiscard]] bool is_changed(const Row& row) const;
  /// The axis that varies a parameter, empty where none does.
  [[nodiscard]] std::string axis_of(const scene::Parameter& parameter) const;
  void set(const Row& row, const std::string& value);
  void take_back(const Row& row);
  [[nodiscard]] bool is_of_file(const scene::Parameter& parameter, const std::string& value) const;
  void drop_change(std::string_view key);
  void skip_headings(int way);
  void draw_head(Canvas& canvas, const Area& area) const;
  void draw_rows(Canvas& canvas, const Area& area);
  void draw_row(Canvas& canvas, const Area& area, const Row& row, bool is_chosen) const;
  int draw_derived(Canvas& canvas, const Area& area, int from, const char* key) const;
  int draw_all_derived(Canvas& canvas, const Area& area) const;
  void draw_details(Canvas& canvas, Glyphs glyphs);
  void draw_detail(Canvas& canvas, const Area& area) const;
  void draw_others(Canvas& canvas, Glyphs glyphs);
  Navigation type(const KeyEvent& event);
  void choose_other(const KeyEvent& event);
  void read_details(const KeyEvent& event);
  Navigation answer_leave();
  Navigation act(Action action);
  void open();
  void begin_adding();
  void remove_axis();
  void add_axis(std::string_view axis);
  Navigation run();
  bool save();

  using Clock = std::chrono::steady_clock;
  AppContext& context_;
  std::filesystem::path path_;
  scene::Preset file_;  // as it stands in the file
  std::vector<Change> changes_;
  EditedGrid grid_;
  Edits kept_;  // by the file or by the last preset that was saved
  scene::Preset preset_;
  std::vector<Row> rows_;
  ListView list_, others_;
  Prompt value_, name_, search_, leave_;
  std::string before_;  // the value that is being typed, to come back to
  bool adding_ = false, leaving_ = false, details_ = false;
  int details_from_ = 0;  // the first line of the details that is shown
  std::string wanted_, message_;
  int list_rows_ = 10, other_rows_ = 10;
  DryRunThread dry_run_;
  Clock::time_point changed_at_ = Clock::now();
  bool dry_run_due_ = true;
};

}  // namespace rift::studio
