#include "facenav/pictures/picture_words.h"

#include <memory>
#include <opencv2/imgproc.hpp>

#include "camera_view.h"

namespace facenav::pictures {
namespace {

std::shared_ptr<const WordsPainter>& painterInForce() {
  static std::shared_ptr<const WordsPainter> painter;
  return painter;
}

std::uint8_t level(double value) { return std::uint8_t(value); }

}  // namespace

void setWordsPainter(WordsPainter painter) {
  std::atomic_store(&painterInForce(),
                    painter ? std::make_shared<const WordsPainter>(std::move(painter)) : nullptr);
}

void drawWords(CameraView& view, const std::string& words, const cv::Point& base_px, double scale,
               const cv::Scalar& colour, int thickness) {
  constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
  const auto painter = std::atomic_load(&painterInForce());
  if (!painter) return cv::putText(view.image, words, base_px, kFont, scale, colour, thickness, cv::LINE_AA);
  int below = 0;
  const int height_px = cv::getTextSize("X", kFont, scale, thickness, &below).height;
  (*painter)(
      {view.image.data, view.image.cols, view.image.rows, view.image.step[0]},
      {words, base_px.x, base_px.y, height_px, {level(colour[0]), level(colour[1]), level(colour[2])}});
}

}  // namespace facenav::pictures
