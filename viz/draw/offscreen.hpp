#pragma once

#include <memory>
#include <stdexcept>

namespace rift::viz {

/// There is no OpenGL of this kind on this machine.
struct NoOpenGl : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A context of OpenGL 3.3 without a display, for frames of one size; it is current when it has been made.
/// Each of the two programs is linked with one of two: OSMesa, or EGL without a surface.
class OffscreenContext {
 public:
  /// Throws NoOpenGl.
  OffscreenContext(int width, int height);
  ~OffscreenContext();
  /// In place of another one, before anything is drawn in it or what was drawn in it goes. Throws NoOpenGl.
  void make_current();
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
