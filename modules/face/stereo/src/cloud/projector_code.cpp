#include "facenav/stereo/projector_code.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::stereo {
namespace {

constexpr int kPhases = 4;
constexpr float kLeastContrast_grey = 12, kLeastSine_grey = 4;
constexpr int kSaturated_grey = 253;
constexpr double kDim_grey = 30, kMostSaturated = 0.05, kBlurredSharpness = 0.45;
constexpr float kTwoPi = 6.2831853F;

int bitsFor(int length_px, const ProjectorCode& code) {
  const int halves = (2 * length_px + code.period_px - 1) / code.period_px;
  int bits = 0;
  while ((1 << bits) < halves) ++bits;
  return bits;
}

/// Makes a picture whose value depends on one coordinate.
template <class Value>
cv::Mat striped(const ProjectorCode& code, bool is_across, Value value) {
  cv::Mat picture(code.height_px, code.width_px, CV_8U);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) picture.at<std::uint8_t>(y, x) = value(is_across ? x : y);
  return picture;
}

void addAxis(const ProjectorCode& code, bool is_across, std::vector<cv::Mat>& pictures) {
  const int half = code.period_px / 2;
  for (int bit = bitsFor(is_across ? code.width_px : code.height_px, code) - 1; bit >= 0; --bit)
    pictures.push_back(striped(code, is_across, [&](int at) -> std::uint8_t {
      const int index = at / half, gray = index ^ (index >> 1);
      return (gray >> bit) & 1 ? 255 : 0;
    }));
  for (int phase = 0; phase < kPhases; ++phase)
    pictures.push_back(striped(code, is_across, [&](int at) -> std::uint8_t {
      const double angle = kTwoPi * (at + 0.5) / code.period_px - 0.5 * M_PI * phase;
      return std::uint8_t(std::lround(127.5 + 127.5 * std::cos(angle)));
    }));
}

struct PlaceInPeriod {
  float at_px, sine_grey;  // place in the period; amplitude of the cosine
};

PlaceInPeriod phaseAt(const cv::Mat* phases, int y, int x, int period_px) {
  const auto grey = [&](int i) { return float(phases[i].at<std::uint8_t>(y, x)); };
  const float a = grey(0) - grey(2), b = grey(1) - grey(3);
  float turn = std::atan2(b, a) / kTwoPi;
  if (turn < 0) turn += 1;
  return {turn * float(period_px) - 0.5F, 0.5F * std::hypot(a, b)};
}

/// Decodes one coordinate; NaN if the bits contradict the phase.
float coordinateAt(const cv::Mat* pictures, int bits, const ProjectorCode& code, float middle_grey, int y,
                   int x, float& sine_grey) {
  int index = 0, last = 0;
  for (int bit = 0; bit < bits; ++bit) {
    const int gray = pictures[bit].at<std::uint8_t>(y, x) > middle_grey ? 1 : 0;
    last = bit == 0 ? gray : last ^ gray;
    index = 2 * index + last;
  }
  const auto in_period = phaseAt(pictures + bits, y, x, code.period_px);
  sine_grey = in_period.sine_grey;
  const float half = 0.5F * float(code.period_px), coarse = (float(index) + 0.5F) * half - 0.5F;
  const float at = in_period.at_px +
                   float(code.period_px) * std::round((coarse - in_period.at_px) / float(code.period_px));
  return std::abs(at - coarse) > 0.85F * half ? std::numeric_limits<float>::quiet_NaN() : at;
}

void requirePictures(const std::vector<cv::Mat>& pictures, std::size_t wanted) {
  if (pictures.size() != wanted)
    throw Error(
        formatted("%zu pictures of the projector's code are needed, %zu are there", wanted, pictures.size()),
        "", "take one picture of each, in their order");
  for (const auto& picture : pictures)
    if (picture.type() != CV_8U || picture.size() != pictures.front().size())
      throw Error("the pictures of the projector's code have different sizes", "",
                  "take them with one camera");
}

}  // namespace

std::vector<cv::Mat> codePictures(const ProjectorCode& code) {
  FACENAV_EXPECT(code.period_px >= 4 && code.period_px % 2 == 0, "an even period of 4 px or more");
  std::vector<cv::Mat> pictures;
  pictures.emplace_back(code.height_px, code.width_px, CV_8U, cv::Scalar(255));
  pictures.emplace_back(code.height_px, code.width_px, CV_8U, cv::Scalar(0));
  addAxis(code, true, pictures);
  addAxis(code, false, pictures);
  return pictures;
}

DecodedCode decode(const std::vector<cv::Mat>& pictures, const ProjectorCode& code) {
  const int x_bits = bitsFor(code.width_px, code), y_bits = bitsFor(code.height_px, code);
  requirePictures(pictures, std::size_t(2 + x_bits + y_bits + 2 * kPhases));
  const cv::Mat* across = pictures.data() + 2;
  const cv::Mat* down = across + x_bits + kPhases;
  const float nothing = std::numeric_limits<float>::quiet_NaN();
  DecodedCode decoded;
  decoded.place = cv::Mat(pictures[0].size(), CV_32FC2, cv::Scalar(nothing, nothing));
  std::vector<double> contrasts, sharpnesses;
  std::size_t saturated = 0;
  for (int y = 0; y < decoded.place.rows; ++y)
    for (int x = 0; x < decoded.place.cols; ++x) {
      const float white = pictures[0].at<std::uint8_t>(y, x), black = pictures[1].at<std::uint8_t>(y, x);
      if (white - black < kLeastContrast_grey) continue;
      contrasts.push_back(white - black);
      saturated += white >= kSaturated_grey;
      if (white >= kSaturated_grey) continue;  // the cosine is cut off there
      const float middle = 0.5F * (white + black);
      float x_sine = 0, y_sine = 0;
      const float px = coordinateAt(across, x_bits, code, middle, y, x, x_sine),
                  py = coordinateAt(down, y_bits, code, middle, y, x, y_sine);
      sharpnesses.push_back(2 * std::min(x_sine, y_sine) / (white - black));
      if (std::min(x_sine, y_sine) < kLeastSine_grey || !(px > -0.5F && px < float(code.width_px) - 0.5F) ||
          !(py > -0.5F && py < float(code.height_px) - 0.5F))
        continue;
      decoded.place.at<cv::Vec2f>(y, x) = {px, py};
    }
  if (contrasts.empty()) return decoded;
  decoded.lit_share = double(contrasts.size()) / double(decoded.place.total());
  decoded.saturated_share = double(saturated) / double(contrasts.size());
  decoded.contrast_grey = median(std::move(contrasts));
  decoded.sharpness = median(std::move(sharpnesses));
  return decoded;
}

std::vector<std::string> DecodedCode::advice() const {
  if (lit_share < 0.01) return {"the projector's light is not seen: switch it on, and point it at the scene"};
  std::vector<std::string> words;
  if (contrast_grey < kDim_grey)
    words.push_back("the projector is too dim: dim the room, or bring it nearer");
  if (saturated_share > kMostSaturated)
    words.push_back("the projector is too bright for the cameras: shorten their exposure, or dim it");
  if (sharpness < kBlurredSharpness) words.push_back("the projector is out of focus: turn its ring");
  return words;
}

}  // namespace facenav::stereo
