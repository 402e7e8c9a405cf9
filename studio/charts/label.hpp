#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rift::studio {

// Text in charts. Titles, axes and legends are gnuplot's enhanced text: "G_{ID} / G_{I0}", "10^{-3}", "α,
// c_r".

/// Text that comes from data, as a label that shows it letter by letter: "run_01" -> "run\_01".
std::string escape_label(std::string_view text);

/// What a label reads like without its markup: "G_{ID} / c_r" -> "G_ID / c_r", "run\_01" -> "run_01".
std::string plain_text(std::string_view label);

/// The label as a string of a gnuplot script, in single quotes; line breaks become spaces.
std::string script_string(std::string_view label);

/// The same of a text that is shown. A joiner stands before a blank after a subscript: some viewers drop a
/// blank that opens a span.
std::string label_string(std::string_view label);

/// Letters a label shows, for an estimate of its width: markup and bytes within a letter not counted.
std::size_t letters(std::string_view label);

/// The text as a field of a csv that gnuplot reads, which base::csv_field() is not: gnuplot does not know
/// commas, doubled quotes or line breaks within a field, which become ';', "'" and spaces.
std::string gnuplot_field(std::string text);

}  // namespace rift::studio
