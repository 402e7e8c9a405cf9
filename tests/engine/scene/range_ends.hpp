#pragma once

#include "engine/scene/parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rift::scene {
namespace range_ends {

inline const std::vector<std::string> strange{
    "0", "-0.0", "5e-324", "1e-300", "1e300", "1.7976931348623157e308", "-1e300", "nan", "inf", "-inf"};

inline std::vector<std::string> around(const Range& range) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<std::string> values;
  for (const double end : {range.lower, range.upper})
    for (const double value : {end, std::nextafter(end, -infinite), std::nextafter(end, infinite)})
      values.push_back(fmt::format("{}", value));
  values.insert(values.end(), strange.begin(), strange.end());
  return values;
}

/// The strange numbers in a text's places "{}".
inline std::vector<std::string> in(std::initializer_list<const char*> texts) {
  std::vector<std::string> values;
  for (const char* text : texts)
    for (const std::string& number : strange) values.push_back(fmt::format(fmt::runtime(text), number));
  return values;
}

struct EndsOf {
  const Parameter& row;

  std::vector<std::string> operator()(double*) const { return around(row.range); }
  std::vector<std::string> operator()(std::optional<double>*) const { return around(row.range); }
  std::vector<std::string> operator()(Exponent) const { return around(row.range); }
  std::vector<std::string> operator()(int*) const { return integers(); }
  std::vector<std::string> operator()(long*) const { return integers(); }
  std::vector<std::string> operator()(std::vector<double>*) const {
    std::vector<std::string> lists;
    for (const std::string& value : around(row.range)) lists.push_back("[" + value + "]");
    return lists;
  }
  std::vector<std::string> operator()(std::vector<VelocityPiece>*) const {
    std::vector<std::string> values = in({"{} c_r", "{} m/s", "0.3 c_r until {} m, 0.5 c_r"});
    for (const char* value : {"1e-12 c_r", "1e-9 c_r", "2 c_r", "2.0000000000000004 c_r"})
      values.emplace_back(value);
    return values;
  }
  std::vector<std::string> operator()(CrackLine*) const {
    return in({"{} H", "{} m", "[[0, 6e-3], [{}, 6e-3]]", "[[0, 6e-3], [48e-3, {}]]"});
  }
  std::vector<std::string> operator()(std::vector<history::HistoryPoint>*) const {
    return in({"[[0, 1e-3], [{}, 24e-3]]", "[[0, 1e-3], [20e-6, {}]]", "[[{}, 1e-3], [20e-6, 24e-3]]",
               "[[0, 1e-3, {}], [10e-6, 12e-3, 1e-4], [20e-6, 24e-3, 1e-4]]"});
  }
  std::vector<std::string> operator()(fracture::CriticalRate*) const {
    return in({R"([["0 c_r", {}], ["0.9 c_r", 1e4]])", R"([["0 c_r", 1e4], ["{} c_r", 1e4]])"});
  }
  std::vector<std::string> operator()(LoadCurve*) const {
    return in({R"([[0, "6e-4 m"], [{}, "7e-4 m"]])", R"([[0, "{} m"], [1e-5, "7e-4 m"]])",
               R"([[0, "6e-4 m"], [1e-5, "{} m"]])", R"([[0, "{} N"], [1e-5, "100 N"]])"});
  }
  std::vector<std::string> operator()(std::vector<std::array<double, 2>>*) const {
    return in({"[[{}, 9e-3]]", "[[36e-3, {}]]"});
  }
  std::vector<std::string> operator()(std::optional<std::array<double, 2>>*) const {
    return in({"[{}, 0.4]", "[0.2, {}]"});
  }
  template <class Other>  // words hold no number
  std::vector<std::string> operator()(const Other&) const {
    return {};
  }

 private:
  std::vector<std::string> integers() const {
    std::vector<std::string> values{"2147483647",          "2147483648",           "9223372036854775807",
                                    "9223372036854775808", "18446744073709551616", "0.5"};
    for (const double end : {row.range.lower, row.range.upper})
      for (const double value : {end - 1, end, end + 1}) values.push_back(fmt::format("{:.0f}", value));
    values.insert(values.end(), strange.begin(), strange.end());
    return values;
  }
};

}  // namespace range_ends

/// Values at and beyond the ends of what a key takes, by the kind of its member: the ends and their
/// neighbours, 0, -0, the smallest and the largest doubles, NaN, infinity, integers that no integer holds.
/// None where the member holds no number.
inline std::vector<std::string> ends_of(const Parameter& row) {
  Scene scene{};
  return std::visit(range_ends::EndsOf{row}, row.slot(scene));
}

}  // namespace rift::scene
