#pragma once

#include "engine/scene/preset.hpp"
#include "studio/report/progress.hpp"

#include <CLI/App.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace rift::studio {

/// `rift run --render`: the film of a run, made while it goes on as far as can be. What goes wrong with it
/// never touches the run.
class FilmOfRun {
 public:
  /// Adds --render and the options of a film's look to a command; a build without the renderer says so when
  /// it is asked.
  explicit FilmOfRun(CLI::App& command);
  ~FilmOfRun();

  /// Whether the user asked for a film.
  [[nodiscard]] bool wanted() const;
  /// Reads the options. @return what is wrong with them for this preset, before anything was computed; empty:
  /// nothing
  /// @param force  a film that is there already may be replaced
  [[nodiscard]] std::string trouble_with(const scene::Preset& preset, bool force);
  /// The run's journal is there, or will be, and grows. @param core_free  whether the run leaves a core; else
  /// its film waits for its end, for threads that wait for one another bear no disturbance
  void begin(const std::filesystem::path& run, bool core_free);

  /// How it ended: the film, or what went wrong.
  struct Result {
    std::string path, trouble;
  };
  /// The run has ended: waits for the film, telling how far it is. @param go_on  false gives it up
  Result finish(ProgressLine& line, const std::function<bool()>& go_on);

 private:
  struct Maker;
  std::unique_ptr<Maker> maker_;
};

}  // namespace rift::studio
