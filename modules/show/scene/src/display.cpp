#include "facenav/scene/display.h"

#include <dlfcn.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkRenderWindow.h>

#include <cstdlib>
#include <map>
#include <mutex>

namespace facenav::scene {

std::string openGlProblem() {
  static std::mutex mutex;
  static std::map<std::string, std::string> problems;  // by the display's name
  const std::lock_guard lock(mutex);
  const char* name = std::getenv("DISPLAY");
  const auto [problem, is_new] = problems.try_emplace(name ? name : "");
  if (!is_new) return problem->second;
  vtkObject::GlobalWarningDisplayOff();  // VTK would describe the fault in many lines
  vtkNew<vtkRenderWindow> trial;
  trial->SetOffScreenRendering(1);
  if (trial->SupportsOpenGL() == 0)
    problem->second = "this display offers no OpenGL 3.2 (a remote desktop, or an old graphics driver)";
  vtkObject::GlobalWarningDisplayOn();
  return problem->second;
}

bool canDrawScenes() { return hasDisplay() && openGlProblem().empty(); }

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
