#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

/// Width [px] of a label's text in DejaVu Sans, the widest of the faces that "sans-serif" usually stands for:
/// in any other one the text is narrower. Subscripts count as letters of full size.
double text_px(std::string_view label, double font_px);

/// The label in lines of at most `width_px`, broken after commas and else at blanks; a word that is longer
/// stays whole.
std::vector<std::string> wrapped_label(const std::string& label, double width_px, double font_px);

}  // namespace rift::studio
