#include "engine/scene/crack_text.hpp"

#include "engine/scene/wording.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
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
    if (last && pieces[i].until) return "the last piece goes on to the end: leave its 'until' out";
    if (!last && !pieces[i].until)
      return "every piece but the last needs an 'until', such as \"0.2 c_r until 40 mm\"";
    if (!last && i > 0 && *pieces[i].until <= *pieces[i - 1].until)
      return "each 'until' must lie beyond the one before";
  }
  return {};
}

}  // namespace

Parsed<std::vector<VelocityPiece>> read_velocity(std::string_view text) {
  if (has_decimal_comma(text)) return {{}, "decimals have a point, as in \"0.5 c_r\""};
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
  if (has_decimal_comma(text)) return {{}, "decimals have a point, as in \"0.5 H\""};
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

}  // namespace rift::scene
