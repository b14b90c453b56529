#include "drawn_words.h"

#include <memory>

#include "facenav/pictures/picture_words.h"

namespace facenav::pictures {
namespace {

std::shared_ptr<const WordsPainter>& painterInForce() {
  static std::shared_ptr<const WordsPainter> painter;
  return painter;
}

std::uint8_t level(double value) { return std::uint8_t(value); }

/// The words as OpenCV can draw them: "?" for a character that is not ASCII.
std::string inAscii(const std::string& words) {
  std::string ascii;
  for (const char c : words) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) != 0x80) ascii += byte < 0x80 ? c : '?';
  }
  return ascii;
}

}  // namespace

void setWordsPainter(WordsPainter painter) {
  std::atomic_store(&painterInForce(),
                    painter ? std::make_shared<const WordsPainter>(std::move(painter)) : nullptr);
}

void drawShownWords(cv::Mat& image, const std::string& words, const cv::Point& base_px,
                    const Letters& letters) {
  const auto painter = std::atomic_load(&painterInForce());
  if (!painter) return drawFileWords(image, words, base_px, letters);
  const int height_px = sizeOfWords("X", letters).height;
  const cv::Scalar& colour = letters.colour;
  (*painter)(
      {image.data, image.cols, image.rows, image.step[0]},
      {words, base_px.x, base_px.y, height_px, {level(colour[0]), level(colour[1]), level(colour[2])}});
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
