#pragma once

#include "studio/text/table.hpp"

#include <string>

namespace rift::studio {

/// A table of Markdown: bars in cells are escaped, line breaks become blanks.
std::string markdown_table(const Table& table);

}  // namespace rift::studio
