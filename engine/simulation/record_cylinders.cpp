#include "engine/simulation/record_cylinders.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/calibration/calibrate.hpp"
#include "engine/calibration/pull.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/packing/packing.hpp"
#include "engine/results/run_writer.hpp"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

namespace rift::simulation {
namespace {

/// Everything drawn so far, and the frame of it.
struct Scenery {
  results::Geometry geometry;
  results::Frame frame;
  double width = 0;  // [m]

  void add(const packing::Specimen& specimen, const std::vector<lattice::Vector6>& motion) {
    constexpr double gap = 0.3;  // of a diameter
    const double offset = width == 0.0 ? 0.0 : width + gap * specimen.box.length;
    const auto first = static_cast<std::int32_t>(geometry.position.size());
    const auto single = [](const Eigen::Vector3d& p) {
      return std::array{static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
    };
    for (std::size_t i = 0; i < motion.size(); ++i) {
      geometry.position.push_back(single(specimen.centre[i] + Eigen::Vector3d(offset, 0, 0)));
      geometry.radius.push_back(static_cast<float>(specimen.radius[i]));
      frame.displacement.push_back(single(motion[i].head<3>()));
    }
    for (const auto& [i, j] : specimen.beam) geometry.beam.push_back({first + i, first + j});
    width = offset + specimen.box.length;
  }
};

/// Takes out of a body's motion what shifts and turns its middle.
void stand_still(std::vector<lattice::Vector6>& motion, const lattice::Lattice& lattice) {
  const Eigen::Matrix3d gradient = calibration::gradient_in_middle(lattice, motion, 1);
  const Eigen::Vector3d turn(0.5 * (gradient(2, 1) - gradient(1, 2)), 0.5 * (gradient(0, 2) - gradient(2, 0)),
                             0.5 * (gradient(1, 0) - gradient(0, 1)));
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < motion.size(); ++i) {
    motion[i].head<3>() -= turn.cross(lattice.centre[i] - 0.5 * lattice.box.size());
    shift += motion[i].head<3>() / static_cast<double>(motion.size());
  }
  for (lattice::Vector6& q : motion) q.head<3>() -= shift;
}

/// Pressed by 1 % of its height, as the mean of its ends; its middle stays.
std::vector<lattice::Vector6> pressed(const packing::Specimen& specimen) {
  constexpr double shortening = 0.01, stress = 1e6;
  const lattice::Lattice lattice = lattice::make_lattice(specimen, lattice::bulk_micro_material, 1.0);
  lattice::FreeBody body(lattice);
  calibration::Pulled pulled = calibration::pull(lattice, body, 1, -specimen.box.section(1) * stress);
  stand_still(pulled.motion, lattice);
  for (lattice::Vector6& q : pulled.motion) q *= shortening / (stress / pulled.young_modulus);
  return pulled.motion;
}

nlohmann::ordered_json header_for(const scene::Preset& preset, const Scenery& scenery,
                                  const BuildInfo& build) {
  const double height = preset.scene.specimen.height;
  return {{"preset_name", preset.name},
          {"preset", scene::preset_text(preset)},
          {"version", build.version},
          {"compiler", build.compiler},
          {"seed", preset.scene.specimen.seed},
          {"lanes", 1},
          {"length_m", scenery.width},
          {"height_m", height},
          {"thickness_m", preset.scene.specimen.length},
          {"path", {{0.0, 0.5 * height}, {0.0, 0.5 * height}}},
          {"tips", 0},
          {"density_kg_m3", 1.0},
          {"solid_fraction", 0.62},
          {"scenarios", {nlohmann::ordered_json::object()}},
          {"film",
           {{"title", preset.scene.film.title}, {"field", "uy"}, {"chart", false}, {"magnification", 1.0}}}};
}

}  // namespace

void record_cylinders(const scene::Preset& preset, const std::filesystem::path& folder,
                      const BuildInfo& build, base::Cache& cache, const base::ProgressCallback& progress) {
  Scenery scenery;
  const scene::Scene& scene = preset.scene;
  for (std::size_t k = 0; k < scene.calibration.sizes.size(); ++k) {
    const calibration::CylinderTest test =
        calibration::cylinders_for(scene, static_cast<int>(scene.calibration.sizes[k]), {}).front();
    bool found = false;
    const packing::Packing packing = packing::cached_packing(test.packing, cache, found);
    const packing::Specimen specimen =
        packing::make_free_specimen(packing, test.packing.box, test.contact_tolerance);
    scenery.add(specimen, pressed(specimen));
    if (progress &&
        !progress(static_cast<double>(k + 1) / static_cast<double>(scene.calibration.sizes.size())))
      throw base::Interrupted("compressing cylinders");
  }
  results::RunWriter writer(folder, header_for(preset, scenery, build), scenery.geometry);
  writer.frame(scenery.frame);
  writer.finish({{"scenarios", {{{"outcome", "finished"}}}}}, {{}});
}

}  // namespace rift::simulation
