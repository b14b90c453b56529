#include "drawn_words.h"

#include <memory>

#include "facenav/pictures/picture_words.h"

namespace facenav::pictures {
namespace {

std::shared_ptr<const WordsPainter>& painterInForce() {
  static std::shared_ptr<const WordsPainter> painter;
  return painter;
}

PictureColour inBytes(const cv::Scalar& rgb) {
  return {std::uint8_t(rgb[0]), std::uint8_t(rgb[1]), std::uint8_t(rgb[2])};
}

/// The words as OpenCV can draw them: "?" for a character that is not ASCII.
std::string inAscii(const std::string& words) {
  std::string ascii;
  for (const char c : words) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) != 0x80) ascii += byte < 0x80 ? c : '?';
  }
  return ascii;
}

void drawEdgedWords(cv::Mat& image, const std::string& words, const cv::Point& base_px,
                    const Letters& letters) {
  if (letters.edge) {
    Letters edge = letters;
    edge.colour = *letters.edge;
    edge.thickness += 2;
    drawFileWords(image, words, base_px, edge);
  }
  drawFileWords(image, words, base_px, letters);
}

}  // namespace

void setWordsPainter(WordsPainter painter) {
  std::atomic_store(&painterInForce(),
                    painter ? std::make_shared<const WordsPainter>(std::move(painter)) : nullptr);
}

void drawShownWords(cv::Mat& image, const std::string& words, const cv::Point& base_px,
                    const Letters& letters) {
  const auto painter = std::atomic_load(&painterInForce());
  if (!painter) return drawEdgedWords(image, words, base_px, letters);
  PictureWords drawn{words, base_px.x, base_px.y, sizeOfWords("X", letters).height, inBytes(letters.colour),
                     {}};
  if (letters.edge) drawn.edge = inBytes(*letters.edge);
  (*painter)({image.data, image.cols, image.rows, image.step[0]}, drawn);
}

void drawFileWords(cv::Mat& image, const std::string& words, const cv::Point& base_px,
                   const Letters& letters) {
  cv::putText(image, inAscii(words), base_px, letters.font, letters.scale, letters.colour, letters.thickness,
              letters.line);
}

cv::Size sizeOfWords(const std::string& words, const Letters& letters) {
  int below = 0;
  return cv::getTextSize(inAscii(words), letters.font, letters.scale, letters.thickness, &below);
}

}  // namespace facenav::pictures
