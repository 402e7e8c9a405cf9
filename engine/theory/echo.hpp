#pragma once

namespace rift::theory {

/// How far a tip of constant velocity advances before the first echo of its start is back [m]. The
/// dilatational wave that it sent out when it started returns
///   from the grips after t = H / sqrt(c_d^2 - v^2):  (c_d t)^2 = H^2 + (v t)^2, mirrored at half of H
///   from an end ahead after t = 2 W / (c_d + v):     c_d t = W + (W - v t)   [physics.md §9.4-9.5]
/// @param[in] v       of the tip [m/s]; infinity from c_d on, where no wave catches up with it
/// @param[in] height  H [m], twice the distance from the path to the nearer grip
/// @param[in] ahead   W [m], from the start to the end of the plate
/// @param[in] c_d     dilatational speed [m/s]
double echo_free_advance(double v, double height, double ahead, double c_d);

}  // namespace rift::theory
