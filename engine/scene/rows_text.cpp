#include "engine/scene/rows_text.hpp"

#include "engine/scene/issue.hpp"
#include "engine/scene/toml_text.hpp"
#include "engine/scene/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace rift::scene {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 3> relaxations{
    {{"linear", 1.0}, {"square-root", 0.5}, {"quadratic", 2.0}}};

/// The number in "0.5 c_r" or "0.5 H"; nothing where the text does not end in `unit`.
std::optional<double> fraction_of(std::string_view text, std::string_view unit) {
  if (!text.ends_with(unit)) return {};
  text = trimmed(text.substr(0, text.size() - unit.size()));
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc{} || end != last) return {};
  return value;
}

Parsed<Speed> read_speed(std::string_view text) {
  const std::string out_of_range = fmt::format("must lie in (0, {}] c_r", highest_velocity_over_cr);
  if (const auto fraction = fraction_of(text, "c_r")) {
    if (!std::isfinite(*fraction)) return {{}, "must be a finite number"};
    if (!(*fraction > 0.0 && *fraction <= highest_velocity_over_cr)) return {{}, out_of_range};
    return {Speed{*fraction, true}, {}};
  }
  const Parsed<double> absolute = read_quantity(text, Dimension::speed);
  if (absolute.problem == "must be a finite number") return {{}, absolute.problem};
  if (!absolute.value) return {{}, "needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\""};
  if (!(*absolute.value > 0.0)) return {{}, out_of_range};
  return {Speed{*absolute.value, false}, {}};
}

Parsed<VelocityPiece> read_piece(std::string_view text) {
  const auto word = text.find(" until ");
  const Parsed<Speed> speed = read_speed(trimmed(text.substr(0, word)));
  if (!speed.value) return {{}, speed.problem};
  if (word == std::string_view::npos) return {VelocityPiece{*speed.value, {}}, {}};
  const Parsed<double> until = read_quantity(text.substr(word + 7), Dimension::length);
  if (!until.value) return {{}, "after 'until': " + until.problem};
  return {VelocityPiece{*speed.value, *until.value}, {}};
}

std::string order_problem(const std::vector<VelocityPiece>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool last = i + 1 == pieces.size();
    if (last && pieces[i].until) return "the last piece extends to the end: leave its 'until' out";
    if (!last && !pieces[i].until)
      return "every piece but the last needs an 'until', such as \"0.2 c_r until 40 mm\"";
    if (!last && i > 0 && *pieces[i].until <= *pieces[i - 1].until)
      return "each 'until' must lie beyond the one before";
  }
  return {};
}

}  // namespace

Parsed<std::vector<VelocityPiece>> read_velocity(std::string_view text) {
  if (has_decimal_comma(text)) return {{}, "use a decimal point, as in \"0.5 c_r\""};
  std::vector<VelocityPiece> pieces;
  const bool several = text.find(',') != std::string_view::npos;
  for (bool more = true; more;) {
    const auto comma = text.find(',');
    const Parsed<VelocityPiece> piece = read_piece(trimmed(text.substr(0, comma)));
    if (!piece.value) {
      return {{}, several ? fmt::format("piece {}: {}", pieces.size() + 1, piece.problem) : piece.problem};
    }
    pieces.push_back(*piece.value);
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
  }
  if (std::string problem = order_problem(pieces); !problem.empty()) return {{}, std::move(problem)};
  return {std::move(pieces), {}};
}

std::string velocity_text(const std::vector<VelocityPiece>& velocity) {
  std::string out;
  for (const VelocityPiece& piece : velocity) {
    const Speed& v = piece.speed;
    out += out.empty() ? "" : ", ";
    out += v.relative ? fmt::format("{} c_r", v.value) : quantity_text(v.value, Dimension::speed);
    if (piece.until) out += " until " + quantity_text(*piece.until, Dimension::length);
  }
  return out;
}

Parsed<CrackLine> read_path(std::string_view text) {
  text = trimmed(text);
  if (has_decimal_comma(text)) return {{}, "use a decimal point, as in \"0.5 H\""};
  if (const auto fraction = fraction_of(text, "H")) {
    if (!(*fraction > 0.0 && *fraction < 1.0)) return {{}, "must lie in (0, 1) H"};
    return {CrackLine{*fraction, true}, {}};
  }
  const Parsed<double> height = read_quantity(text, Dimension::length);
  if (height.problem == "must be a finite number") return {{}, height.problem};
  if (!height.value) return {{}, "expected the height of a straight path, such as \"0.5 H\" or \"20 mm\""};
  if (!(*height.value > 0.0)) return {{}, "must lie in (0, 1) H"};
  return {CrackLine{*height.value, false}, {}};
}

std::string path_text(const CrackLine& path) {
  return path.relative ? fmt::format("{} H", path.value) : quantity_text(path.value, Dimension::length);
}

Parsed<double> read_relaxation(std::string_view name) {
  for (const auto& [known, p] : relaxations) {
    if (known == name) return {p, {}};
  }
  return {{}, "must be \"linear\", \"square-root\", \"quadratic\" or a number in (0, 16]"};
}

std::string relaxation_name(double p) {
  for (const auto& [name, exponent] : relaxations) {
    if (exponent == p) return std::string(name);
  }
  return fmt::format("power({})", p);
}

