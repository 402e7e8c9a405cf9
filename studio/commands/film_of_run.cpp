#include "studio/commands/film_of_run.hpp"

#include "engine/base/console.hpp"
#include "engine/base/files.hpp"
#include "engine/base/ownership.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "viz/field.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <thread>

namespace rift::studio {
namespace {

template <typename Rows>
std::vector<std::string> names_of(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.emplace_back(row.name);
  return names;
}

/// Two numbers with one of `between` between them; false where the text is anything else.
template <typename Number>
bool read_two(const std::string& text, char between, Number& a, Number& b) {
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, a);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != between) return false;
  const auto second = std::from_chars(first.ptr + 1, end, b);
  return second.ec == std::errc{} && second.ptr == end;
}

void read_size(FilmOptions& options, std::vector<std::string>& notes) {
  constexpr int least_width = 320, least_height = 180, most = 8192;
  int &width = options.request.width, &height = options.request.height;
  if (!read_two(options.size, 'x', width, height))
    throw viz::BadRequest(
        fmt::format("--size {}: expected a width and a height in pixels such as 1280x720", options.size));
  if (width < least_width || height < least_height || width > most || height > most)
    throw viz::BadRequest(fmt::format("--size {}: must lie between {}x{} and {}x{}", options.size,
                                      least_width, least_height, most, most));
  if (width % 2 == 0 && height % 2 == 0) return;
  width += width % 2;
  height += height % 2;
  notes.push_back(
      fmt::format("--size {}: drawn as {}x{}, because films need even numbers", options.size, width, height));
}

viz::View read_view(const std::string& text) {
  std::array<double, 5> number{};
  const char *at = text.data(), *end = at + text.size();
  for (std::size_t k = 0; k < number.size(); ++k) {
    const auto read = std::from_chars(at, end, number[k]);
    const bool goes_on = k + 1 < number.size();
    if (read.ec != std::errc{} || (goes_on ? read.ptr == end || *read.ptr != ',' : read.ptr != end) ||
        !std::isfinite(number[k]))
      throw viz::BadRequest(fmt::format(
          "--view {}: expected five numbers X,Y,HEIGHT,TURN,TILT in mm and degrees such as 100,20,50,0,0",
          text));
    at = read.ptr + 1;
  }
  const auto [x_mm, y_mm, height_mm, turn, tilt] = number;
  if (!(height_mm > 0)) throw viz::BadRequest(fmt::format("--view {}: HEIGHT must be positive", text));
  constexpr double mm = 1e-3, degree = std::numbers::pi / 180;
  return {x_mm * mm, y_mm * mm, height_mm * mm, turn * degree, tilt * degree};
}

}  // namespace

void add_film_options(CLI::App& command, FilmOptions& options) {
  viz::Request& request = options.request;
  const std::string group = "Appearance (unset options default to the preset's [film])";
  const auto add = [&](const char* name, auto& value, const char* text) {
    return command.add_option(name, value, text)->group(group);
  };
  add("--field", request.field, "Field of the colours")
      ->type_name("NAME")
      ->check(CLI::IsMember(names_of(viz::fields())));
  add("--colours", request.colours, "Colour map")
      ->type_name("NAME")
      ->check(CLI::IsMember(names_of(viz::colour_maps())));
  add("--range", options.range,
      "Range of the colour bar in its unit, such as 0,2, or moment for that of each moment (default: the "
      "range of all panes)")
      ->type_name("A,B|moment");
  add("--camera", request.camera,
      "plate: the whole plate; tip: a close-up that follows the tip; side: the out-of-plane displacement")
      ->type_name("NAME")
      ->check(CLI::IsMember({"plate", "tip", "side"}));
  add("--view", options.view,
      "A camera by numbers, as c in rift view prints them: the point in the middle [mm], the height that is "
      "shown [mm], and angles of turn and tilt [degrees]")
      ->type_name("X,Y,HEIGHT,TURN,TILT");
  add("--beams", request.beams, "Beams drawn: none, those on the crack's path, all")
      ->type_name("NAME")
      ->check(CLI::IsMember({"none", "crossing", "all"}));
  add("--magnification", request.magnification, "Magnification of the displacements")
      ->check(CLI::Range(0.0, 1000.0));
  add("--close-up", request.close_up_m, "Height of a close-up [m]")->check(CLI::Range(1e-6, 100.0));
  add("--title", request.title, "Title above the picture")->type_name("TITLE");
  CLI::Option* chart =
      add("--chart", request.chart,
          "Under the picture: none, growing: the energy budget up to the moment, whole: energy budget and "
          "G_ID/G_I0 of the whole run with a line at the moment")
          ->type_name("NAME")
          ->check(CLI::IsMember({"none", "growing", "whole"}));
  command.add_flag("--no-chart", options.no_chart, "The same as --chart none")->group(group)->excludes(chart);
  command.add_flag("--no-text", options.no_text, "Leave out titles, colour bars and scales")->group(group);
  command.add_flag("--large-text", request.large_text, "Large text for lecture halls")->group(group);
  add("--size", options.size, "Width and height in pixels")->type_name("WxH")->capture_default_str();
  add("--fps", options.fps, "Frames per second (default: a film of about 8 s)")
      ->check(CLI::Range(0.1, 240.0));
  add("--gl", options.gl, "OpenGL: osmesa, egl, or auto for the first that works")
      ->type_name("NAME")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}))
      ->capture_default_str();
}

