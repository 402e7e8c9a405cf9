#include "viz/draw/offscreen.hpp"

#include <cstring>

// The distribution's VTK is built for X11, and its GLEW asks GLX for OpenGL's entry points. This program
// answers in GLX's place: it exports its symbols (ENABLE_EXPORTS), which are found before those of libGL.
extern "C" {

void* glXGetCurrentDisplay() {
  static int any_display;
  return &any_display;
}

int glXQueryVersion(void*, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return 1;
}

const char* glXGetClientString(void*, int) { return ""; }

rift::viz::EntryPoint glXGetProcAddressARB(const unsigned char* name) {
  const char* text = reinterpret_cast<const char*>(name);
  if (std::strcmp(text, "glXGetCurrentDisplay") == 0)
    return reinterpret_cast<rift::viz::EntryPoint>(&glXGetCurrentDisplay);
  return std::strncmp(text, "glX", 3) == 0 ? nullptr : rift::viz::opengl_entry_point(text);
}

rift::viz::EntryPoint glXGetProcAddress(const unsigned char* name) { return glXGetProcAddressARB(name); }
}
