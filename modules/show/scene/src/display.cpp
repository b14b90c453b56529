#include "facenav/scene/display.h"

#include <dlfcn.h>

#include <cstdlib>

namespace facenav::scene {

bool hasDisplay() {
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name) return false;
  void* library = ::dlopen("libX11.so.6", RTLD_LAZY);  // VTK loads it anyway; needs no header
  if (!library) return false;
  using Open = void* (*)(const char*);
  using Close = int (*)(void*);
  const auto open = reinterpret_cast<Open>(::dlsym(library, "XOpenDisplay"));
  const auto close = reinterpret_cast<Close>(::dlsym(library, "XCloseDisplay"));
  void* display = open && close ? open(name) : nullptr;
  if (display) close(display);
  return display != nullptr;
}

}  // namespace facenav::scene
