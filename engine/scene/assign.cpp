#include "engine/scene/issue.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/rows_text.hpp"
#include "engine/scene/toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace rift::scene {

namespace {

bool in_range(double x, const Range& range) {
  const bool high_enough = range.lower_open ? x > range.lower : x >= range.lower;
  const bool low_enough = range.upper_open ? x < range.upper : x <= range.upper;
  return high_enough && low_enough;
}

std::string number_text(double x) {
  if (x < 1e10) return fmt::format("{}", x);
  const std::string text = fmt::format("{:.0e}", x);  // 1e+13 rather than a row of zeros
  return std::stod(text) == x ? text.substr(0, 1) + 'e' + text.substr(3) : fmt::format("{}", x);
}

std::string range_text(const Parameter& row) {
  const Range& r = row.range;
  const std::string unit = row.dimension == Dimension::none ? "" : fmt::format(" {}", si_unit(row.dimension));
  if (r.lower == r.upper) return number_text(r.lower) + unit;
  return fmt::format("{}{}, {}{}{}", r.lower_open ? '(' : '[', number_text(r.lower), number_text(r.upper),
                     r.upper_open ? ')' : ']', unit);
}

std::string choices_text(const Parameter& row, std::string_view last) {
  std::vector<std::string> words;
  for (const std::string_view word : row.choices) words.push_back(fmt::format("\"{}\"", word));
  return listed(words, last);
}

std::string must_lie(const Parameter& row) {
  return (row.range.lower == row.range.upper ? "must be " : "must lie in ") + range_text(row);
}

/// A number of the row's dimension, within its range.
Parsed<double> read_number(const Parameter& row, const Value& value) {
  const auto* text = std::get_if<std::string>(&value.held);
  const bool has_unit = row.dimension != Dimension::none;
  Parsed<double> number;
  if (text && has_unit) {
    number = read_quantity(*text, row.dimension);
    if (!number.value) return number;
  } else {
    number.value = number_in(value);
  }
  if (!number.value) {
    const std::string expected =
        has_unit ? fmt::format("{} such as \"{}\" or a number of {}", dimension_name(row.dimension),
                               example_quantity(row.dimension), si_unit(row.dimension))
                 : std::string("a number");
    return {{}, wrong_type(expected, value)};
  }
  if (!std::isfinite(*number.value)) return {{}, "must be a finite number"};
  if (!in_range(*number.value, row.range)) return {{}, must_lie(row)};
  return number;
}

/// A whole number within the row's range; 2e4 counts as one.
template <class Integer>
std::string read_integer(const Parameter& row, const Value& value, Integer& out) {
  const std::optional<double> number = number_in(value);
  if (!number) return wrong_type("a whole number", value);
  if (!std::isfinite(*number)) return "must be a finite number";
  if (*number != std::floor(*number)) return "must be a whole number";
  if (!in_range(*number, row.range)) return must_lie(row);
  out = static_cast<Integer>(*number);
  return {};
}

std::string read_words(const Parameter& row, const Value& value, std::vector<std::string>& out) {
  const auto* list = std::get_if<std::vector<Value>>(&value.held);
  if (!list) return wrong_type("a list of " + choices_text(row, "and"), value);
  std::vector<std::string> words;
  for (const Value& item : *list) {
    const auto* word = std::get_if<std::string>(&item.held);
    const bool known = word && std::find(row.choices.begin(), row.choices.end(), *word) != row.choices.end();
    if (!known) return fmt::format("{} is none of {}", shown(item), choices_text(row, "and"));
    if (std::find(words.begin(), words.end(), *word) != words.end())
      return fmt::format("{} twice", shown(item));
    words.push_back(*word);
  }
  out = std::move(words);
  return {};
}

std::string read_rising(const Parameter& row, const Value& value, std::vector<double>& out) {
  const auto* list = std::get_if<std::vector<Value>>(&value.held);
  if (!list || list->empty()) return wrong_type("a list of numbers", value);
  std::vector<double> numbers;
  for (const Value& item : *list) {
    const std::optional<double> number = number_in(item);
    if (!number || !in_range(*number, row.range))
      return fmt::format("{}: each {}", shown(item), must_lie(row));
    if (!numbers.empty() && *number <= numbers.back()) return fmt::format("{}: must rise", shown(item));
    numbers.push_back(*number);
  }
  out = std::move(numbers);
  return {};
}

std::string read_window(const Value& value, std::optional<std::array<double, 2>>& out) {
  const auto* list = std::get_if<std::vector<Value>>(&value.held);
  if (!list) return wrong_type("two fractions of the length such as [0.2, 0.4]", value);
  if (list->size() != 2) return "must be two fractions of the length such as [0.2, 0.4]";
  const std::optional<double> lower = number_in((*list)[0]), upper = number_in((*list)[1]);
  if (!lower || !upper) return "must be two fractions of the length such as [0.2, 0.4]";
  if (!(0.0 <= *lower && *lower < *upper && *upper <= 1.0)) return "must rise within [0, 1]";
  out = {*lower, *upper};
  return {};
}

/// Stores what a parser gave.
template <class T>
std::string take(const Parsed<T>& parsed, auto& out) {
  if (parsed.value) out = *parsed.value;
  return parsed.problem;
}

/// One way of reading per kind of member.
struct Assign {
  const Parameter& row;
  const Value& value;

