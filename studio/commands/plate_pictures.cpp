#include "studio/commands/plate_pictures.hpp"

#include "studio/view/run_plate.hpp"

namespace rift::studio {

MakePlatePicture plate_pictures() { return plate_of_run; }

}  // namespace rift::studio
