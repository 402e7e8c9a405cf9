#pragma once

#include "viz/order.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rift::viz {

/// Memory that the program and a drawing program both see: an Answer and the bytes of a picture. It has no
/// name, and goes with the last process that has it.
class SharedFrame {
 public:
  /// Makes it. Throws std::system_error.
  SharedFrame();
  /// That of another process, which has made it. The descriptor is closed with the object.
  explicit SharedFrame(int descriptor) : descriptor_(descriptor) {}
  ~SharedFrame();
  SharedFrame(const SharedFrame&) = delete;
  SharedFrame& operator=(const SharedFrame&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Makes it as large as this frame needs, if it is not: before the frame is asked for. Throws
  /// std::system_error.
  void make_room(int width, int height);
  /// What lies in it; room must have been made. Throws std::system_error where it cannot be seen.
  [[nodiscard]] Answer& answer(int width, int height);
  [[nodiscard]] std::span<std::uint8_t> pixels(int width, int height);

 private:
  std::uint8_t* seen(std::size_t bytes);

  int descriptor_;
  std::size_t size_ = 0, mapped_ = 0;
  std::uint8_t* memory_ = nullptr;
};

}  // namespace rift::viz
