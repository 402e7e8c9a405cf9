#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace rift::base {

// Texts that come from outside: names of files, what a user wrote, what another program said.

/// The text as every terminal, table and page can show it: control characters (C0, DEL and C1) and bytes that
/// are no UTF-8 become `\xNN`, all else stays. Twice escaped is once escaped.
/// @param kept  control characters that stay, such as "\n\t"
[[nodiscard]] std::string escaped(std::string_view text, std::string_view kept = {});

/// A number with its noun: "1 rattler", "2 rattlers", "3 histories".
/// @param plural  of the noun; by default with an "s"
[[nodiscard]] std::string counted(std::int64_t count, std::string_view noun, std::string_view plural = {});

// Letters of UTF-8.

/// How many bytes the letter takes with which the text begins, 0 where it begins with none: overlong forms,
/// surrogates and values beyond U+10FFFF are none.   [RFC 3629, section 4]
[[nodiscard]] std::size_t bytes_of_first_letter(std::string_view text);

/// Whether a byte belongs to a letter that began before it.
constexpr bool continues_letter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// The text's letters; each byte that is no UTF-8 becomes '?'.
[[nodiscard]] std::u32string letters_of(std::string_view text);

/// Letters of a text: the cells that it takes on a terminal.
[[nodiscard]] std::size_t count_letters(std::string_view text);

void append_letter(std::string& text, char32_t letter);

/// A text of TOML without the quotes around it, anything else as it is.
[[nodiscard]] std::string without_quotes(std::string_view text);

/// The value as JSON text: valid UTF-8 without control characters whatever its strings hold. Bytes that are
/// no UTF-8 become U+FFFD, DEL and C1 characters `\u00NN`; a number that is not finite becomes null.
/// @param indent  spaces a level, on a line for each value; negative for all on one line
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& value, int indent = -1);
[[nodiscard]] std::string json_text(const nlohmann::json& value, int indent = -1);

}  // namespace rift::base
