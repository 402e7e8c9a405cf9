#include "studio/text/html.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <utility>

namespace rift::studio {
namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --ink: #1a1a1a; --paper: #fff; --dim: #555; --rule: #ddd; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e4e4; --paper: #17191c; --dim: #aaa; --rule: #3a3d42; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 74em;
       margin: 2em auto; padding: 0 1em; overflow-wrap: break-word; }
h1 { font-size: 1.6em; line-height: 1.2; }
h2 { font-size: 1.25em; margin-top: 2em; border-bottom: 1px solid var(--rule); break-after: avoid; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.9em; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2em 0.7em 0.2em 0; border-bottom: 1px solid var(--rule); text-align: left; vertical-align: top; }
th { border-bottom: 2px solid #888; vertical-align: bottom; line-height: 1.25; }
tr { break-inside: avoid; }
.n { text-align: right; } td.n, .s { white-space: nowrap; }
.many { font-size: 0.72em; } .many th, .many td { padding-right: 0.5em; } .many td.n { white-space: normal; }
.facts td:first-child { color: var(--dim); } .facts td { border: 0; padding: 0 1em 0.1em 0; }
.facts td:last-child { overflow-wrap: anywhere; }
.pairs { columns: 20em; font-size: 0.85em; padding: 0; list-style: none; overflow-wrap: anywhere; }
.pairs li { break-inside: avoid; } .pairs span { color: var(--dim); }
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
figure { margin: 1em 0; break-inside: avoid; }
figure svg, figure img { max-width: 100%; height: auto; background: #fff; }
figcaption { color: var(--dim); font-size: 0.9em; max-width: 860px; }
@page { size: A4; margin: 14mm; }
@media print {
  :root { color-scheme: light; --ink: #000; --paper: #fff; --dim: #444; --rule: #ccc; }
  body { font-size: 10.5pt; margin: 0; padding: 0; max-width: none; } .wide { overflow: visible; }
}
)";

constexpr std::size_t longest_whole = 8;      // letters of a cell that is not broken: "0.5 c_R"
constexpr std::size_t most_of_full_size = 6;  // columns of a table; more are set smaller

/// Symbols of the field, as they are written in texts and as they are set.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> symbols{{{"G_IDc", "G<sub>IDc</sub>"},
                                                                                {"G_ID", "G<sub>ID</sub>"},
                                                                                {"G_I0", "G<sub>I0</sub>"},
                                                                                {"K_II", "K<sub>II</sub>"},
                                                                                {"K_I", "K<sub>I</sub>"},
                                                                                {"r_l", "r<sub>l</sub>"},
                                                                                {"c_R", "c<sub>R</sub>"},
                                                                                {"c_r", "c<sub>R</sub>"}}};

bool is_of_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The symbols of an escaped text with their subscripts; other names, such as ledger_residual, may be broken
/// after an underscore.
std::string set_symbols(std::string_view escaped) {
  std::string out;
  for (std::size_t at = 0; at < escaped.size();) {
    const bool begins = at == 0 || !is_of_a_name(escaped[at - 1]);
    const auto symbol = std::find_if(symbols.begin(), symbols.end(), [&](const auto& s) {
      const std::size_t end = at + s.first.size();
      return begins && escaped.substr(at).starts_with(s.first) &&
             (end == escaped.size() || !is_of_a_name(escaped[end]));
    });
    if (symbol != symbols.end()) {
      out += symbol->second;
      at += symbol->first.size();
      continue;
    }
    out += escaped[at];
    if (escaped[at++] == '_') out += "<wbr>";
  }
  return out;
}

std::string cell(const char* tag, const std::string& text, bool to_the_right) {
  return fmt::format("<{0}{1}>{2}</{0}>", tag,
                     to_the_right                   ? " class=\"n\""
                     : text.size() <= longest_whole ? " class=\"s\""
                                                    : "",
                     set_symbols(html_escape(text)));
}

/// Base64   [RFC 4648, section 4].
std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (k < here ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += k <= here ? letters[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

}  // namespace

std::string html_escape(std::string_view text) {
  std::string out;
  for (const char c : base::escaped(text, "\n\t")) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string html_page(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{3}</h1>\n{2}</body>\n</html>\n",
      html_escape(title), style, body, set_symbols(html_escape(title)));
}

std::string html_section(std::string_view title, std::string_view body) {
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", set_symbols(html_escape(title)), body);
}

std::string html_paragraph(std::string_view text) {
  return fmt::format("<p>{}</p>\n", set_symbols(html_escape(text)));
}

std::string html_lines(std::string_view text) { return "<pre>" + html_escape(text) + "</pre>"; }

std::string html_table(const Table& table) {
  std::string out = fmt::format("<div class=\"wide\"><table{}>\n<tr>",
                                table.head.size() > most_of_full_size ? " class=\"many\"" : "");
  std::vector<char> right;
  for (std::size_t k = 0; k < table.head.size(); ++k) {
    bool numbers = true;
    for (const auto& row : table.rows) numbers = numbers && is_numeric(row[k]);
    right.push_back(numbers);
    out += cell("th", table.head[k], numbers);
  }
  out += "</tr>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k) out += cell("td", row[k], right[k]);
    out += "</tr>\n";
  }
  return out + "</table></div>\n";
}

std::string html_facts(const Table& table) {
  std::string out = "<table class=\"facts\">\n";
  for (const auto& row : table.rows)
    out += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", html_escape(row[0]), html_escape(row[1]));
  return out + "</table>\n";
}

std::string html_pairs(const Table& table) {
  std::string out = "<ul class=\"pairs\">\n";
  for (const auto& row : table.rows)
    out += fmt::format("<li><span>{}</span> {}</li>\n", html_escape(row[0]), html_escape(row[1]));
  return out + "</ul>\n";
}

std::string html_list(const std::vector<std::string>& lines) {
  std::string out = "<ul>\n";
  for (const std::string& line : lines) out += fmt::format("<li>{}</li>\n", set_symbols(html_escape(line)));
  return out + "</ul>\n";
}

std::string html_figure(std::string_view svg, std::string_view caption) {
  return fmt::format("<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n", svg,
                     set_symbols(html_escape(caption)));
}

std::string html_picture(const std::filesystem::path& png, std::string_view caption) {
  return fmt::format(
      "<figure>\n<img alt=\"{0}\" "
      "src=\"data:image/png;base64,{1}\">\n<figcaption>{0}</figcaption>\n</figure>\n",
      html_escape(caption), base64(base::read_whole_file(png)));
}

}  // namespace rift::studio
