#include "studio/graphics/answers.hpp"

#include <charconv>

namespace rift::studio {
namespace {

constexpr char escape = '\033';

/// Numbers between semicolons; what is none counts as 0.
std::vector<int> numbers_of(std::string_view text) {
  std::vector<int> numbers;
  while (true) {
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    numbers.push_back(number);
    const std::size_t next = text.find(';');
    if (next == std::string_view::npos) return numbers;
    text.remove_prefix(next + 1);
  }
}

bool ends_control(char c) { return c >= 0x40 && c <= 0x7e; }

/// Of a string such as "ESC _ ... ESC \", or one that BEL ends.
int length_of_string(std::string_view bytes) {
  for (std::size_t k = 2; k < bytes.size(); ++k) {
    if (bytes[k] == '\a') return static_cast<int>(k + 1);
    if (bytes[k] == '\\' && bytes[k - 1] == escape) return static_cast<int>(k + 1);
  }
  return 0;
}

bool is_size(int pixels) { return pixels > 0 && pixels < 100000; }

}  // namespace

int length_of_sequence(std::string_view bytes) {
  if (bytes.empty() || bytes[0] != escape) return -1;
  if (bytes.size() == 1) return 0;
  switch (bytes[1]) {
    case '[':
      for (std::size_t k = 2; k < bytes.size(); ++k)
        if (ends_control(bytes[k])) return static_cast<int>(k + 1);
      return 0;
    case '_':
    case 'P':
    case ']':
    case '^':
      return length_of_string(bytes);
    case 'O':
      return bytes.size() > 2 ? 3 : 0;
    default:
      return -1;
  }
}

void TerminalAnswers::take(std::string_view bytes) {
  rest_ += bytes;
  std::string_view left = rest_;
  while (!left.empty()) {
    const int length = length_of_sequence(left);
    if (length == 0) break;
    if (length < 0) {
      typed_ += left.front();
      left.remove_prefix(1);
    } else {
      read(left.substr(0, static_cast<std::size_t>(length)));
      left.remove_prefix(static_cast<std::size_t>(length));
    }
  }
  rest_ = std::string(left);
}

void TerminalAnswers::read(std::string_view sequence) {
  if (sequence.starts_with("\033_Gi=31;")) {
    found_.answers = true;
    found_.kitty = found_.kitty || sequence.find(";OK") != std::string_view::npos;
  } else if (sequence.starts_with("\033[")) {
    read_control(sequence.substr(2, sequence.size() - 3), sequence.back());
  } else if (sequence.starts_with("\033O")) {
    typed_ += sequence;
  }
}

void TerminalAnswers::read_cell(int width, int height) {
  if (is_cell(width, height)) found_.cell_width = width, found_.cell_height = height;
}

void TerminalAnswers::read_control(std::string_view parameters, char final) {
  const bool is_private = parameters.starts_with('?');
  const std::vector<int> n = numbers_of(is_private ? parameters.substr(1) : parameters);
  if (final == 'c' && is_private) {
    found_.answers = complete_ = true;
    for (std::size_t k = 1; k < n.size(); ++k) found_.sixel = found_.sixel || n[k] == 4;
  } else if (final == 't' && n.size() == 3 && is_size(n[1]) && is_size(n[2])) {
    found_.answers = true;
    if (n[0] == 6) read_cell(n[2], n[1]);
    if (n[0] == 4 && found_.cell_width == 0 && columns_ > 0 && rows_ > 0)
      read_cell(n[2] / columns_, n[1] / rows_);
  } else if (final == 'S' && is_private && n.size() == 4 && n[0] == 2 && n[1] == 0) {
    found_.answers = true;
    if (is_size(n[2]) && is_size(n[3])) found_.most_width = n[2], found_.most_height = n[3];
  } else if (final != 'S' && final != 't' && final != 'c') {
    typed_ += "\033[" + std::string(parameters) + final;  // an arrow, say
  }
}

}  // namespace rift::studio
