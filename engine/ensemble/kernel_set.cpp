// The kernels of one instruction set and precision. engine/CMakeLists.txt compiles this file once for each of
// them: RIFT_INSTRUCTIONS names the set, RIFT_REGISTER_BYTES is the width of its registers, RIFT_REAL the
// number of the state.
#include "engine/ensemble/instruction_set.hpp"
#include "engine/ensemble/kernels.hpp"

namespace rift::ensemble::RIFT_INSTRUCTIONS {
namespace {

template <template <class, int> class Form, class Real, bool Breaking>
Kernel<typename Form<Real, 1>::Row> of_lanes(int lanes) {
  constexpr int most = 64 / sizeof(Real);
  if (lanes == 1) return kernel<Form, Real, 1, Breaking>();
  if (lanes == most) return kernel<Form, Real, most, Breaking>();
  if (lanes == most / 2) return kernel<Form, Real, most / 2, Breaking>();
  if (lanes == most / 4) return kernel<Form, Real, most / 4, Breaking>();
  return {};
}

}  // namespace

template <class Beam>
Kernel<Beam> find_kernel(int lanes, bool breaking) {
  using Real = typename Beam::Number;
  if constexpr (std::is_same_v<Beam, LinearBeam<Real>>)
    return breaking ? of_lanes<Linear, Real, true>(lanes) : of_lanes<Linear, Real, false>(lanes);
  else
    return breaking ? Kernel<Beam>{} : of_lanes<Corotational, Real, false>(lanes);
}

/// Enough independent chains to hide the latency of any processor so far.
template <class Real>
double multiply_and_add(long rounds) {
  constexpr int width = RIFT_REGISTER_BYTES / sizeof(Real), chains = 12;
  using V = Pack<Real, width>;
  const V a = splat<V>(Real(0.999)), b = splat<V>(Real(0.001));
  V x[chains];
  for (int c = 0; c < chains; ++c) x[c] = splat<V>(Real(c));
  for (long n = 0; n < rounds; ++n)
#pragma GCC unroll 16
    for (int c = 0; c < chains; ++c) x[c] = fma(a, x[c], b);
  Real sum = 0;
  for (int c = 0; c < chains; ++c) sum += x[c][0];
  return sum == Real(-1) ? 0.0 : 2.0 * static_cast<double>(rounds) * chains * width;
}

template Kernel<LinearBeam<RIFT_REAL>> find_kernel(int, bool);
template Kernel<CorotationalBeam<RIFT_REAL>> find_kernel(int, bool);
template double multiply_and_add<RIFT_REAL>(long);

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
