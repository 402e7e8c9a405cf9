#include "studio/commands/draw_claim.hpp"

#include "engine/base/files.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/simulation/record.hpp"
#include "engine/simulation/record_cylinders.hpp"
#include "viz/plan.hpp"
#include "viz/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

scene::Preset preset_for(const std::string& name, int elements) {
  scene::Preset preset = without_mistakes(scene::read_preset(resolve_preset(name)));
  preset.scene.specimen.elements = std::min(preset.scene.specimen.elements, elements);
  return preset;
}

/// The finished run of the preset in this folder, found or made.
void run_if_need_be(const claims::Claim& claim, const scene::Preset& preset, const fs::path& run,
                    Session& session) {
  if (results::inspect_run(run).condition == results::RunCondition::finished) return;
  results::ClaimedFolder folder(run, true);
  if (claim.calibration) {
    folder.keep();
    simulation::record_cylinders(preset, run, build_info(), session.cache, session.progress_of("cylinders"));
    return;
  }
  const simulation::Prepared prepared =
      simulation::prepare(preset, scenes_of_run(preset), session.cache, session.progress_of_stages());
  folder.keep();
  const simulation::Recorded ran = simulation::record_run(
      prepared, run, build_info(),
      {.go_on =
           [&](const simulation::Progress& p) {
             return session.progress("crack", static_cast<double>(p.step) / static_cast<double>(p.total));
           }},
      {.threads = session.options.threads});
  if (ran.result.outcome == simulation::Outcome::stopped) throw base::Interrupted("a crack was running");
}

Picture draw(const viz::Plan& plan, const claims::Claim& claim, double at, const fs::path& charts) {
  const auto k = static_cast<std::size_t>(std::lround(at * static_cast<double>(plan.times_s.size() - 1)));
  const fs::path png = charts / fmt::format("{}_at_{:.2f}.png", claim.name, at);
  viz::make_picture(plan.job, plan.times_s[k], png, {});
  if (claim.calibration) return {png, fmt::format("{}: {}", claim.artefact, plan.job.look.title)};
  return {png,
          fmt::format("{}, {}: tip at {:.0f} mm", claim.artefact, plan.job.look.title, 1e3 * plan.tips_m[k])};
}

}  // namespace

void draw_claim(JudgedClaim& claim, const fs::path& folder, int elements, Session& session) {
  const double start_s = session.seconds();
  const std::string& name = claim.claim->needs.front();
  const fs::path run = folder / "pictures" / fmt::format("{}_{}", name, elements);
  try {
    run_if_need_be(*claim.claim, preset_for(name, elements), run, session);
    viz::Request request;
    request.runs = {run};
    const viz::Plan plan = viz::plan_of(request);
    base::make_folder(folder / "charts");
    for (const double at : claim.claim->pictures_at) {
      if (!session.progress("drawing " + claim.claim->name, at))
        throw base::Interrupted("pictures were drawn");
      claim.pictures.push_back(draw(plan, *claim.claim, at, folder / "charts"));
    }
  } catch (const base::WorldError& error) {
    claim.not_drawn = error.what();
  }
  claim.wall_s = session.seconds() - start_s;
}

}  // namespace rift::studio
