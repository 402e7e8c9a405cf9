#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace rift::base {

// Tables of comma-separated values as every program reads them: a line a row, '\n' at its end.   [RFC 4180]

/// A text as a field: in quotes, its own quotes doubled, where it holds a comma, a quote or a line break.
[[nodiscard]] std::string csv_field(std::string_view text);

/// A number as a field: the shortest text that reads back to the same bits; empty where it is not finite.
[[nodiscard]] std::string csv_field(double number);

[[nodiscard]] inline std::string csv_field(float number) { return csv_field(static_cast<double>(number)); }

template <std::integral Integer>
[[nodiscard]] std::string csv_field(Integer number) {
  return std::to_string(number);
}

/// The fields of one row joined by commas, without a line end. Texts are quoted where they have to be.
template <typename First, typename... Others>
[[nodiscard]] std::string csv_fields(const First& first, const Others&... others) {
  std::string line = csv_field(first);
  ((line += ',', line += csv_field(others)), ...);
  return line;
}

/// One row with its line end.
template <typename... Fields>
[[nodiscard]] std::string csv_row(const Fields&... fields) {
  return csv_fields(fields...) + '\n';
}

}  // namespace rift::base
