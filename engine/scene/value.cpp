#include "engine/scene/value.hpp"

#include "engine/scene/wording.hpp"

#include <fmt/format.h>

namespace rift::scene {

namespace {

struct Kind {
  std::string_view operator()(bool) const { return "true or false"; }
  std::string_view operator()(std::int64_t) const { return "a whole number"; }
  std::string_view operator()(double) const { return "a number"; }
  std::string_view operator()(const std::string&) const { return "text"; }
  std::string_view operator()(const std::vector<Value>&) const { return "a list"; }
  std::string_view operator()(const Value::Other& other) const { return other.kind; }
};

struct Shown {
  std::string operator()(bool b) const { return b ? "true" : "false"; }
  std::string operator()(std::int64_t i) const { return fmt::format("{}", i); }
  std::string operator()(double d) const { return fmt::format("{}", d); }
  std::string operator()(const std::string& s) const { return '"' + printable(s) + '"'; }
  std::string operator()(const Value::Other& other) const { return '(' + other.kind + ')'; }
  std::string operator()(const std::vector<Value>& list) const {
    std::string out;
    for (const Value& value : list) {
      if (out.size() > 60) return '[' + out + ", ...]";
      out += (out.empty() ? "" : ", ") + shown(value);
    }
    return '[' + out + ']';
  }
};

}  // namespace

std::string_view kind_of(const Value& value) { return std::visit(Kind{}, value.held); }
std::string shown(const Value& value) { return std::visit(Shown{}, value.held); }

std::optional<double> number_in(const Value& value) {
  if (const auto* i = std::get_if<std::int64_t>(&value.held)) return static_cast<double>(*i);
  if (const auto* d = std::get_if<double>(&value.held)) return *d;
  return {};
}

std::string wrong_type(std::string_view expected, const Value& value) {
  const auto* text = std::get_if<std::string>(&value.held);
  return fmt::format("expected {}, got {}{}", expected, kind_of(value),
                     text && has_decimal_comma(*text) ? ": decimals have a point" : "");
}

}  // namespace rift::scene
