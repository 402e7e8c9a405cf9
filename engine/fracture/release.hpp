#pragma once

namespace rift::fracture {

enum class Technique { simple, progressive };

/// How the beams at the tip lose their stiffness.
struct ReleaseLaw {
  Technique technique = Technique::progressive;
  double exponent =
      1.0;  // p of Y1/Y2 = (1 - b/l)^p: 1 linear (eq. 9), 1/2 square root (eq. 10), 2 quadratic (eq. 11)
  double zone_length = 0.0;  // l = L_CZM = r_l R_mean [m]; 0 for simple release
};

/// Y1/Y2 of a beam that the path crosses at s_b when the tip is at a, both arc lengths [m]   [paper eqs.
/// (9)-(11)]:
///   b = a + L_CZM - s_b clipped to [0, L_CZM], gone at b = L_CZM;   simple release: gone as soon as a >=
///   s_b.
double stiffness_left(const ReleaseLaw& law, double tip, double crossing);

}  // namespace rift::fracture
