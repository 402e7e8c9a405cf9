#pragma once

#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"
#include "studio/screen/prompt.hpp"
#include "studio/workbench/dry_run_thread.hpp"
#include "studio/workbench/screen.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// A preset as a form: every parameter of the table with unit, range and doc, checked while it is typed, and
/// beside it what follows from it.
class FormScreen : public Screen {
 public:
  FormScreen(AppContext& context, std::filesystem::path preset);

  void draw(Canvas& canvas, Glyphs glyphs) override;
  Navigation press(const KeyEvent& event) override;
  Navigation look() override;
  [[nodiscard]] bool typing() const override { return value_.typing() || name_.typing() || search_.typing(); }
  [[nodiscard]] Where where() const override { return Where::form; }

 private:
  struct Row {
    const scene::Parameter* parameter = nullptr;  // null: the name of a table
    std::string table;
  };
  struct Change {
    std::string key, value;
  };

  void list_rows();
  void check();
  [[nodiscard]] std::vector<std::string> overrides() const;
  [[nodiscard]] const scene::Parameter* chosen() const;
  [[nodiscard]] std::string shown_value(const scene::Parameter& row) const;
  [[nodiscard]] std::string issue_of(const scene::Parameter& row) const;
  [[nodiscard]] bool is_changed(std::string_view key) const;
  void change(const std::string& key, const std::string& value);
  void take_back(const std::string& key);
  void skip_tables(int way);
  void draw_head(Canvas& canvas, const Area& area) const;
  void draw_rows(Canvas& canvas, const Area& area);
  void draw_row(Canvas& canvas, const Area& area, const Row& row, bool is_chosen) const;
  void draw_derived(Canvas& canvas, const Area& area) const;
  void draw_detail(Canvas& canvas, const Area& area) const;
  Navigation type(const KeyEvent& event);
  Navigation act(Action action);
  Navigation run();
  void save();

  using Clock = std::chrono::steady_clock;
  AppContext& context_;
  std::filesystem::path path_;
  std::vector<Change> changes_;
  scene::Preset preset_;
  std::vector<Row> rows_;
  ListView list_;
  Prompt value_, name_, search_;
  std::string before_;  // the change of the value that is being typed, to come back to
  bool had_change_ = false;
  std::string wanted_, message_;
  int list_rows_ = 10;
  DryRunThread dry_run_;
  Clock::time_point changed_ = Clock::now();
  bool dry_run_due_ = true;
};

}  // namespace rift::studio
