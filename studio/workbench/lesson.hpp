#pragma once

#include "engine/results/lane_summary.hpp"
#include "studio/screen/live.hpp"
#include "studio/text/table.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Lessons: a few pages of text, an ensemble that runs on the screen, a question, and the answer out of it.
namespace rift::studio {

/// The lanes of a run that has finished.
using Lanes = std::vector<results::LaneSummary>;

/// What the run has to say to the question.
struct Answer {
  int right = 0;    // of the choices
  std::string why;  // with the numbers of the run
};

struct Lesson {
  std::string_view name, title, preset;
  bool in_pixels;                        // is watched as a picture where the terminal has pixels
  std::vector<std::string_view> before;  // pages
  std::string_view watch;                // above the panel
  std::string_view question;
  std::vector<std::string_view> choices;
  Answer (*answer)(const Lanes& lanes);
  std::string_view after;
};

[[nodiscard]] std::span<const Lesson> lessons();
/// The page before the run of every lesson: which theories stand beside it, and what the letters mean.
[[nodiscard]] std::string_view theory_page();
/// Throws InputError with the nearest name where there is none.
[[nodiscard]] const Lesson& lesson_of(const std::string& name);

/// The numbers that the answer is read off, a row for each lane.
[[nodiscard]] Table lesson_table(const Lanes& lanes);

/// The plates of a lesson's run as a picture, or why there is none.
struct LessonPicture {
  std::filesystem::path png;
  std::string trouble;
};

/// Writes the lesson as one page of HTML, with picture, numbers and curves of the run beside theory.
/// @param live  of the run. Throws WorldError.
void write_handout(const Lesson& lesson, const Lanes& lanes, const Live& live, const LessonPicture& picture,
                   const std::filesystem::path& file);

}  // namespace rift::studio
