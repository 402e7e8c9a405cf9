#include "studio/commands/film_of_run.hpp"

#include <CLI/CLI.hpp>

// What a build without VTK (-DRIFT_VIZ=OFF) has in place of film_of_run.cpp.
namespace rift::studio {

struct FilmOfRun::Maker {
  bool wanted = false;
};

FilmOfRun::FilmOfRun(CLI::App& command) : maker_(std::make_unique<Maker>()) {
  command.add_flag("--render", maker_->wanted, "Make a film (not in this build)");
}

FilmOfRun::~FilmOfRun() = default;
void FilmOfRun::begin(const std::filesystem::path&, bool) {}
FilmOfRun::Result FilmOfRun::finish(ProgressLine&, const std::function<bool()>&) { return {}; }

bool FilmOfRun::wanted() const { return maker_->wanted; }

std::string FilmOfRun::trouble_with(const scene::Preset&, bool) {
  if (!maker_->wanted) return "";
  return "--render: this rift was built without its renderer; build it with -DRIFT_VIZ=ON (it needs VTK)";
}

}  // namespace rift::studio
