#pragma once

#include "studio/text/table.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace rift::studio {

// Reports as one self-contained HTML page: no script, nothing loaded from elsewhere.

/// Text with &, <, > and quotes made harmless, other control characters than line breaks and tabs and what is
/// no UTF-8 escaped.
std::string html_escape(std::string_view text);

/// The whole page: it needs no scrolling sideways, prints on A4 and keeps charts readable on a dark screen.
/// @param body  HTML
std::string html_page(std::string_view title, std::string_view body);

/// A heading of the second rank and what belongs to it. @param body  HTML
std::string html_section(std::string_view title, std::string_view body);

std::string html_paragraph(std::string_view text);

/// Text whose lines and blanks stay as they are.
std::string html_lines(std::string_view text);

/// Cells are texts; columns of numbers are set to the right.
std::string html_table(const Table& table);

/// A table of two columns without a head: what, and what it is.
std::string html_facts(const Table& table);

/// The same as short lines side by side, for many of them.
std::string html_pairs(const Table& table);

std::string html_list(const std::vector<std::string>& lines);

/// A picture under which stands a caption. @param svg  as it is; ids must be unique in the page
std::string html_figure(std::string_view svg, std::string_view caption);

/// A PNG, written into the page itself. Throws WorldError where it cannot be read.
std::string html_picture(const std::filesystem::path& png, std::string_view caption);

}  // namespace rift::studio
