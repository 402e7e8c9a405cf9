#include "engine/base/console.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/draw_claim.hpp"
#include "studio/commands/film_of_run.hpp"
#include "studio/commands/plate_pictures.hpp"

#include <CLI/CLI.hpp>

/// What a build without VTK (-DRIFT_VIZ=OFF) has in place of draw_claim.cpp, film_of_run.cpp,
/// plate_pictures.cpp, render.cpp and view.cpp.
namespace rift::studio {
namespace {

constexpr const char* without_renderer =
    "this rift was built without its renderer; build it with -DRIFT_VIZ=ON (it needs VTK)";

}  // namespace

void draw_claim(JudgedClaim& claim, const std::filesystem::path&, int, Session&) {
  claim.not_drawn = "this rift was built without its renderer";
}

struct FilmOfRun::Maker {
  bool wanted = false;
};

FilmOfRun::FilmOfRun(CLI::App& command) : maker_(std::make_unique<Maker>()) {
  command.add_flag("--render", maker_->wanted, "Make a film (not in this build)");
}

FilmOfRun::~FilmOfRun() = default;
void FilmOfRun::begin(const std::filesystem::path&, bool) {}
FilmOfRun::Result FilmOfRun::finish(Session&) { return {}; }

bool FilmOfRun::wanted() const { return maker_->wanted; }

std::string FilmOfRun::trouble_with(const scene::Preset&, bool) {
  return maker_->wanted ? std::string("--render: ") + without_renderer : "";
}

void add_render(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("render", "Films and pictures of a run (not in this build)");
  command.allow_extras();
  command.callback([&exit_code] {
    base::message("rift render: {}, or look at the run in ParaView: rift export RUN --to pvd\n",
                  without_renderer);
    exit_code = ExitCode::world_failed;
  });
}

MakePlatePicture plate_pictures(const std::filesystem::path&) { return {}; }

void add_view(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("view", "A run's pictures in the terminal (not in this build)");
  command.allow_extras();
  command.callback([&exit_code] {
    base::message("rift view: {}\n", without_renderer);
    exit_code = ExitCode::world_failed;
  });
}

}  // namespace rift::studio
