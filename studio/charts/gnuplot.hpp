#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rift::studio {

/// Runs NAME.gp in `folder` by gnuplot, which makes NAME.svg and NAME.png. The pictures get these names only
/// when both are whole. The script writes to the files named by its variables `svg` and `png`. Throws
/// results::WorldError with gnuplot's own message.
void run_script(const std::filesystem::path& folder, const std::string& name);

/// gnuplot's svg as a part of an HTML page: without prolog, its title as an aria-label instead of a tooltip,
/// and every id, which gnuplot repeats from picture to picture, prefixed by the name.
std::string inline_svg(std::string_view svg, const std::string& name, const std::string& title);

}  // namespace rift::studio
