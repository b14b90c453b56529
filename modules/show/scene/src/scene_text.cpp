#include "scene_text.h"

#include <vtkTextProperty.h>

#include <algorithm>

#include "facenav/scene/text_font.h"

namespace facenav::scene {
namespace {

TextFonts& fontsInForce() {
  static TextFonts fonts;
  return fonts;
}

/// True for a text with letters beyond Latin ones, which VTK's own font lacks. It has dots and dashes.
bool hasOtherLetters(const std::string& words) {
  constexpr unsigned char kFirstOther = 0xC9, kPunctuation = 0xE2;  // first bytes in UTF-8: U+0240, U+2000
  return std::any_of(words.begin(), words.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= kFirstOther && byte != kPunctuation;
  });
}

}  // namespace

void setTextFonts(const TextFonts& fonts) { fontsInForce() = fonts; }

void useFontFor(const std::string& words, vtkTextProperty& style) {
  const TextFonts& fonts = fontsInForce();
  const auto& file = hasOtherLetters(words) ? fonts.other : fonts.usual;
  if (file.empty()) return style.SetFontFamily(VTK_ARIAL);
  style.SetFontFamily(VTK_FONT_FILE);
  style.SetFontFile(file.c_str());
}

}  // namespace facenav::scene
