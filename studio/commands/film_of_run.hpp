#pragma once

#include "engine/scene/preset.hpp"
#include "studio/commands/session.hpp"
#include "viz/plan.hpp"
#include "viz/record.hpp"

#include <CLI/App.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace rift::studio {

/// How a film looks, as options say it; what is not said is as the run's preset has it.
struct FilmOptions {
  viz::Request request;
  std::string size = "1280x720", range, view, gl = "auto";
  bool no_chart = false, no_text = false;
  double fps = 0;  // 0: so that a film lasts about eight seconds
};

/// --field, --size, --camera, ... @param several_lanes  whether lanes can be chosen
void add_film_options(CLI::App& command, FilmOptions& options);

/// The runs that are drawn, one to four, and --lane.
/// @param done  "drawn", "shown"
void add_drawn_runs(CLI::App& command, std::vector<std::string>& runs, FilmOptions& options,
                    const std::string& done);

/// Reads size and range into the request. @return what was changed of them, for the user. Throws
/// viz::BadRequest.
std::vector<std::string> read_look(FilmOptions& options);

viz::Gl gl_of(const FilmOptions& options);

/// Frames a second of a film of `frames`.
double rate_of(const FilmOptions& options, std::size_t frames);

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
  /// The run has ended: waits for the film, showing how far it is; a stop gives it up.
  Result finish(Session& session);

 private:
  struct Maker;
  std::unique_ptr<Maker> maker_;
};

}  // namespace rift::studio