void add_drawn_runs(CLI::App& command, std::vector<std::string>& runs, FilmOptions& options,
                    const std::string& done) {
  command
      .add_option("run", runs,
                  fmt::format("Folders of one to four runs, {} with one clock and one colour scale", done))
      ->type_name("FOLDER")
      ->required();
  command
      .add_option("--lane", options.request.lanes,
                  "Lane of each run; repeat the option for more lanes (default: all)")
      ->check(CLI::NonNegativeNumber);
}

std::vector<std::string> read_look(FilmOptions& options) {
  std::vector<std::string> notes;
  read_size(options, notes);
  if (options.no_chart) options.request.chart = viz::word_of(viz::Chart::none);
  options.request.texts = !options.no_text;
  if (!options.view.empty()) options.request.view = read_view(options.view);
  options.request.range_of_moment = options.range == "moment";
  if (!options.range.empty() && !options.request.range_of_moment) {
    std::array<double, 2> range{};
    if (!read_two(options.range, ',', range[0], range[1]) || !(range[0] < range[1]))
      throw viz::BadRequest(
          fmt::format("--range {}: expected two ascending numbers such as 0,2", options.range));
    options.request.range = range;
  }
  return notes;
}

viz::Gl gl_of(const FilmOptions& options) {
  return options.gl == "osmesa" ? viz::Gl::osmesa : options.gl == "egl" ? viz::Gl::egl : viz::Gl::any;
}

double rate_of(const FilmOptions& options, std::size_t frames) {
  constexpr double lasts_s = 8;
  return options.fps > 0 ? options.fps : std::clamp(static_cast<double>(frames) / lasts_s, 5.0, 30.0);
}

namespace fs = std::filesystem;
namespace {

constexpr auto between_looks = std::chrono::milliseconds(200);

}  // namespace

struct FilmOfRun::Maker {
  bool asked = false, core_free = true;
  std::string film;
  FilmOptions options;
  std::optional<base::HeldFile> former;  // journal of a run that this one replaces
  std::atomic<bool> run_ended = false, given_up = false, made = false;
  std::atomic<std::size_t> done = 0, all = 1;
  std::size_t frames_expected = 0;
  Result result;
  std::jthread thread;

  [[nodiscard]] bool wanted() const { return asked || !film.empty(); }

  viz::Making making() {
    return {.gl = gl_of(options), .idle = !run_ended, .go_on = [this](std::size_t now, std::size_t of) {
              done = now;
              all = of;
              return !given_up;
            }};
  }

  void wait_for_the_run() const {
    while (!run_ended && !given_up) std::this_thread::sleep_for(between_looks);
  }

  /// One lane whose colours are known beforehand is drawn while the run goes on; anything else when it has
  /// ended.
  void make() {
    if (!core_free) wait_for_the_run();
    viz::Plan plan = first_plan();
    const fs::path path = film.empty()
                              ? plan.job.panes.front().run / fmt::format("film_{}.mp4", plan.job.look.field)
                              : fs::path(film);
    if (plan.job.panes.size() == 1 && plan.range_known && !run_ended) {
      viz::follow_film(plan.job, rate_of(options, frames_expected), path, making(), run_ended);
    } else {
      wait_for_the_run();
      plan = viz::plan_of(options.request);
      viz::make_film(plan.job, plan.times_s, rate_of(options, plan.times_s.size()), path, making());
    }
    result.path = path.string();
  }