namespace {

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

/// What stands in a column of the first row, where it is text.
const std::string* first_text(const Value& value, std::size_t column) {
  const auto* list = std::get_if<std::vector<Value>>(&value.held);
  const auto* row = list && !list->empty() ? std::get_if<std::vector<Value>>(&list->front().held) : nullptr;
  return row && row->size() > column ? std::get_if<std::string>(&(*row)[column].held) : nullptr;
}

/// What the rows of a critical rate are against, by the first of them.
std::optional<fracture::CriticalRate::Against> against(const Value& value) {
  const std::string* text = first_text(value, 0);
  if (!text) return {};
  if (text->ends_with("c_r")) return fracture::CriticalRate::Against::velocity_over_cr;
  if (read_quantity(*text, Dimension::speed).value) return fracture::CriticalRate::Against::velocity;
  if (read_quantity(*text, Dimension::length).value) return fracture::CriticalRate::Against::position;
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

/// Of what a load curve is, by the first of its rows.
std::optional<LoadCurve::Of> of_what(const Value& value) {
  const std::string* text = first_text(value, 1);
  if (!text) return {};
  if (read_quantity(*text, Dimension::length).value) return LoadCurve::Of::displacement;
  if (read_quantity(*text, Dimension::force).value) return LoadCurve::Of::force;
  return {};
}

std::string expected_rows(const char* expected, const Value& value) {
  return std::holds_alternative<std::vector<Value>>(value.held) ? fmt::format("expected {}", expected)
                                                                : wrong_type(expected, value);
}

/// "[a, b, ...]", or nothing of nothing.
template <class Row, class Text>
std::string list_of(const std::vector<Row>& rows, const Text& text) {
  std::string out;
  for (const Row& row : rows) out += (out.empty() ? "[" : ", ") + text(row);
  return out.empty() ? out : out + ']';
}

}  // namespace

std::string read_points(const Value& value, std::vector<std::array<double, 2>>& out) {
  constexpr std::array cells{Cell{"x", Dimension::length}, Cell{"y", Dimension::length}};
  return read_rows(value, cells, 2, "points such as [\"10 mm\", \"20 mm\"]", out);
}

std::string rows_text(const std::vector<std::array<double, 2>>& points) {
  return list_of(points, [](const std::array<double, 2>& p) {
    return fmt::format("[\"{}\", \"{}\"]", quantity_text(p[0], Dimension::length),
                       quantity_text(p[1], Dimension::length));
  });
}

std::string read_history(const Value& value, std::vector<history::HistoryPoint>& out) {
  constexpr std::array cells{Cell{"time", Dimension::time}, Cell{"position", Dimension::length},
                             Cell{"uncertainty", Dimension::length}};
  std::vector<std::array<double, 3>> rows;
  std::string problem =
      read_rows(value, cells, 2, "rows of time and position such as [\"4 us\", \"12 mm\"]", rows);
  if (!problem.empty()) return problem;
  out.clear();
  for (const auto& [time, position, uncertainty] : rows) out.push_back({time, position, uncertainty});
  return {};
}

std::string rows_text(const std::vector<history::HistoryPoint>& rows) {
  const bool known = !rows.empty() && rows.front().uncertainty > 0.0;
  return list_of(rows, [&](const history::HistoryPoint& p) {
    return known ? fmt::format("[{}, {}, {}]", p.time, p.position, p.uncertainty)
                 : fmt::format("[{}, {}]", p.time, p.position);
  });
}

std::string read_critical_rate(const Value& value, fracture::CriticalRate& out) {
  constexpr auto expected = "rows such as [\"0.1 c_r\", \"900 J/m2\"] or [\"10 mm\", \"900 J/m2\"]";
  const auto of = against(value);
  if (!of) return expected_rows(expected, value);
  fracture::CriticalRate read{.against = *of};
  const bool over_cr = *of == fracture::CriticalRate::Against::velocity_over_cr;
  const Cell first = *of == fracture::CriticalRate::Against::position ? Cell{"position", Dimension::length}
                     : over_cr                                        ? Cell{"velocity", Dimension::none}
                                                                      : Cell{"velocity", Dimension::speed};
  const std::array cells{first, Cell{"release rate", Dimension::release_rate}};
  std::string problem = read_rows(over_cr ? without_c_r(value) : value, cells, 2, expected, read.row);
  if (problem.empty()) out = std::move(read);
  return problem;
}

std::string rows_text(const fracture::CriticalRate& rate) {
  return list_of(rate.row, [&](const std::array<double, 2>& r) {
    const std::string at =
        rate.against == fracture::CriticalRate::Against::velocity_over_cr ? fmt::format("{} c_r", r[0])
        : rate.against == fracture::CriticalRate::Against::velocity ? quantity_text(r[0], Dimension::speed)
                                                                    : quantity_text(r[0], Dimension::length);
    return fmt::format("[\"{}\", \"{}\"]", at, quantity_text(r[1], Dimension::release_rate));
  });
}

std::string read_load_curve(const Value& value, LoadCurve& out) {
  constexpr auto expected = "rows such as [\"4 us\", \"2 mm\"] or [\"4 us\", \"20 kN\"]";
  const auto of = of_what(value);
  if (!of) return expected_rows(expected, value);
  LoadCurve read{.of = *of};
  const bool force = *of == LoadCurve::Of::force;
  const std::array cells{Cell{"time", Dimension::time},
                         force ? Cell{"force", Dimension::force} : Cell{"displacement", Dimension::length}};
  std::string problem = read_rows(value, cells, 2, expected, read.row);
  if (problem.empty()) out = std::move(read);
  return problem;
}

std::string rows_text(const LoadCurve& curve) {
  const Dimension load = curve.of == LoadCurve::Of::force ? Dimension::force : Dimension::length;
  return list_of(curve.row, [&](const std::array<double, 2>& r) {
    return fmt::format("[\"{}\", \"{}\"]", quantity_text(r[0], Dimension::time), quantity_text(r[1], load));
  });
}

}  // namespace rift::scene
