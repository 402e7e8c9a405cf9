#pragma once

#include "studio/workbench/screen.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// Which screen shows what. All throw with the reason where it cannot be shown.
namespace rift::studio {

std::unique_ptr<Screen> form_of_preset(Workshop& workshop, const std::filesystem::path& preset);
/// Starts it: a run or a study. @param overrides  as of --set
std::unique_ptr<Screen> screen_of_preset(Workshop& workshop, const std::filesystem::path& preset,
                                         const std::vector<std::string>& overrides);
/// Of a folder with a run or a study in it, going on or ended; a study is shown as far as it has been
/// computed.
std::unique_ptr<Screen> screen_of_run(Workshop& workshop, const std::filesystem::path& run);
/// Goes on with a run or a study that was stopped or killed.
std::unique_ptr<Screen> resumption_of(Workshop& workshop, const std::filesystem::path& run);
std::unique_ptr<Screen> comparison_of(Workshop& workshop, const std::vector<std::filesystem::path>& runs);
/// @param name  of a lesson
std::unique_ptr<Screen> lesson_screen(Workshop& workshop, const std::string& name);

}  // namespace rift::studio
