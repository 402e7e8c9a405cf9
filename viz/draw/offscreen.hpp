#pragma once

#include <memory>
#include <stdexcept>

namespace rift::viz {

/// There is no OpenGL of this kind on this machine.
struct NoOpenGl : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A context of OpenGL 3.3 without a display, current in the thread that made it for its whole life. Each of
/// the two programs is linked with one of two: OSMesa, or EGL without a surface.
class OffscreenContext {
 public:
  /// Throws NoOpenGl.
  OffscreenContext(int width, int height);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// OpenGL's function of a name, or null.
using EntryPoint = void (*)();
EntryPoint opengl_entry_point(const char* name);

}  // namespace rift::viz
