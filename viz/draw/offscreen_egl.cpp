#include "viz/draw/offscreen.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

namespace rift::viz {

struct OffscreenContext::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext egl = EGL_NO_CONTEXT;

  ~Context() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (egl != EGL_NO_CONTEXT)
      eglDestroyContext(display, egl);  // the display is that of all contexts, and stays
  }
};

OffscreenContext::OffscreenContext(int, int) : context_(std::make_unique<Context>()) {
  const auto platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (platform_display == nullptr) throw NoOpenGl("EGL supports no platforms");
  context_->display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (context_->display == EGL_NO_DISPLAY || eglInitialize(context_->display, nullptr, nullptr) == EGL_FALSE)
    throw NoOpenGl("EGL gives no display without a surface");
  eglBindAPI(EGL_OPENGL_API);
  const std::array<EGLint, 3> any{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  const bool has_config =
      eglChooseConfig(context_->display, any.data(), &config, 1, &count) == EGL_TRUE && count > 0;
  const std::array<EGLint, 7> wanted{EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
  context_->egl = eglCreateContext(context_->display, has_config ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                                   wanted.data());
  if (context_->egl == EGL_NO_CONTEXT) throw NoOpenGl("EGL gives no context of OpenGL 3.3");
  make_current();
}

void OffscreenContext::make_current() {
  if (eglMakeCurrent(context_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_->egl) == EGL_FALSE)
    throw NoOpenGl("EGL does not take its context of OpenGL 3.3");
}

OffscreenContext::~OffscreenContext() = default;

EntryPoint opengl_entry_point(const char* name) {
  return reinterpret_cast<EntryPoint>(eglGetProcAddress(name));
}

}  // namespace rift::viz
