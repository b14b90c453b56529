#pragma once
// The font of the scenes' words. VTK's own letters are Latin alone; another language needs a font file.

#include <filesystem>

namespace facenav::scene {

/// Takes the font file (TrueType) of all scenes that are made from now on; empty: VTK's own letters.
void setTextFont(const std::filesystem::path& file);

}  // namespace facenav::scene
