#include "studio/commands/plate_pictures.hpp"

#include "studio/view/run_plate.hpp"

namespace rift::studio {

MakePlatePicture plate_pictures(const std::filesystem::path& programs) {
  return [programs](const std::vector<std::filesystem::path>& runs) {
    return plate_of_runs(runs, programs);
  };
}

}  // namespace rift::studio
