#pragma once

#include "tests/studio/run_rift.hpp"

#include <string>

namespace rift::studio {

/// Where a plate's packing is looked for: in the cache of all tests, or in one that starts empty, of a test
/// that watches what is packed.
enum class CacheOf { all_tests, this_test };

/// A preset of 900 elements, 60 x 12 mm, that packs in 0.2 s and runs in 0.1 s, and a place for its runs.
class TinyPlate {
 public:
  explicit TinyPlate(CacheOf cache = CacheOf::all_tests) : cache_(cache) {
    write_text(preset(), R"(# A tiny plate
[specimen]
length = "60 mm"
height = "12 mm"
layers = 2
elements = 900
coordination = 5.7

[loading]
displacement = "0.6 mm"

[crack]
velocity = "0.5 c_r"
end = "30 mm"

[output]
samples = 60
frames = 4
)");
  }

  std::filesystem::path path() const { return folder_.path(); }
  std::filesystem::path preset() const { return folder_.path() / "tiny.toml"; }
  std::filesystem::path out() const { return folder_.path() / "out"; }
  std::string environment() const {
    return cache_ == CacheOf::all_tests ? shared_cache_environment()
                                        : "XDG_CACHE_HOME='" + folder_.path().string() + "/cache'";
  }

  /// `rift run PRESET --out OUT ARGUMENTS`
  Ran run(const std::string& arguments = "") const {
    return run_rift("run '" + preset().string() + "' --out '" + out().string() + "' " + arguments,
                    environment());
  }
  Ran check(const std::string& arguments = "") const {
    return run_rift("check '" + preset().string() + "' " + arguments, environment());
  }

  /// The same run, which a shell command put before it ends by a signal, as in `timeout -s INT 1`.
  Ran run_under(const std::string& wrapper, const std::string& arguments) const {
    return run_shell("env " + environment() + " " + wrapper + " '" RIFT_EXE "' run '" + preset().string() +
                     "' --out '" + out().string() + "' " + arguments);
  }

  /// The same run, killed as soon as a file of that name is in its folder, however slow the machine.
  Ran run_and_kill(const std::string& file, const std::string& arguments) const {
    return run_and_signal("KILL", file, arguments);
  }

  /// The same with another signal. The exit code is that of the run: 128 + n.
  Ran run_and_signal(const std::string& signal, const std::string& file, const std::string& arguments) const {
    return run_shell("(env " + environment() + " '" RIFT_EXE "' run '" + preset().string() + "' --out '" +
                     out().string() + "' " + arguments + " & p=$!; for k in $(seq 1200); do [ -e '" +
                     (out() / file).string() + "' ] && break; sleep 0.02; done; kill -" + signal +
                     " $p; wait $p) 2>/dev/null");
  }

 private:
  CacheOf cache_;
  TemporaryFolder folder_;
};

}  // namespace rift::studio
