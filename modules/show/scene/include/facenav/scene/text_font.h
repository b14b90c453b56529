#pragma once
// Fonts of the scenes' words. VTK's own letters are Latin alone; other letters need a font file.

#include <filesystem>

namespace facenav::scene {

/// Font files (TrueType); an empty one: VTK's own letters.
struct TextFonts {
  std::filesystem::path usual = {};  // of words in Latin letters
  std::filesystem::path other = {};  // of words with other letters, such as a name that a person gave
};

/// Takes the fonts of all words that scenes get from now on.
void setTextFonts(const TextFonts& fonts);

}  // namespace facenav::scene
