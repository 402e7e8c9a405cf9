#pragma once

#include "engine/study/runner.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

// The scenarios of a study by their axes, and how axes read.

/// Rows that differ at most in the axes left out, and what they have in common.
struct RowFamily {
  study::AxisTexts axes;
  std::vector<study::SummaryRow> rows;
};

/// Rows by the axes other than `without`, families and rows in the order of the study.
std::vector<RowFamily> families(const study::StudyRows& rows, const std::vector<std::string>& without);

/// Mean of a number of the rows and its standard deviation (n - 1), NaN of fewer than two; what is undefined
/// does not count.
struct MeanScatter {
  double mean, scatter;
  int count;
};
MeanScatter mean_over(const std::vector<study::SummaryRow>& rows, double study::SummaryRow::*number);

/// An axis' value, "-" where the axes do not hold it.
std::string value_of_axis(const study::AxisTexts& axes, std::string_view name);

/// The number with which a value begins, NaN of a word: 0.5 of "0.5 c_r".
double number_of_value(const std::string& text);

/// The values of an axis in the study, each once and without "-": numbers ascending, words in the study's
/// order.
std::vector<std::string> values_of_axis(const study::StudyRows& rows, const std::string& name);

/// The axes of which the study has more than one value ("-" counts), in its order.
std::vector<std::string> varied_axes(const study::StudyRows& rows);

/// Whether the values of an axis are numbers, so that they have an order.
bool is_ordered_axis(const study::StudyRows& rows, const std::string& name);

/// An axis as a heading in words: "step over critical", "r_l".
std::string axis_in_words(const std::string& name);

/// What sets a scenario or a family apart, as a label of a chart: "progressive, linear, r_l = 1, 0.5 c_R".
std::string axes_label(const study::AxisTexts& axes);

}  // namespace rift::studio
