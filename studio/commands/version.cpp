#include "studio/commands/version.hpp"

#include "engine/ensemble/instruction_set.hpp"

#include <fmt/format.h>
#include <rift_commit.hpp>

#include <string_view>

namespace rift::studio {
namespace {

#ifdef NDEBUG
constexpr std::string_view build = "optimised, asserts off";
#else
constexpr std::string_view build = "asserts on";
#endif

#ifdef __clang__
constexpr std::string_view compiler = "Clang " __clang_version__;
#else
constexpr std::string_view compiler = "GCC " __VERSION__;
#endif

}  // namespace

simulation::BuildInfo build_info() { return {RIFT_VERSION, std::string(compiler)}; }

std::string version_text() {
  return fmt::format("rift {} ({}; {}; {})", RIFT_VERSION, build, compiler,
                     ensemble::name_of(ensemble::instruction_set()));
}

std::string version_and_libraries_text() {
  return fmt::format("{}\ncommit     {}\nlibraries  {}", version_text(), RIFT_COMMIT, RIFT_LIBRARIES);
}

}  // namespace rift::studio
