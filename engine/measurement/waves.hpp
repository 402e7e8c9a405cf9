#pragma once

#include "engine/base/interrupted.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/theory/wave_speeds.hpp"

namespace rift::measurement {

enum class WaveKind { dilatational, shear, rayleigh };

/// The phase speed of one wave in a plate.
struct Wave {
  WaveKind kind = WaveKind::dilatational;
  double wavelength = 0;  // [m]
  double speed = 0;       // [m/s]
  double misfit = 0;      // share of the swing's square that the fit leaves
};

/// Phase speeds of a free plate at rest, by waves that are thrown into it and watched until the first echo of
/// the plate's ends is back in its middle.
/// Dilatational and shear waves stand across the height, v = cos(n pi y / H) along y and along x, which
/// leaves both faces free of traction; Rayleigh waves stand along the free edge y = H, with the field of that
/// wave in a half plane (Rayleigh 1885). The frequency is that of the displacements' projection onto what was
/// thrown, fitted by sin(omega t) with an amplitude that may fade. Waves shorter than eight mean radii, and
/// those that do not swing for three quarters of a period, are left out.
/// @param[in] dt        [s], a stable step
/// @param[in] expected  [m/s], of the plate's material: where to look, and the field of the Rayleigh wave
/// @param[in] threads   0 for one per available CPU
/// Cost of some hundred steps for eight waves at once. Throws Interrupted.
std::vector<Wave> measured_waves(const lattice::Lattice& plate, double dt, const theory::WaveSpeeds& expected,
                                 int threads = 0, const base::ProgressCallback& progress = {});

}  // namespace rift::measurement
