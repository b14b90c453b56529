#pragma once
// Words in the pictures that a window shows. OpenCV's letters are Latin alone, so a window in another
// language paints them itself: it gives a painter, which also translates. Pictures that only files hold stay
// English.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace facenav::pictures {

using PictureColour = std::array<std::uint8_t, 3>;  // R, G, B

/// Holds one line of English words.
struct PictureWords {
  std::string text;
  int left_px, base_px;  // where its base line begins
  int height_px;         // of a capital letter
  PictureColour colour;
  std::optional<PictureColour> edge;  // round the letters
};

/// An 8-bit RGB picture that is being drawn.
struct PicturePixels {
  unsigned char* rgb;
  int width_px, height_px;
  std::size_t row_bytes;
};

/// Paints words on a picture. Any thread may call it.
using WordsPainter = std::function<void(const PicturePixels&, const PictureWords&)>;

/// Takes the painter of all pictures that are drawn from now on; null: OpenCV's letters.
void setWordsPainter(WordsPainter painter);

}  // namespace facenav::pictures
