#include "scene_text.h"

#include <vtkTextProperty.h>

#include <string>

#include "facenav/scene/text_font.h"

namespace facenav::scene {
namespace {

std::string& fileInForce() {
  static std::string file;
  return file;
}

}  // namespace

void setTextFont(const std::filesystem::path& file) { fileInForce() = file.string(); }

void useTextFont(vtkTextProperty& style) {
  if (fileInForce().empty()) return;
  style.SetFontFamily(VTK_FONT_FILE);
  style.SetFontFile(fileInForce().c_str());
}

}  // namespace facenav::scene
