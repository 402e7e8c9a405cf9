#pragma once

#include "engine/claims/claims.hpp"

/// The judges of the claims, one for each artefact that needs numbers.
namespace rift::claims::judges {

Judgement fig01(const Evidence& evidence);
Judgement fig05(const Evidence& evidence);
Judgement fig06(const Evidence& evidence);
Judgement fig07(const Evidence& evidence);
Judgement fig08(const Evidence& evidence);
Judgement fig09(const Evidence& evidence);
Judgement fig10(const Evidence& evidence);
Judgement fig11(const Evidence& evidence);
Judgement fig12(const Evidence& evidence);
Judgement fig13(const Evidence& evidence);
Judgement fig14(const Evidence& evidence);
Judgement fig15(const Evidence& evidence);
Judgement fig17(const Evidence& evidence);
Judgement table1(const Evidence& evidence);
Judgement table2(const Evidence& evidence);
Judgement sec2_linear(const Evidence& evidence);
Judgement sec3_specimens(const Evidence& evidence);
Judgement sec3_damping(const Evidence& evidence);
Judgement sec4_time_step(const Evidence& evidence);
Judgement sec4_longer(const Evidence& evidence);
Judgement sec5_paths(const Evidence& evidence);
Judgement sec5_residual(const Evidence& evidence);
Judgement sec5_bending(const Evidence& evidence);
Judgement beyond_map(const Evidence& evidence);
Judgement beyond_efficiency(const Evidence& evidence);
Judgement beyond_broberg(const Evidence& evidence);

}  // namespace rift::claims::judges
