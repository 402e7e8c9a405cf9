#include "engine/scene/crack_text.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/toml_text.hpp"
#include "engine/scene/wording.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace rift {

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

std::string wrong_type(std::string_view expected, const Value& value) {
  return fmt::format("expected {}, got {}", expected, kind_of(value));
}

/// A bare number, whole or not.
std::optional<double> number_in(const Value& value) {
  if (const auto* i = std::get_if<std::int64_t>(&value.held)) return static_cast<double>(*i);
  if (const auto* d = std::get_if<double>(&value.held)) return *d;
  return {};
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

/// What a number of a row may be.
struct Cell {
  std::string_view name;
  Dimension dimension;
};

/// A number in SI, or text with its unit.
Parsed<double> read_cell(const Value& value, const Cell& cell) {
  Parsed<double> number;
  const auto* text = std::get_if<std::string>(&value.held);
  if (text && cell.dimension == Dimension::none)
    number.problem = fmt::format("{} must be in c_r, as in the first row", shown(value));
  else if (text)
    number = read_quantity(*text, cell.dimension);
  else if (const auto bare = number_in(value))
    number.value = bare;
  else
    number.problem = wrong_type(fmt::format("{} in {}", cell.name, si_unit(cell.dimension)), value);
  if (number.value && !std::isfinite(*number.value)) return {{}, "must be a finite number"};
  return number;
}

/// Rows of at least `fewest` of the cells; those left out are 0.
template <std::size_t Cells>
std::string read_rows(const Value& value, const std::array<Cell, Cells>& cells, std::size_t fewest,
                      const char* expected, std::vector<std::array<double, Cells>>& out) {
  const auto* list = std::get_if<std::vector<Value>>(&value.held);
  if (!list) return wrong_type(expected, value);
  std::vector<std::array<double, Cells>> rows;
  for (std::size_t r = 0; r < list->size(); ++r) {
    const auto* row = std::get_if<std::vector<Value>>(&(*list)[r].held);
    if (!row || row->size() < fewest || row->size() > Cells)
      return fmt::format("row {}: {}", r + 1, wrong_type(expected, (*list)[r]));
    rows.emplace_back();
    for (std::size_t c = 0; c < row->size(); ++c) {
      const Parsed<double> number = read_cell((*row)[c], cells[c]);
      if (!number.value) return fmt::format("row {}, {}: {}", r + 1, cells[c].name, number.problem);
      rows.back()[c] = *number.value;
    }
  }
  if (rows.empty()) return fmt::format("expected {}", expected);
  out = std::move(rows);
  return {};
}

/// Points of the plate.
std::string read_points(const Value& value, std::vector<std::array<double, 2>>& out) {
  constexpr std::array cells{Cell{"x", Dimension::length}, Cell{"y", Dimension::length}};
  return read_rows(value, cells, 2, "points such as [\"10 mm\", \"20 mm\"]", out);
}

/// What the rows of a critical rate are against, by the first of them.
std::optional<CriticalRate::Against> against(const Value& value) {
  const auto* list = std::get_if<std::vector<Value>>(&value.held);
  const auto* row = list && !list->empty() ? std::get_if<std::vector<Value>>(&list->front().held) : nullptr;
  const auto* text = row && !row->empty() ? std::get_if<std::string>(&row->front().held) : nullptr;
  if (!text) return {};
  if (text->ends_with("c_r")) return CriticalRate::Against::velocity_over_cr;
  if (read_quantity(*text, Dimension::speed).value) return CriticalRate::Against::velocity;
  if (read_quantity(*text, Dimension::length).value) return CriticalRate::Against::position;
  return {};
}

/// The same list with "0.1 c_r" as 0.1.
Value without_c_r(const Value& value) {
  Value out = value;
  for (Value& row : std::get<std::vector<Value>>(out.held)) {
    auto* cells = std::get_if<std::vector<Value>>(&row.held);
    auto* text = cells && !cells->empty() ? std::get_if<std::string>(&cells->front().held) : nullptr;
    if (text && text->ends_with("c_r")) cells->front() = value_from_text(text->substr(0, text->size() - 3));
  }
  return out;
}

std::string read_critical_rate(const Value& value, CriticalRate& out) {
  constexpr auto expected = "rows such as [\"0.1 c_r\", \"900 J/m2\"] or [\"10 mm\", \"900 J/m2\"]";
  const auto of = against(value);
  if (!of)
    return std::holds_alternative<std::vector<Value>>(value.held) ? fmt::format("expected {}", expected)
                                                                  : wrong_type(expected, value);
  CriticalRate read{.against = *of};
  const bool over_cr = *of == CriticalRate::Against::velocity_over_cr;
  const Cell first = *of == CriticalRate::Against::position ? Cell{"position", Dimension::length}
                     : over_cr                              ? Cell{"velocity", Dimension::none}
                                                            : Cell{"velocity", Dimension::speed};
  const std::array cells{first, Cell{"release rate", Dimension::release_rate}};
  std::string problem = read_rows(over_cr ? without_c_r(value) : value, cells, 2, expected, read.row);
  if (problem.empty()) out = std::move(read);
  return problem;
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
  std::string operator()(std::vector<HistoryPoint>* out) const {
    constexpr std::array cells{Cell{"time", Dimension::time}, Cell{"position", Dimension::length},
                               Cell{"uncertainty", Dimension::length}};
    std::vector<std::array<double, 3>> rows;
    std::string problem =
        read_rows(value, cells, 2, "rows of time and position such as [\"4 us\", \"12 mm\"]", rows);
    if (!problem.empty()) return problem;
    out->clear();
    for (const auto& [time, position, uncertainty] : rows) out->push_back({time, position, uncertainty});
    return {};
  }
  std::string operator()(std::vector<std::array<double, 2>>* out) const { return read_points(value, *out); }
  std::string operator()(CriticalRate* out) const { return read_critical_rate(value, *out); }
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
std::string quoted(std::string_view text) {
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

/// "[a, b, ...]", or nothing of nothing.
template <class Row, class Text>
std::string list_of(const std::vector<Row>& rows, const Text& text) {
  std::string out;
  for (const Row& row : rows) out += (out.empty() ? "[" : ", ") + text(row);
  return out.empty() ? out : out + ']';
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
  std::string operator()(Word word) const { return quoted(*word.p); }
  std::string operator()(Exponent exponent) const {
    const std::string name = relaxation_name(*exponent.p);
    return read_relaxation(name).value ? '"' + name + '"' : fmt::format("{}", *exponent.p);
  }
  std::string operator()(const std::vector<VelocityPiece>* v) const { return '"' + velocity_text(*v) + '"'; }
  std::string operator()(const CrackLine* path) const {
    if (path->point.empty()) return '"' + path_text(*path) + '"';
    return (*this)(&path->point);
  }
  std::string operator()(const std::vector<HistoryPoint>* rows) const {
    const bool known = !rows->empty() && rows->front().uncertainty > 0.0;
    return list_of(*rows, [&](const HistoryPoint& p) {
      return known ? fmt::format("[{}, {}, {}]", p.time, p.position, p.uncertainty)
                   : fmt::format("[{}, {}]", p.time, p.position);
    });
  }
  std::string operator()(const std::vector<std::array<double, 2>>* points) const {
    return list_of(*points, [](const std::array<double, 2>& p) {
      return fmt::format("[\"{}\", \"{}\"]", quantity_text(p[0], Dimension::length),
                         quantity_text(p[1], Dimension::length));
    });
  }
  std::string operator()(const CriticalRate* rate) const {
    return list_of(rate->row, [&](const std::array<double, 2>& r) {
      const std::string at =
          rate->against == CriticalRate::Against::velocity_over_cr ? fmt::format("{} c_r", r[0])
          : rate->against == CriticalRate::Against::velocity       ? quantity_text(r[0], Dimension::speed)
                                                                   : quantity_text(r[0], Dimension::length);
      return fmt::format("[\"{}\", \"{}\"]", at, quantity_text(r[1], Dimension::release_rate));
    });
  }
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
  std::string operator()(const std::vector<HistoryPoint>*) const {
    return "rows of time and position, in time and never backward";
  }
  std::string operator()(const std::vector<std::array<double, 2>>*) const { return "points in the plate"; }
  std::string operator()(const CriticalRate*) const {
    return "rows of velocity (or position) and release rate, both at least 0 and the first rising";
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

}  // namespace rift
