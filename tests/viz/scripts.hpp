#pragma once

#include "tests/viz/drawn_plate.hpp"

#include <stdlib.h>

#include <fstream>
#include <string>

/// Programs that behave as told, in place of ffmpeg and of those that draw.
namespace rift::viz {

/// An executable shell script.
inline std::filesystem::path write_script(const std::filesystem::path& path, const std::string& body) {
  std::ofstream(path) << "#!/bin/sh\n" << body << "\n";
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

/// Changes PATH for the life of the object.
class PathOf {
 public:
  explicit PathOf(const std::string& path) : former_(getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  PathOf(const PathOf&) = delete;
  PathOf& operator=(const PathOf&) = delete;
  ~PathOf() { setenv("PATH", former_.c_str(), 1); }

 private:
  std::string former_;
};

}  // namespace rift::viz
