#pragma once

#include "studio/graphics/protocol.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

/// Reads what a terminal answers to question_for(), in whatever pieces it comes and whatever stands between.
class TerminalAnswers {
 public:
  /// @param columns, rows  of the terminal: by them a window's size gives a cell's
  TerminalAnswers(int columns, int rows) : columns_(columns), rows_(rows) {}

  void take(std::string_view bytes);
  /// The last answer has come.
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] const Capabilities& capabilities() const { return found_; }
  /// What was no answer: keys that were typed meanwhile, an escape at the end among them.
  [[nodiscard]] std::string typed() const { return rest_ == "\033" ? typed_ + rest_ : typed_; }

 private:
  void read(std::string_view sequence);
  void read_cell(int width, int height);
  void read_control(std::string_view parameters, char final);

  int columns_, rows_;
  Capabilities found_;
  bool complete_ = false;
  std::string rest_, typed_;
};

/// The control sequence with which the bytes begin: its length, or 0 where it has begun and not ended, or -1
/// where the bytes begin with none.
[[nodiscard]] int length_of_sequence(std::string_view bytes);

}  // namespace rift::studio
