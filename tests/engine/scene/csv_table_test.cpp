#include "engine/scene/csv_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace rift::scene {
namespace {

constexpr std::array measured{CsvColumn{"time", Dimension::time, CsvNeed::needed, "t"},
                              CsvColumn{"position", Dimension::length, CsvNeed::needed, "a"},
                              CsvColumn{"uncertainty", Dimension::length, CsvNeed::optional}};

std::string problems_of(const std::string& text) {
  std::string out;
  for (const CsvProblem& problem : read_csv(text, measured).problems)
    out += fmt::format("{}: {}\n", problem.line, problem.text);
  return out;
}

/// "0 0.01; 5e-06 0.0111", the rows in SI, or the problems.
std::string rows_of(const std::string& text) {
  const CsvTable table = read_csv(text, measured);
  if (!table.problems.empty()) return problems_of(text);
  std::string out;
  for (std::size_t r = 0; r < table.line.size(); ++r)
    out += fmt::format("{}{} {}", out.empty() ? "" : "; ", table.column[0][r], table.column[1][r]);
  return out;
}

using Variant = std::pair<const char*, std::string>;

TEST(CsvTable, IsReadAsInstrumentsAndSpreadsheetsWriteIt) {
  const std::vector<Variant> variants{
      {"plain", "time [us];position [mm]\n0;10\n5;11.1\n"},
      {"quoted", "\"time [us]\",\"position [mm]\"\n\"0\",\"10\"\n\"5\",\"11.1\"\n"},
      {"separator in quotes", "comment;time [us];position [mm]\n\"a;b\";0;10\n\"say \"\"x\"\"; c\";5;11.1\n"},
      {"separator in a quoted header", "\"note; of camera\";time [us];position [mm]\n1;0;10\n2;5;11.1\n"},
      {"line end in quotes", "time [us];position [mm];note\n0;10;\"two\nlines\"\n5;11.1;\n"},
      {"line end in a quoted header", "\"time\n[us]\";\"position\n[mm]\"\n0;10\n5;11.1\n"},
      {"separator at the end", "time [us];position [mm];\n0;10;\n5;11.1;\n"},
      {"separators at the end of rows alone", "time [us];position [mm]\n0;10;;\n5;11.1;;\n"},
      {"no separator behind an empty comment", "time [us];position [mm];note\n0;10;x\n5;11.1\n"},
      {"blank rows", "\ntime [us];position [mm]\n\n0;10\n  \n5;11.1\n\n\n"},
      {"rows of separators", "time [us];position [mm]\n;\n0;10\n;;;\n5;11.1\n;\n"},
      {"separator named", "sep=;\ntime [us];position [mm]\n0;10\n5;11.1\n"},
      {"separator named, byte order mark",
       "\xEF\xBB\xBFSEP=,\r\ntime [us],position [mm]\r\n0,10\r\n5,11.1\r\n"},
      {"tab named", "sep=\t\ntime [us]\tposition [mm]\n0\t10\n5\t11.1\n"},
      {"columns beside", "frame;time [us];position [mm];grey value\n0;0;10;100\n1;5;11.1;n/a\n"},
      {"capitals", "Time [us];POSITION (mm)\n0;10\n5;11.1\n"},
      {"slash", "t / µs\ta / mm\n0\t10\n5\t11.1\n"},
      {"slash and bracket", "time / (us),position / [mm]\n0,10\n5,11.1\n"},
      {"underscore", "time_us,position_mm\n0,10\n5,11.1\n"},
      {"units below", "time;position\nus;mm\n0;10\n5;11.1\n"},
      {"units below in brackets, column beside", "Frame;Time;Position\n-;[us];[mm]\n1;0;10\n2;5;11.1\n"},
      {"units in both rows", "time [us];position [mm]\nus;mm\n0;10\n5;11.1\n"},
      {"unit of one below", "time [us];position\n;mm\n0;10\n5;11.1\n"},
      {"lines before the header", "Camera;HPV-X\nDate;2016-07-01\n\ntime [us];position [mm]\n0;10\n5;11.1\n"},
      {"header in a comment", "# time [us], position [mm]\n0,10\n5,11.1\n"},
      {"comma within a name", "time [us];position, corrected [mm];position [mm]\n0;1;10\n5;1;11.1\n"},
      {"two carriage returns", "time [us];position [mm]\r\r\n0;10\r\r\n5;11.1\r\r\n"},
  };
  for (const auto& [name, text] : variants) EXPECT_EQ(rows_of(text), "0 0.01; 5e-06 0.0111") << name;
}

TEST(CsvTable, NamesOnceWhatAllItsRowsShare) {
  const std::string head = "time [us];position [mm]\n";
  std::string utf16 = "\xFF\xFE", utf16_without_mark;
  for (const char c : head + "0;1\n") (utf16 += c) += '\0', (utf16_without_mark += c) += '\0';
  const std::string save = "save it as UTF-8 (in Excel: \"CSV UTF-8\")\n";
  const std::vector<std::pair<std::string, std::string>> said{
      {utf16, "1: the file is UTF-16: " + save},
      {utf16_without_mark, "1: the file is UTF-16: " + save},
      {std::string("\xFF\xFE\0\0t\0\0\0", 8), "1: the file is UTF-32: " + save},
      {"time [\xB5s];position [mm]\n0;1\n5;2\n",
       "1: the byte 0xB5 is no UTF-8, in Windows-1252 'µ': the file is of another encoding, " + save},
      {head + "0;1\n5;2;gr\xFC\xDFte\n",
       "3: the byte 0xFC is no UTF-8, in Windows-1252 'ü': the file is of another encoding, " + save},
      {head + std::string("0;\0\n", 4), "2: holds a zero byte: the file is no text\n"},
      {"time [us];position [mm]\r0;1\r5;2\r",
       "1: ends with a carriage return alone, as no line feed follows: save the file with line ends of Unix "
       "or "
       "Windows\n"},
      {head + "0,5;1,5\n1,5;2,5\n", "2: time '0,5' is not a number: use a decimal point\n"},
      {head + "12:00:00.5;1\n12:00:01;2\n",
       "2: time '12:00:00.5' is a time of day: write the time since the first row, such as 0.25\n"},
      {head + "0;\"1\n5;2\n10;3\n", "2: a quote opens here and never closes\n"},
  };
  for (const auto& [text, problem] : said) EXPECT_EQ(problems_of(text), problem) << text;
}

TEST(CsvTable, NamesTheColumnsFoundWhereOneIsMissing) {
  EXPECT_EQ(problems_of("frame;Zeit [us];grey value\n1;0;1\n"),
            "1: the header has no column time [ms] and position [mm]: it has 'frame', 'zeit' and "
            "'grey_value'\n");
  EXPECT_EQ(problems_of("tme [us];position [mm]\n0;1\n"), "1: unknown column 'tme', did you mean 'time'?\n");
  EXPECT_EQ(problems_of("time [us];position [mm];uncertanty [mm]\n0;1;2\n"),
            "1: unknown column 'uncertanty', did you mean 'uncertainty'?\n");
  EXPECT_EQ(problems_of("0;1\n5;2\n"), "1: holds no header, such as \"time [ms];position [mm]\"\n");
  EXPECT_EQ(problems_of("time [us] position [mm]\n0 1\n"),
            "1: the header has no column position [mm]: it has 'time'\n");
}

TEST(CsvTable, NamesUnitsThatAreMissingOrUnknownWhereTheyStand) {
  EXPECT_EQ(problems_of("time;position [mm]\n0;1\n"), "1: column 'time' has no unit: write \"time [ms]\"\n");
  EXPECT_EQ(problems_of("time;position\nmm;mm\n0;1\n"),
            "2: column 'time': unknown unit 'mm' for a time: use s, ms, us or ns\n");
  EXPECT_EQ(problems_of("time;position\nus;\n0;1\n"),
            "2: column 'position' has no unit: write \"position [mm]\"\n");
  EXPECT_EQ(problems_of("time [us];position [mm]\nms;mm\n0;1\n"),
            "2: time 'ms' is not a number\n2: position 'mm' is not a number\n");
}

TEST(CsvTable, ReadsAHundredThousandRowsAndSaysHowManyItMayHold) {
  std::string text = "time [us];position [mm]\n";
  for (int k = 0; k < 100000; ++k) text += fmt::format("{};{}\n", k, k);
  EXPECT_EQ(read_csv(text, measured).line.size(), 100000u);
  const CsvTable cut = read_csv(text, measured, 1000);
  ASSERT_EQ(cut.problems.size(), 1u);
  EXPECT_EQ(cut.problems[0].line, 1002);
  EXPECT_EQ(cut.problems[0].text, "more than 1000 rows: thin them out");
}

TEST(CsvTable, StopsReadingWhereItsRowsGoOnBeingWrong) {
  std::string text = "time [us];position [mm]\n";
  for (int k = 0; k < 100000; ++k) text += "x;y\n";
  const std::vector<CsvProblem> problems = read_csv(text, measured).problems;
  ASSERT_EQ(problems.size(), 101u);
  EXPECT_EQ(problems.back().text, "and so on: the following rows were not read");
}

TEST(CsvTable, KeepsTheNamesOfColumnsBeside) {
  EXPECT_EQ(read_csv("frame;time [us];position [mm];Grey Value;\n1;0;1;2;\n", measured).beside,
            (std::vector<std::string>{"frame", "grey_value"}));
}

}  // namespace
}  // namespace rift::scene