  std::string operator()(double* out) const { return take(read_number(row, value), *out); }
  std::string operator()(std::optional<double>* out) const { return take(read_number(row, value), *out); }
  std::string operator()(int* out) const { return read_integer(row, value, *out); }
  std::string operator()(long* out) const { return read_integer(row, value, *out); }
  std::string operator()(std::vector<std::string>* out) const { return read_words(row, value, *out); }
  std::string operator()(std::vector<double>* out) const { return read_rising(row, value, *out); }
  std::string operator()(std::optional<std::array<double, 2>>* out) const { return read_window(value, *out); }

  std::string operator()(bool* out) const {
    const auto* truth = std::get_if<bool>(&value.held);
    if (truth) *out = *truth;
    return truth ? std::string{} : wrong_type("true or false", value);
  }
  std::string operator()(Word out) const {
    const auto* word = std::get_if<std::string>(&value.held);
    if (!word) return wrong_type(row.choices.empty() ? "text" : choices_text(row, "or"), value);
    if (!row.choices.empty() && std::find(row.choices.begin(), row.choices.end(), *word) == row.choices.end())
      return "must be " + choices_text(row, "or");
    *out.p = *word;
    return {};
  }
  std::string operator()(Exponent exponent) const {
    if (const auto* name = std::get_if<std::string>(&value.held))
      return take(read_relaxation(*name), *exponent.p);
    if (!number_in(value)) return wrong_type("\"linear\", \"square-root\", \"quadratic\" or a number", value);
    return take(read_number(row, value), *exponent.p);
  }
  std::string operator()(std::vector<VelocityPiece>* out) const {
    if (const auto* text = std::get_if<std::string>(&value.held)) return take(read_velocity(*text), *out);
    if (number_in(value)) return "needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\"";
    return wrong_type("a speed such as \"0.5 c_r\" or \"1100 m/s\"", value);
  }
  std::string operator()(CrackLine* out) const {
    if (const auto* text = std::get_if<std::string>(&value.held)) return take(read_path(*text), *out);
    if (std::holds_alternative<std::vector<Value>>(value.held)) {
      CrackLine line;
      std::string problem = read_points(value, line.point);
      if (problem.empty()) *out = std::move(line);
      return problem;
    }
    const std::optional<double> height = number_in(value);
    if (!height) return wrong_type("a height such as \"0.5 H\" or \"20 mm\"", value);
    if (!std::isfinite(*height)) return "must be a finite number";
    if (*height <= 0.0) return "must lie in (0, 1) H";
    *out = {*height, false};
    return {};
  }
  std::string operator()(std::vector<history::HistoryPoint>* out) const { return read_history(value, *out); }
  std::string operator()(std::vector<std::array<double, 2>>* out) const { return read_points(value, *out); }
  std::string operator()(fracture::CriticalRate* out) const { return read_critical_rate(value, *out); }
  std::string operator()(LoadCurve* out) const { return read_load_curve(value, *out); }
  template <class Enum>
  requires std::is_enum_v<Enum> std::string operator()(Enum* out) const {
    const auto* word = std::get_if<std::string>(&value.held);
    if (!word) return wrong_type(choices_text(row, "or"), value);
    const auto found = std::find(row.choices.begin(), row.choices.end(), *word);
    if (found == row.choices.end()) return "must be " + choices_text(row, "or");
    *out = static_cast<Enum>(found - row.choices.begin());  // the choices stand in the order of the enum
    return {};
  }
};

/// A text as a basic string of TOML.
std::string toml_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      out += fmt::format("\\u{:04x}", byte);
    } else {
      out += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
  }
  return out + '"';
}

