#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace rift::fuzz {

/// Takes numbers and texts off an input, zeros where it has come to its end.
struct Bytes {
  std::string_view left;

  template <class T>
  T number() {
    T value{};
    const std::size_t size = std::min(sizeof(T), left.size());
    std::copy_n(left.data(), size, reinterpret_cast<char*>(&value));
    left.remove_prefix(size);
    return value;
  }
  /// At most `most` bytes.
  std::string_view text(std::size_t most) {
    const std::string_view taken = left.substr(0, most);
    left.remove_prefix(taken.size());
    return taken;
  }
  bool empty() const { return left.empty(); }
};

inline Bytes bytes_of(const std::uint8_t* data, std::size_t size) {
  return {{reinterpret_cast<const char*>(data), size}};
}

}  // namespace rift::fuzz
