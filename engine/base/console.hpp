#pragma once

#include "engine/base/text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

/// The one place that writes to standard output and standard error. Nothing here throws: a stream that cannot
/// be written never ends a computation.
namespace rift::base {

/// First thing in main: a standard stream that is closed becomes /dev/null, so that no file of ours takes its
/// number and is written into; a pipe without a reader is an error and no signal; and the terminal of another
/// job's foreground does not stop the process that writes to it or reads from it.
void secure_standard_streams() noexcept;

/// Writes the text to standard error as it is. What cannot be written within a second is lost.
void message_text(std::string_view text) noexcept;

/// Writes the text to standard output as it is; a failure is kept for printing_failure().
void print_text(std::string_view text) noexcept;

/// A path as a result on standard output: byte by byte for other programs, escaped on a terminal.
void print_path(const std::filesystem::path& path) noexcept;

/// Hands on what was printed. @return why some of it could not be written, as errno; 0 where all was
[[nodiscard]] int printing_failure() noexcept;

/// Counts as a failure to print, where none came before. @param error  an errno
void note_printing_failure(int error) noexcept;

/// Whether the descriptor is a terminal in whose foreground this process is: one that may be drawn on.
[[nodiscard]] bool in_foreground(int descriptor) noexcept;

/// Letters in a line of the terminal on this descriptor; 0 where it is none, or does not say.
[[nodiscard]] std::size_t terminal_width(int descriptor) noexcept;

/// A text among the arguments of a message is escaped; all else stays as it is.
template <typename T>
auto as_argument(const T& value) {
  if constexpr (std::convertible_to<const T&, std::string_view>)
    return escaped(std::string_view(value));
  else
    return value;
}

/// The format's text, its arguments that are texts escaped: they may come from anywhere.
template <typename... Args>
std::string text_with(fmt::string_view format, const Args&... arguments) {
  const auto formatted = [&](const auto&... harmless) {
    return fmt::vformat(format, fmt::make_format_args(harmless...));
  };
  return formatted(as_argument(arguments)...);
}

/// A message on standard error: fmt's format, the arguments that are texts escaped.
template <typename... Args>
void message(fmt::format_string<Args...> format, Args&&... arguments) noexcept try {
  message_text(text_with(format, arguments...));
} catch (...) {  // no memory for a message is no reason to end
}

/// A sentence on standard output: fmt's format, the arguments that are texts escaped.
template <typename... Args>
void print(fmt::format_string<Args...> format, Args&&... arguments) noexcept try {
  print_text(text_with(format, arguments...));
} catch (...) {
  note_printing_failure(ENOMEM);
}

}  // namespace rift::base