/// And one way of writing.
struct Write {
  const Parameter& row;

  std::string operator()(const double* x) const {
    const std::string text = quantity_text(*x, row.dimension);
    return row.dimension == Dimension::none ? text : '"' + text + '"';
  }
  std::string operator()(const std::optional<double>* x) const { return *x ? (*this)(&**x) : std::string{}; }
  std::string operator()(const int* i) const { return fmt::format("{}", *i); }
  std::string operator()(const long* i) const { return fmt::format("{}", *i); }
  std::string operator()(const bool* truth) const { return *truth ? "true" : "false"; }
  std::string operator()(Word word) const { return toml_string(*word.p); }
  std::string operator()(Exponent exponent) const {
    const std::string name = relaxation_name(*exponent.p);
    return read_relaxation(name).value ? '"' + name + '"' : fmt::format("{}", *exponent.p);
  }
  std::string operator()(const std::vector<VelocityPiece>* v) const { return '"' + velocity_text(*v) + '"'; }
  std::string operator()(const CrackLine* path) const {
    if (path->point.empty()) return '"' + path_text(*path) + '"';
    return (*this)(&path->point);
  }
  std::string operator()(const std::vector<history::HistoryPoint>* rows) const { return rows_text(*rows); }
  std::string operator()(const std::vector<std::array<double, 2>>* points) const {
    return rows_text(*points);
  }
  std::string operator()(const fracture::CriticalRate* rate) const { return rows_text(*rate); }
  std::string operator()(const LoadCurve* curve) const { return rows_text(*curve); }
  std::string operator()(const std::vector<std::string>* words) const {
    std::string out;
    for (const std::string& word : *words) out += (out.empty() ? "\"" : ", \"") + word + '"';
    return '[' + out + ']';
  }
  std::string operator()(const std::vector<double>* numbers) const {
    return fmt::format("[{}]", fmt::join(*numbers, ", "));
  }
  std::string operator()(const std::optional<std::array<double, 2>>* w) const {
    return *w ? fmt::format("[{}, {}]", (**w)[0], (**w)[1]) : std::string{};
  }
  template <class Enum>
  requires std::is_enum_v<Enum> std::string operator()(const Enum* e) const {
    return fmt::format("\"{}\"", row.choices.at(static_cast<std::size_t>(*e)));
  }
};

/// What the row allows, by the kind of its member.
struct Allowed {
  const Parameter& row;

  std::string operator()(const std::vector<VelocityPiece>*) const {
    return fmt::format("(0, {}] c_r", highest_velocity_over_cr);
  }
  std::string operator()(const CrackLine*) const {
    return "(0, 1) H, a length below H, or points in the plate";
  }
  std::string operator()(const std::vector<history::HistoryPoint>*) const {
    return "rows of time and position, in time and never backward";
  }
  std::string operator()(const std::vector<std::array<double, 2>>*) const { return "points in the plate"; }
  std::string operator()(const fracture::CriticalRate*) const {
    return "rows of velocity (or position) and release rate, both at least 0 and the first rising";
  }
  std::string operator()(const LoadCurve*) const {
    return "rows of time and displacement (or force), in time";
  }
  std::string operator()(const std::vector<std::string>*) const {
    return "any of " + choices_text(row, "and");
  }
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(Word) const { return row.choices.empty() ? "any text" : choices_text(row, "or"); }
  std::string operator()(Exponent) const {
    return "\"linear\", \"square-root\", \"quadratic\" or a number in " + range_text(row);
  }
  std::string operator()(const std::vector<double>*) const { return "rising within " + range_text(row); }
  std::string operator()(const std::optional<std::array<double, 2>>*) const { return "rising within [0, 1]"; }
  template <class Member>
  std::string operator()(const Member*) const {
    return std::is_enum_v<Member> ? choices_text(row, "or") : range_text(row);
  }
};

}  // namespace

std::string assign(Scene& scene, const Parameter& row, const Value& value) {
  return std::visit(Assign{row, value}, row.slot(scene));
}

std::string toml_value(const Scene& scene, const Parameter& row) {
  Scene copy = scene;  // a slot points to a member that may be written
  return std::visit(Write{row}, row.slot(copy));
}

std::string allowed(const Parameter& row) {
  Scene scene{};
  return std::visit(Allowed{row}, row.slot(scene));
}

}  // namespace rift::scene
