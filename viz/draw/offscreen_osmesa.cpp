#include "viz/draw/offscreen.hpp"

#include <GL/osmesa.h>

#include <cstdint>
#include <vector>

namespace rift::viz {

/// OSMesa draws into memory of ours.
struct OffscreenContext::Context {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  OSMesaContext mesa = nullptr;

  ~Context() {
    if (mesa != nullptr) OSMesaDestroyContext(mesa);
  }
};

OffscreenContext::OffscreenContext(int width, int height) : context_(std::make_unique<Context>()) {
  const int wanted[] = {OSMESA_FORMAT,
                        OSMESA_RGBA,
                        OSMESA_DEPTH_BITS,
                        24,
                        OSMESA_STENCIL_BITS,
                        8,
                        OSMESA_PROFILE,
                        OSMESA_CORE_PROFILE,
                        OSMESA_CONTEXT_MAJOR_VERSION,
                        3,
                        OSMESA_CONTEXT_MINOR_VERSION,
                        3,
                        0};
  context_->width = width, context_->height = height;
  context_->pixels.resize(std::size_t{4} * width * height);
  context_->mesa = OSMesaCreateContextAttribs(wanted, nullptr);
  if (context_->mesa == nullptr) throw NoOpenGl("OSMesa gives no context of OpenGL 3.3");
  make_current();
}

void OffscreenContext::make_current() {
  if (OSMesaMakeCurrent(context_->mesa, context_->pixels.data(), GL_UNSIGNED_BYTE, context_->width,
                        context_->height) == 0)
    throw NoOpenGl("OSMesa supports no frame of this size");
}

OffscreenContext::~OffscreenContext() = default;

EntryPoint opengl_entry_point(const char* name) {
  return reinterpret_cast<EntryPoint>(OSMesaGetProcAddress(name));
}

}  // namespace rift::viz
