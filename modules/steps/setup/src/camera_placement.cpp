#include "facenav/setup/camera_placement.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "facenav/core/settings_in_force.h"

namespace facenav::steps {
namespace {

constexpr int kBlurLength = 9;
constexpr int kWhite = 250;

using Subject = PlacementFinding::Subject;

/// Blur in one direction; `grey` as 32-bit.
double blurAlong(const cv::Mat& grey, bool is_across) {
  const cv::Size box = is_across ? cv::Size(kBlurLength, 1) : cv::Size(1, kBlurLength);
  cv::Mat blurred;
  cv::blur(grey, blurred, box);
  const auto steps = [is_across](const cv::Mat& image) -> cv::Mat {
    const cv::Mat a = is_across ? image.colRange(1, image.cols) : image.rowRange(1, image.rows),
                  b = is_across ? image.colRange(0, image.cols - 1) : image.rowRange(0, image.rows - 1);
    return cv::abs(a - b);
  };
  const cv::Mat sharp = steps(grey), soft = steps(blurred);
  const double all = cv::sum(sharp)[0], lost = cv::sum(cv::max(sharp - soft, 0.0))[0];
  return all > 0 ? (all - lost) / all : 1.0;
}

struct FaceLight {
  double mean = 0, white_share = 0;
};

FaceLight lightOf(const cv::Mat& image, const cv::Rect& face) {
  const cv::Mat skin = image(face & cv::Rect(0, 0, image.cols, image.rows));
  return {cv::mean(skin)[0],
          double(cv::countNonZero(skin > kWhite)) / double(std::max<std::size_t>(1, skin.total()))};
}

/// Direction in which to turn a camera so that the face is in the middle of its picture; empty: none.
std::string wayToTurn(const cv::Rect& face, const cv::Size& size, double edge_share) {
  const double edge_x = edge_share * size.width, edge_y = edge_share * size.height;
  if (face.x < edge_x) return "to its left";  // seen in the camera's viewing direction
  if (face.br().x > size.width - edge_x) return "to its right";
  if (face.y < edge_y) return "upwards";
  if (face.br().y > size.height - edge_y) return "downwards";
  return {};
}

PlacementFinding distanceFinding(const cv::Rect& left, const cv::Rect& right, const cv::Size& size) {
  const auto& rules = settingsOf<PlacementRules>();
  const double width_px = std::min(left.width, right.width),
               share = double(std::max(left.width, right.width)) / size.width;
  if (width_px < rules.least_face_px || share < rules.least_face_share)
    return {Subject::distance, false, "bring the cameras nearer to the face"};
  if (share > rules.most_face_share) return {Subject::distance, false, "move the cameras away from the face"};
  return {Subject::distance, true, "the distance is good"};
}

PlacementFinding overlapFinding(const cv::Rect& left, const cv::Rect& right, const cv::Size& size) {
  const auto& rules = settingsOf<PlacementRules>();
  for (const auto& [side, face] : {std::pair("left", left), std::pair("right", right)})
    if (const auto way = wayToTurn(face, size, rules.edge_share); !way.empty())
      return {Subject::overlap, false, std::string("turn the ") + side + " camera " + way};
  const double ratio = double(left.width) / right.width,
               height = std::abs(left.y + left.height / 2 - right.y - right.height / 2) / double(size.height);
  if (std::max(ratio, 1 / ratio) > rules.most_size_ratio)
    return {Subject::overlap, false, "one camera is much nearer, or has another lens: use two equal cameras"};
  if (height > rules.most_height_share)
    return {Subject::overlap, false, "bring both cameras to one height and tilt"};
  return {Subject::overlap, true, "both cameras see the whole face"};
}

PlacementFinding lightFinding(const FaceLight& left, const FaceLight& right) {
  const auto& rules = settingsOf<PlacementRules>();
  for (const auto& [side, light] : {std::pair("left", left), std::pair("right", right)}) {
    if (light.mean < rules.least_grey)
      return {Subject::light, false, std::string("more light: the ") + side + " picture is too dark"};
    if (light.mean > rules.most_grey || light.white_share > rules.most_white_share)
      return {Subject::light, false, std::string("less light: the ") + side + " picture is too bright"};
  }
  const double ratio = left.mean / std::max(1.0, right.mean);
  if (std::max(ratio, 1 / ratio) > rules.most_grey_ratio)
    return {Subject::light, false, "one picture is much darker: move the lamp to the middle"};
  return {Subject::light, true, "the light is good"};
}

PlacementFinding focusFinding(const cv::Mat& left, const cv::Mat& right) {
  const double most = settingsOf<PlacementRules>().most_blur;
  const double left_blur = blurEffect(left), right_blur = blurEffect(right);
  if (left_blur > most || right_blur > most)
    return {Subject::focus, false,
            std::string("set the focus of the ") + (left_blur > right_blur ? "left" : "right") + " camera"};
  return {Subject::focus, true, "the focus is good"};
}

PlacementFinding faceMissing(bool is_left, bool is_right) {
  if (!is_left && !is_right)
    return {Subject::overlap, false, "let a person sit where the patient will sit, and look at the cameras"};
  return {Subject::overlap, false,
          is_left ? "turn the right camera to the face: it does not see it"
                  : "turn the left camera to the face: it does not see it"};
}

std::optional<face::FaceLandmarks> followFace(const face::FaceDetector& detector, const cv::Mat& grey,
                                              const std::optional<face::FaceLandmarks>& last) {
  if (last)
    if (auto near = detector.detectNear(grey, *last)) return near;
  return detector.detectAtRoll(grey, 0.0);
}

}  // namespace

double blurEffect(const cv::Mat& grey) {
  cv::Mat floating;
  // Removes the camera's noise, which is no detail.
  cv::GaussianBlur(grey, floating, {}, 0.7);
  floating.convertTo(floating, CV_32F);
  return std::max(blurAlong(floating, true), blurAlong(floating, false));
}

bool Placement::isGood() const {
  return findings.size() == 4 &&
         std::all_of(findings.begin(), findings.end(), [](const auto& finding) { return finding.is_good; });
}

std::string Placement::words() const {
  for (const auto& finding : findings)
    if (!finding.is_good) return finding.words;
  return findings.empty() ? "no picture yet" : "the cameras are placed well";
}

PlacementJudge::PlacementJudge(std::shared_ptr<const face::FaceDetector> detector)
    : detector_(std::move(detector)) {}

Placement PlacementJudge::judge(const cameras::StereoFrame& frame) {
  left_ = followFace(*detector_, frame.left, left_);
  right_ = followFace(*detector_, frame.right, right_);
  Placement placement;
  if (left_) placement.left_face = left_->face;
  if (right_) placement.right_face = right_->face;
  if (!left_ || !right_) {
    placement.findings = {faceMissing(left_.has_value(), right_.has_value())};
    return placement;
  }
  const cv::Size size = frame.left.size();
  const cv::Rect all({0, 0}, size), left = left_->face & all, right = right_->face & all;
  placement.findings = {overlapFinding(left_->face, right_->face, size), distanceFinding(left, right, size),
                        lightFinding(lightOf(frame.left, left), lightOf(frame.right, right)),
                        focusFinding(frame.left(left), frame.right(right))};
  return placement;
}

}  // namespace facenav::steps
