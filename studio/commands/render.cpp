#include "engine/base/files.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/units.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/film_of_run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

struct RenderOptions : SessionOptions {
  FilmOptions look;
  std::vector<std::string> runs;
  std::string film, pictures, picture;
  std::string from, to;  // of the crack's time
  std::optional<double> at;
  int frames = 0;
  bool poster = false, force = false;
};

double time_of(const char* option, const std::string& text) {
  const scene::Parsed<double> time = scene::read_quantity(text, scene::Dimension::time);
  if (!time.value) throw viz::BadRequest(fmt::format("{} {}: {}", option, text, time.problem));
  return *time.value;
}

/// The moments of the plan that --from and --to leave.
std::vector<double> times_of(const RenderOptions& options, const viz::Plan& plan) {
  const double from = options.from.empty() ? plan.times_s.front() : time_of("--from", options.from);
  const double to = options.to.empty() ? plan.times_s.back() : time_of("--to", options.to);
  std::vector<double> times;
  std::copy_if(plan.times_s.begin(), plan.times_s.end(), std::back_inserter(times),
               [&](double t) { return t >= from && t <= to; });
  if (times.empty())
    throw viz::BadRequest(fmt::format(
        "no frame is stored from {} to {}: the stored frames reach from {} to {}",
        scene::quantity_text(from, scene::Dimension::time), scene::quantity_text(to, scene::Dimension::time),
        scene::rounded_text(plan.times_s.front(), scene::Dimension::time),
        scene::rounded_text(plan.times_s.back(), scene::Dimension::time)));
  return options.frames > 0 ? viz::evenly_chosen(times, options.frames) : times;
}

/// Before anything is drawn: a file that is there is kept without --force, and a new one needs its folder.
void check_file(const fs::path& path, bool force) {
  if (!force && fs::exists(path))
    throw results::FolderExists(fmt::format("{} exists already: --force replaces it", path.string()));
  base::check_target(path);
}

/// A folder of pictures, which is made where it is not there.
void check_folder_of_pictures(const fs::path& path, bool force) {
  if (force || !fs::exists(path) || (fs::is_directory(path) && fs::is_empty(path))) return;
  throw results::FolderExists(fmt::format("{} exists already: --force replaces it", path.string()));
}

/// Shows how many frames are drawn; Ctrl-C is heard there.
viz::Making making_of(const RenderOptions& options, Session& session, std::string what) {
  const double start_s = session.seconds();
  return {.gl = gl_of(options.look),
          .go_on = [&session, start_s, what = std::move(what)](std::size_t done, std::size_t all) {
            const double rate = static_cast<double>(done) / (session.seconds() - start_s);
            return session.progress(what, static_cast<double>(done) / static_cast<double>(all),
                                    done > 0 ? fmt::format("{:.1f} frames/s", rate) : std::string{});
          }};
}

/// The moment when the crack has made six tenths of its way: enough is cut to be seen, and something is left.
double poster_time(const viz::Plan& plan) {
  const double tip = plan.tips_m.front() + 0.6 * (plan.tips_m.back() - plan.tips_m.front());
  for (std::size_t k = 0; k < plan.tips_m.size(); ++k)
    if (plan.tips_m[k] >= tip) return plan.times_s[k];
  return plan.times_s.back();
}

void draw_picture(const RenderOptions& options, const viz::Plan& plan, double time_s, const fs::path& path,
                  const viz::Making& making) {
  check_file(path, options.force);
  viz::make_picture(plan.job, time_s, path, making);
  base::print_path(path);
}

/// Where ffmpeg fails, the frames are drawn as pictures instead.
ExitCode draw_film(const RenderOptions& options, const viz::Plan& plan, const std::vector<double>& times,
                   const fs::path& path, Session& session) {
  check_file(path, options.force);
  try {
    viz::make_film(plan.job, times, rate_of(options.look, times.size()), path,
                   making_of(options, session, path.filename().string()));
    session.line.clear();
    base::print_path(path);
    return ExitCode::done;
  } catch (const viz::FilmFailed& failure) {
    fs::path folder = path;
    folder.replace_extension();
    folder += "_frames";
    session.message(std::string(failure.what()) + "; the frames are drawn as pictures instead");
    check_folder_of_pictures(folder, options.force);
    viz::make_pictures(plan.job, times, folder, making_of(options, session, folder.filename().string()));
    session.line.clear();
    base::print_path(folder);
    return ExitCode::world_failed;
  }
}

