#pragma once

#include "engine/base/cache.hpp"
#include "engine/scene/preset.hpp"
#include "engine/simulation/record.hpp"
#include "studio/screen/canvas.hpp"
#include "studio/screen/keymap.hpp"
#include "studio/screen/screen_picture.hpp"
#include "studio/workbench/plate_picture.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

// The workbench: screens on a stack. A screen draws itself into cells and answers keys; it knows no terminal.

class Screen;

/// Which screen comes after a key or a look.
struct Navigation {
  enum class To : std::uint8_t { stay, back, forward, replace } to = To::stay;
  std::unique_ptr<Screen> next = {};  // of forward and replace
};

class Screen {
 public:
  virtual ~Screen() = default;
  virtual void draw(Canvas& canvas, Glyphs glyphs) = 0;
  virtual Navigation press(const KeyEvent& event) = 0;
  /// Called before each drawing, some ten times a second: to look at what works in the background.
  virtual Navigation look() { return {}; }
  /// It is on the top again.
  virtual void resume() {}
  /// Whether letters are typed into it, so that none of them is a key.
  [[nodiscard]] virtual bool typing() const { return false; }
  [[nodiscard]] virtual Where where() const = 0;
  /// What to say should the program crash now.
  [[nodiscard]] virtual std::string last_words() const { return {}; }

  // A screen that also shows a picture, where the terminal can: it leaves the cells below it blank.

  [[nodiscard]] virtual bool wants_picture() const { return false; }
  /// Called before each look() where it wants one.
  virtual void take_room(const PictureRoom&) {}
  [[nodiscard]] virtual std::optional<ScreenPicture> picture() const { return {}; }
  /// Whether it wants to hear how the mouse moves while its button is down.
  [[nodiscard]] virtual bool wants_drags() const { return false; }
  /// How long a key is waited for before the next look(), and a descriptor that ends the waiting, or -1.
  [[nodiscard]] virtual int patience_ms() const { return 95; }  // the terminal draws on the same cores
  [[nodiscard]] virtual int wakened_by() const { return -1; }
};

/// What all screens share: where things are, and how things are run.
struct AppContext {
  std::filesystem::path presets, own_presets, runs = "runs", studies = "studies";
  std::filesystem::path program;  // rift itself, for what it does in the background
  base::Cache cache = {};
  simulation::BuildInfo build = {};
  int threads = 0;
  MakePlatePicture plate_picture = {};
};

struct RunRequest;

/// A run of the preset in this folder, by the means that all screens share.
[[nodiscard]] RunRequest request_for(const AppContext& context, scene::Preset preset,
                                     std::filesystem::path folder);

/// The first of folder/NAME, folder/NAME-2, ... that does not exist yet.
[[nodiscard]] std::filesystem::path free_folder(const std::filesystem::path& folder, const std::string& name);

// Which screen shows what. All throw with the reason where it cannot be shown.

std::unique_ptr<Screen> form_of_preset(AppContext& context, const std::filesystem::path& preset);
/// Starts it: a run or a study.
std::unique_ptr<Screen> screen_of_preset(AppContext& context, const std::filesystem::path& preset);
/// The same of a preset that has been read. @param name  of its folder; @param changed  against its file
std::unique_ptr<Screen> screen_of_preset(AppContext& context, const scene::Preset& preset,
                                         const std::string& name, bool changed);
/// Of a folder with a run or a study in it, going on or ended; a study is shown as far as it has been
/// computed.
std::unique_ptr<Screen> screen_of_run(AppContext& context, const std::filesystem::path& run);
/// Goes on with a run or a study that was stopped or killed.
std::unique_ptr<Screen> resumption_of(AppContext& context, const std::filesystem::path& run);
std::unique_ptr<Screen> comparison_of(AppContext& context, const std::vector<std::filesystem::path>& runs);
/// @param name  of a lesson
std::unique_ptr<Screen> lesson_screen(AppContext& context, const std::string& name);

}  // namespace rift::studio
