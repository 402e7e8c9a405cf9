#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rift::scene {

/// A value as the user wrote it, before it means anything: what TOML knows, without the TOML library.
struct Value {
  /// Something no parameter takes: "a table", "a date", "a time".
  struct Other {
    std::string kind;
  };
  std::variant<bool, std::int64_t, double, std::string, std::vector<Value>, Other> held;
};

/// "text", "a whole number", "a number", "true or false", "a list", "a table", ...
std::string_view kind_of(const Value& value);

/// The value on one short line as a message shows it: "5 c_r" with its quotes, [0.2, 0.4], nan.
std::string shown(const Value& value);

/// A bare number, whole or not.
std::optional<double> number_in(const Value& value);

/// "expected a list, got text".
std::string wrong_type(std::string_view expected, const Value& value);

}  // namespace rift::scene
