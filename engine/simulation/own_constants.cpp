#include "engine/simulation/own_constants.hpp"

#include "engine/calibration/pull.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/packing/packing.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/prepare.hpp"

#include <array>

namespace rift::simulation {

double between_grips(const lattice::Lattice& lattice) {
  std::array<double, 2> sum{}, count{};
  for (std::size_t i = 0; i < lattice.centre.size(); ++i) {
    if (lattice.grip[i] == packing::Grip::none) continue;
    const int k = lattice.grip[i] == packing::Grip::top ? 1 : 0;
    sum[k] += lattice.centre[i].y(), count[k] += 1.0;
  }
  return sum[1] / count[1] - sum[0] / count[0];
}

lattice::Lattice free_plate(const Prepared& p, const lattice::MicroMaterial& micro, base::Cache& cache,
                            const base::ProgressCallback& told) {
  bool found = false;
  const scene::Scene& scene = p.preset.scene;
  const packing::PackingRequest request = scene::request_of(scene);
  const packing::Specimen specimen = packing::make_free_specimen(
      packing::cached_packing(request, cache, found, told), request.box, scene.specimen.contact_tolerance);
  return lattice::make_lattice(specimen, micro, p.density);
}

namespace {

std::string key_of_pulls(const Prepared& p) { return "pulled plate 1 of " + statics_key(p); }

}  // namespace

std::optional<OwnConstants> known_constants(const Prepared& p, base::Cache& cache) {
  const auto known = base::recall(cache, "constants", key_of_pulls(p));
  if (!known || known->size() != 4) return {};
  return OwnConstants{(*known)[0], (*known)[1], (*known)[2], (*known)[3], between_grips(p.lattice)};
}

OwnConstants own_constants(const Prepared& p, base::Cache& cache, const base::ProgressCallback& told,
                           int threads) {
  if (const std::optional<OwnConstants> known = known_constants(p, cache)) return *known;
  OwnConstants own;
  own.between_grips = between_grips(p.lattice);
  base::tell_or_stop(told, 0.0, "pulling the plate");
  const lattice::Lattice plate = free_plate(p, p.micro, cache);
  lattice::FreeBody body(plate, threads);
  const auto half = [&told](double from) -> base::ProgressCallback {
    return [&told, from](double done) { return !told || told(from + 0.5 * done); };
  };
  const calibration::Pulled along = calibration::pull(plate, body, 0, 1.0, half(0.0));
  const calibration::Pulled across = calibration::pull(plate, body, 1, 1.0, half(0.5));
  own.young_along = along.gauge_modulus, own.poisson_along = along.poisson_ratio.y();
  own.young_across = across.gauge_modulus, own.poisson_across = across.poisson_ratio.x();
  base::remember(cache, "constants", key_of_pulls(p),
                 std::array{own.young_along, own.poisson_along, own.young_across, own.poisson_across});
  return own;
}

}  // namespace rift::simulation
