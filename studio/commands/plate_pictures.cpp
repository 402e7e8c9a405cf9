#include "studio/commands/plate_pictures.hpp"

#include "studio/view/run_plate.hpp"

namespace rift::studio {

MakePlatePicture plate_pictures(const std::filesystem::path& programs) {
  return [programs](const std::filesystem::path& run) { return plate_of_run(run, programs); };
}

}  // namespace rift::studio