  /// A plan needs a frame, which the run may not have stored yet.
  viz::Plan first_plan() {
    const auto to_come = [&] {
      return !fs::exists(options.request.runs.front() / results::journal_name) ||
             (former && former->is_still_there());
    };
    while (!run_ended && !given_up && to_come()) std::this_thread::sleep_for(between_looks);
    for (;;) {
      const bool last = run_ended || given_up;
      try {
        return viz::plan_of(options.request);
      } catch (const viz::BadRequest&) {
        if (last) throw;
      } catch (const base::WorldError&) {
        if (last) throw;
      }
      std::this_thread::sleep_for(between_looks);
    }
  }

  void run() {
    try {
      make();
    } catch (const viz::Stopped&) {
      result.trouble = "stopped; no incomplete file is left";
    } catch (const std::exception& error) {
      result.trouble = base::plain_text(error);
    }
    made = true;
  }
};

FilmOfRun::FilmOfRun(CLI::App& command) : maker_(std::make_unique<Maker>()) {
  command.add_flag("--render", maker_->asked, "Make a film, rendered during the run where possible");
  command
      .add_option("--film", maker_->film,
                  "The film's file: .mp4, .webm or .gif (default: in the run's folder)")
      ->type_name("FILE");
  add_film_options(command, maker_->options);
}

FilmOfRun::~FilmOfRun() { maker_->given_up = true; }

bool FilmOfRun::wanted() const { return maker_->wanted(); }

std::string FilmOfRun::trouble_with(const scene::Preset& preset, bool force) {
  if (!maker_->wanted()) return "";
  const scene::Scene& scene = preset.scene;
  const viz::Field* field = viz::find_field(maker_->options.request.field.value_or(scene.film.field));
  const std::string beams = maker_->options.request.beams.value_or(scene.film.beams);
  const auto stored = [&](std::string_view name) {
    return std::find(scene.output.fields.begin(), scene.output.fields.end(), name) !=
           scene.output.fields.end();
  };
  maker_->frames_expected = static_cast<std::size_t>(scene.output.frames);
  try {
    for (const std::string& note : read_look(maker_->options)) base::message("rift run: {}\n", note);
  } catch (const viz::BadRequest& mistake) {
    return mistake.what();
  }
  if (!maker_->film.empty() && !viz::is_film_name(maker_->film))
    return fmt::format("--film {}: must end in .mp4, .webm or .gif", maker_->film);
  if (!force && !maker_->film.empty() && fs::exists(maker_->film))
    return fmt::format("{} exists already: --force replaces it", maker_->film);
  try {
    if (!maker_->film.empty()) base::check_target(maker_->film);
  } catch (const base::WorldError& error) {
    return error.what();
  }
  if (scene.output.frames < 2)
    return fmt::format("--render: output.frames = {} is too few for a film", scene.output.frames);
  if (!stored(field->stored))
    return fmt::format("--render: output.fields has no \"{}\", which the field {} needs", field->stored,
                       field->name);
  if (beams != "none" && !stored("damage"))
    return "--render: output.fields has no \"damage\", which beams need";
  if (preset.lanes.size() > 4)
    return "--render: a frame shows up to four lanes; make the film with 'rift render --lane'";
  return "";
}

void FilmOfRun::begin(const fs::path& run, bool core_free) {
  if (!maker_->wanted()) return;
  maker_->core_free = core_free;
  maker_->options.request.runs = {run};
  if (const fs::path journal = run / results::journal_name; fs::exists(journal))
    maker_->former.emplace(journal);
  maker_->thread = std::jthread([maker = maker_.get()] { maker->run(); });
}

FilmOfRun::Result FilmOfRun::finish(Session& session) {
  if (!maker_->wanted()) return {};
  maker_->run_ended = true;
  while (!maker_->made) {
    const auto all = static_cast<double>(std::max<std::size_t>(1, maker_->all));
    if (!session.progress("film", static_cast<double>(maker_->done) / all)) maker_->given_up = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return maker_->result;
}

}  // namespace rift::studio
