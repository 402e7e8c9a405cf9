#include "engine/measurement/traces.hpp"
#include "engine/scene/csv_table.hpp"
#include "engine/scene/issue.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/memory_file.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

// A file of measured curves: what has no problem is a table of finite numbers, whose columns are all as long
// as its rows; as curves to lay over a run, only InputError may leave.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rift;
  const std::string_view text = fuzz::bytes_of(data, size).left;
  constexpr std::array columns{
      scene::CsvColumn{"time", scene::Dimension::time, scene::CsvNeed::needed, "t"},
      scene::CsvColumn{"displacement", scene::Dimension::length, scene::CsvNeed::one_of},
      scene::CsvColumn{"force", scene::Dimension::force, scene::CsvNeed::one_of},
      scene::CsvColumn{"velocity", scene::Dimension::speed, scene::CsvNeed::optional, {}, "c_r"}};
  const scene::CsvTable table = scene::read_csv(text, columns);
  for (const scene::CsvProblem& problem : table.problems)
    if (problem.line < 1 || problem.text.empty()) std::abort();
  if (table.problems.empty())
    for (const std::vector<double>& column : table.column) {
      if (!column.empty() && column.size() != table.line.size()) std::abort();
      for (const double number : column)
        if (!std::isfinite(number)) std::abort();
    }
  static fuzz::MemoryFile file;
  try {
    for (const measurement::Trace& trace : measurement::read_traces(
             file.holding(text), {{"grip_force", scene::Dimension::force, {}, {}},
                                  {"gauge0_strain_yy", scene::Dimension::strain, {}, {}}}))
      if (trace.time.size() != trace.value.size()) std::abort();
  } catch (const scene::InputError&) {
  }
  return 0;
}
