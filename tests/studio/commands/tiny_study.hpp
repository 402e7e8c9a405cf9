#pragma once

#include "tests/studio/commands/tiny_plate.hpp"

#include <string>

namespace rift::studio {

/// The tiny plate as a study of eight scenarios on two specimens.
class TinyStudy : public TinyPlate {
 public:
  explicit TinyStudy(CacheOf cache = CacheOf::all_tests) : TinyPlate(cache) {
    std::string text = read_text(preset());
    text.erase(text.find("velocity = "), std::string("velocity = \"0.5 c_r\"\n").size());
    write_text(preset(), text +
                             "[study]\ntechnique = [\"simple\", \"progressive\"]\n"
                             "crack_velocity = [\"0.3 c_r\", \"0.5 c_r\"]\nseed = [1, 2]\n");
  }
  std::string command(const std::string& arguments, const std::filesystem::path& out) const {
    return "study '" + preset().string() + "' --out '" + out.string() + "' " + arguments;
  }
  Ran study(const std::string& arguments = "") const {
    return run_rift(command(arguments, out()), environment());
  }
  Ran study_under(const std::string& wrapper, const std::string& arguments,
                  const std::filesystem::path& folder) const {
    return run_shell("env " + environment() + " " + wrapper + " '" RIFT_EXE "' " +
                     command(arguments, folder));
  }
};

}  // namespace rift::studio
