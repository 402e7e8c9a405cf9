#pragma once

#include "engine/claims/claims.hpp"

namespace rift::claims {

// Judges of the claims about compressed cylinders; both look at those of 15,000 elements and more.

/// Fig. 17: E and nu of every size are within 2.5 % of their common mean.
Judgement cylinders_converge(const Evidence& evidence);

/// Table 2: E is within 3 % of 10.3 GPa, nu within 0.30 to 0.33, with the paper's beams.
Judgement cylinders_meet_table2(const Evidence& evidence);

}  // namespace rift::claims
