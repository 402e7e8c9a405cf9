#include "studio/charts/text_width.hpp"

#include "studio/charts/label.hpp"

#include <array>

namespace rift::studio {
namespace {

/// Advances of ASCII 32 to 126 in DejaVu Sans, thousandths of the font's size   [DejaVuSans.ttf 2.37, hmtx].
constexpr std::array<int, 95> advances{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr int other_letter = 840;  // ω, ±, ≤ are that wide; Greek and accented letters less

bool starts_letter(unsigned char byte) { return (byte & 0xC0U) != 0x80U; }

}  // namespace

double text_px(std::string_view label, double font_px) {
  int thousandths = 0;
  for (const char c : plain_text(label)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 32 && byte < 127)
      thousandths += advances[byte - 32U];
    else if (starts_letter(byte))
      thousandths += other_letter;
  }
  return 1e-3 * font_px * thousandths;
}

std::vector<std::string> wrapped_label(const std::string& label, double width_px, double font_px) {
  std::vector<std::string> lines;
  std::string rest = label;
  while (text_px(rest, font_px) > width_px) {
    std::size_t at = std::string::npos, after_comma = at;
    for (std::size_t k = rest.find(' '); k != std::string::npos; k = rest.find(' ', k + 1)) {
      if (at != std::string::npos && text_px(rest.substr(0, k), font_px) > width_px) break;
      at = k;
      if (k > 0 && rest[k - 1] == ',') after_comma = k;
    }
    if (at == std::string::npos) break;
    if (after_comma != std::string::npos) at = after_comma;
    lines.push_back(rest.substr(0, at));
    rest.erase(0, at + 1);
  }
  lines.push_back(rest);
  return lines;
}

}  // namespace rift::studio