/// The files that are asked for by name, before the first of them is drawn.
void check_files(const RenderOptions& options) {
  if (!options.film.empty() && !viz::is_film_name(options.film))
    throw viz::BadRequest(fmt::format("--film {}: must end in .mp4, .webm or .gif", options.film));
  for (const std::string& file : {options.film, options.picture})
    if (!file.empty()) check_file(file, options.force);
  if (!options.pictures.empty()) check_folder_of_pictures(options.pictures, options.force);
}

ExitCode draw(const RenderOptions& options, const viz::Plan& plan, Session& session) {
  const fs::path run = options.runs.front();
  const std::string& field = plan.job.look.field;
  if (options.at) {
    const auto k =
        static_cast<std::size_t>(std::lround(*options.at * static_cast<double>(plan.times_s.size() - 1)));
    const fs::path path = options.picture.empty() ? run / fmt::format("{}_at_{:.2f}.png", field, *options.at)
                                                  : fs::path(options.picture);
    draw_picture(options, plan, plan.times_s[k], path, making_of(options, session, "picture"));
  }
  const std::vector<double> times = times_of(options, plan);
  if (!options.pictures.empty()) {
    check_folder_of_pictures(options.pictures, options.force);
    viz::make_pictures(plan.job, times, options.pictures, making_of(options, session, "pictures"));
    base::print_path(options.pictures);
  }
  const bool nothing_else = !options.at && options.pictures.empty() && !options.poster;
  fs::path film = options.film;
  if (film.empty() && nothing_else) film = run / fmt::format("film_{}.mp4", field);
  ExitCode code = ExitCode::done;
  if (!film.empty()) code = draw_film(options, plan, times, film, session);
  if (options.poster) {
    viz::Plan large = plan;
    large.job.look.large_text = true;
    fs::path path = film.empty() ? run / fmt::format("poster_{}.png", field) : film;
    draw_picture(options, large, poster_time(plan), path.replace_extension(".png"),
                 making_of(options, session, "poster"));
  }
  return code;
}

ExitCode render(RenderOptions options) try {
  for (const std::string& note : read_look(options.look)) base::message("rift render: {}\n", note);
  check_files(options);
  for (const std::string& run : options.runs) {
    check_is_run(run);
    options.look.request.runs.emplace_back(run);
  }
  const viz::Plan plan = viz::plan_of(options.look.request);
  for (const std::string& note : plan.notes) base::message("rift render: {}\n", note);
  Session session("rift render", options);
  try {
    return draw(options, plan, session);
  } catch (const viz::Stopped&) {
    session.message("stopped; no incomplete file is left");
    return session.stopped();
  }
} catch (const viz::BadRequest& mistake) {
  base::message("rift render: {}\n", mistake.what());
  return ExitCode::bad_input;
}

}  // namespace

void add_render(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("render", "Films and pictures of a run, without a display");
  const auto options = std::make_shared<RenderOptions>();
  add_drawn_runs(command, options->runs, options->look, "drawn");
  command
      .add_option("--film", options->film,
                  "Film: .mp4, .webm or .gif (default: film_FIELD.mp4 in the run's folder)")
      ->type_name("FILE");
  command
      .add_option("--frames", options->frames,
                  "Number of frames, chosen evenly from the stored ones (default: all)")
      ->check(CLI::Range(1, 1000000));
  command.add_option("--from", options->from, "Film and pictures from this time of the crack on: \"12 us\"")
      ->type_name("TIME");
  command.add_option("--to", options->to, "Film and pictures up to this time of the crack")
      ->type_name("TIME");
  command.add_option("--png", options->pictures, "Folder for the frames as pictures")->type_name("FOLDER");
  command.add_option("--at", options->at, "One picture, at this fraction of the stored frames")
      ->check(CLI::Range(0.0, 1.0));
  command.add_option("--picture", options->picture, "File of the one picture (default: in the run's folder)")
      ->type_name("FILE");
  command.add_flag("--poster", options->poster,
                   "A picture with large text, where the crack has run six tenths of its path");
  command.add_flag("-f,--force", options->force, "Replace existing files");
  command.add_flag("-q,--quiet", options->quiet, "No progress");
  command.add_flag("-j,--json", options->json, "Progress as JSON lines on standard error");
  add_film_options(command, options->look);
  command.callback([options, &exit_code] { exit_code = render(*options); });
}

}  // namespace rift::studio
