#include "engine/validation/problems.hpp"

namespace rift::validation {

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::does_not_hold:
      return "does not hold";
    case Verdict::reported:
      return "reported";
    default:
      return "not judged";
  }
}

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all{
      {.name = "freund_wave",
       .title = "A crack loaded by two plane waves (exact)",
       .source = "L. B. Freund, Dynamic Fracture Mechanics, Cambridge 1990, sections 2.4 and 6.4",
       .statement = "Step tractions of 1 MPa on top and bottom of a plate with a long notch: two plane waves "
                    "meet in the notch's "
                    "plane, the crack starts where K reaches its critical value and runs by g(v) K²/E' = "
                    "G_c. The theory is an infinite "
                    "body's; in this plate it is valid until 32.5 µs. It is evaluated with each specimen's "
                    "own E and ν.",
       .kind = Problem::Kind::wave_loaded,
       .elements = 22000,
       .packings = 4,
       .mirrored = true,
       .finer = {88000}},
      {.name = "borden_branching",
       .title = "A branching glass plate",
       .source = "M. J. Borden, C. V. Verhoosel, M. A. Scott, T. J. R. Hughes, C. M. Landis, Comput. Methods "
                 "Appl. Mech. Eng. "
                 "217-220 (2012) 77-95",
       .statement = "A notched plate of 100 × 40 mm under step tractions of 1 MPa. The notch would start at "
                    "10.75 µs; the time "
                    "of branching is not agreed in print (33 to 79 µs) and not judged. Borden's plate is in "
                    "plane strain, this "
                    "one in plane stress.",
       .elements = 10000,
       .finer = {40000},
       .start = 10.75e-6,
       .start_within = 3e-6},
      {.name = "bobaru_branching",
       .title = "A branching plate of soda-lime glass",
       .source = "F. Bobaru, G. Zhang, Int. J. Fract. 196 (2015) 59-98",
       .statement = "The same plate of another glass under 2 MPa. The notch would start at 6.1 µs.",
       .elements = 10000,
       .finer = {40000},
       .start = 6.1e-6,
       .start_within = 2e-6}};
  return all;
}

std::vector<Realisation> realisations_of(const Problem& problem, int elements) {
  std::vector<Realisation> all;
  for (int k = 0; k < problem.packings; ++k) {
    all.push_back({problem.first_seed + k, false, elements});
    if (problem.mirrored) all.push_back({problem.first_seed + k, true, elements});
  }
  return all;
}

}  // namespace rift::validation
