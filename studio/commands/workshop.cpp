#include "studio/commands/workshop.hpp"

#include "studio/commands/common.hpp"

#include <system_error>

namespace rift::studio {

Workshop workshop_here(int threads) {
  Workshop w;
  std::error_code none;
  w.presets = presets_folder();
  w.own_presets = own_presets_folder();
  w.program = std::filesystem::read_symlink("/proc/self/exe", none);
  w.cache = base::user_cache();
  w.build = build_info();
  w.threads = threads;
  return w;
}

}  // namespace rift::studio
