#include "viz/shared_frame.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace rift::viz {
namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

}  // namespace

SharedFrame::SharedFrame() : descriptor_(memfd_create("frame", MFD_CLOEXEC)) {
  if (descriptor_ < 0) fail("no shared memory");
}

SharedFrame::~SharedFrame() {
  if (memory_ != nullptr) munmap(memory_, mapped_);
  if (descriptor_ >= 0) close(descriptor_);
}

void SharedFrame::make_room(int width, int height) {
  const std::size_t needed = bytes_for(width, height);
  if (needed <= size_) return;
  if (ftruncate(descriptor_, static_cast<off_t>(needed)) != 0) fail("no room in shared memory");
  size_ = needed;
}

std::uint8_t* SharedFrame::seen(std::size_t bytes) {
  if (bytes <= mapped_) return memory_;
  if (memory_ != nullptr) munmap(memory_, mapped_);
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0);
  memory_ = memory == MAP_FAILED ? nullptr : static_cast<std::uint8_t*>(memory);
  mapped_ = memory_ == nullptr ? 0 : bytes;
  if (memory_ == nullptr) fail("shared memory cannot be mapped");
  return memory_;
}

Answer& SharedFrame::answer(int width, int height) {
  return *reinterpret_cast<Answer*>(seen(bytes_for(width, height)));
}

std::span<std::uint8_t> SharedFrame::pixels(int width, int height) {
  const std::size_t bytes = bytes_for(width, height);
  return {seen(bytes) + pixels_at, bytes - pixels_at};
}

}  // namespace rift::viz
