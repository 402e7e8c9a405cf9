// A scene of your own, marched, and its release-rate ratio: the engine without the program.
#include <engine/base/cache.hpp>
#include <engine/scene/preset.hpp>
#include <engine/simulation/summary.hpp>
#include <fmt/format.h>

int main() {
  const rift::scene::Preset preset = rift::scene::read_preset_text(R"(
    specimen = { length = "60 mm", height = "12 mm", layers = 2, elements = 700, coordination = 5.7 }
    loading = { displacement = "0.6 mm" }
    crack = { velocity = "0.5 c_r" })",
                                                                   "my scene");
  rift::base::Cache cache;  // without a folder nothing is kept on the disk
  const rift::simulation::Prepared prepared = rift::simulation::prepare(preset, cache);
  const rift::simulation::RunResult result = rift::simulation::march(prepared, {});
  const rift::simulation::Rates rates = rift::simulation::rates_of(prepared, result);
  fmt::print("G_ID / G_I0 = {:.3f}\n", rates.plateau.mean.ratio);
}
