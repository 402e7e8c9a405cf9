#include "studio/commands/draw_claim.hpp"

// What a build without VTK (-DRIFT_VIZ=OFF) has in place of draw_claim.cpp.
namespace rift::studio {

void draw_claim(JudgedClaim& claim, const std::filesystem::path&, int, base::Cache&, int,
                const std::function<bool(std::string_view, double)>&) {
  claim.not_drawn = "this rift was built without its renderer";
}

}  // namespace rift::studio
