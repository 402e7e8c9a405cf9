#include "engine/base/files.hpp"
#include "engine/ensemble/ensemble.hpp"
#include "engine/results/checkpoint.hpp"
#include "engine/simulation/kept_march.hpp"
#include "tests/fuzz/bytes.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace {

using namespace rift;
namespace fs = std::filesystem;

/// The bytes as a file: without its seal it is no checkpoint, whatever else is in it.
void as_a_file(fuzz::Bytes input) {
  static const fs::path folder = [] {
    const fs::path made = "/dev/shm/rift_checkpoint_fuzz_" + std::to_string(getpid());
    fs::create_directories(made);
    return made;
  }();
  static const int at_exit =
      std::atexit([] { fs::remove_all("/dev/shm/rift_checkpoint_fuzz_" + std::to_string(getpid())); });
  (void)at_exit;
  std::ofstream(folder / results::checkpoint_name, std::ios::binary) << input.left;
  std::string damaged;
  if (results::read_checkpoint(folder, ~std::uint64_t{0}, damaged) || damaged.empty()) std::abort();
}

/// Its words.
void as_notes(fuzz::Bytes input) {
  try {
    const simulation::MarchNotes notes = simulation::march_notes(std::string(input.left));
    (void)simulation::to_json(notes);
  } catch (const std::invalid_argument&) {
  }
}

lattice::Lattice three_elements() {
  packing::Specimen s;
  s.box = {3e-3, 3e-3, 1e-3};
  for (int k = 0; k < 3; ++k) {
    s.centre.emplace_back(1e-3 * (k + 0.5), 1e-3 * (k + 0.5), 0.5e-3);
    s.radius.push_back(0.7e-3);
    s.grip.push_back(packing::Grip::none);
    if (k > 0) s.beam.push_back({k - 1, k});
  }
  s.packing.mean_radius = 0.7e-3;
  return lattice::make_lattice(s, {1e9, 0.3, 0.3}, 1000.0);
}

/// Its numbers: some of a real ensemble's, changed, cut or gone. Refused, or good for another step.
void as_a_state(fuzz::Bytes input) {
  static const lattice::Lattice lattice = three_elements();
  fracture::LaneScenario scenario;
  scenario.history = history::history_of(0.0, {{100.0, 1.0}});
  scenario.law = {fracture::Technique::progressive, 1.0, 1e-3};
  const auto beams = fracture::damageable_beams(fracture::straight_path(3e-3, 1.6e-3), lattice, 0.0);
  ensemble::Ensemble ensemble(lattice, beams, 1e-9, {scenario, scenario}, {},
                              std::make_shared<ensemble::PrescribedTips>(1e-9));
  ensemble.start_from(std::vector<lattice::Vector6>(3, lattice::Vector6::Zero()));
  ensemble.start_crack({});
  ensemble::NamedNumbers state = ensemble.state();
  for (int changes = 0; changes < 8 && !input.empty(); ++changes) {
    auto chosen = state.begin();
    std::advance(chosen, input.number<std::uint8_t>() % state.size());
    const auto what = input.number<std::uint8_t>() % 4;
    std::vector<double>& numbers = chosen->second;
    if (what == 0)
      state.erase(chosen);
    else if (what == 1)
      numbers.resize(input.number<std::uint16_t>() % 300);
    else if (!numbers.empty())
      numbers[input.number<std::uint16_t>() % numbers.size()] = input.number<double>();
    if (state.empty()) break;
  }
  try {
    ensemble.restore(state);
    ensemble.step();
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace

// What `rift resume` reads of a checkpoint: only std::invalid_argument may leave.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes input = fuzz::bytes_of(data, size);
  switch (input.number<std::uint8_t>() % 4) {
    case 0:
      as_a_file(input);
      break;
    case 1:
      as_notes(input);
      break;
    default:
      as_a_state(input);
  }
  return 0;
}
