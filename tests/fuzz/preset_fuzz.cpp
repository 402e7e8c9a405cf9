#include "engine/scene/preset.hpp"
#include "tests/fuzz/bytes.hpp"

#include <cstdlib>

// A preset, and behind a null byte overrides, each ended by another. What is read without an issue can be
// written and read again, without an issue and to the same text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view input = rift::fuzz::bytes_of(data, size).left;
  std::vector<std::string> parts(1);
  for (const char c : input)
    if (c != '\0')
      parts.back() += c;
    else
      parts.emplace_back();
  const rift::scene::Preset preset =
      rift::scene::read_preset_text(parts.front(), "fuzz.toml", {parts.begin() + 1, parts.end()});
  for (const rift::scene::Issue& issue : preset.issues)
    if (rift::scene::to_text(issue).empty()) std::abort();
  if (!preset.issues.empty() || preset.study.size() > 100) return 0;
  const std::string text = rift::scene::preset_text(preset);
  const rift::scene::Preset again = rift::scene::read_preset_text(text, "again.toml");
  if (!again.issues.empty() || rift::scene::preset_text(again) != text) std::abort();
  return 0;
}
