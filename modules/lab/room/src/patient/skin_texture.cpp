#include "skin_texture.h"

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/core/data_folder.h"
#include "facenav/core/error.h"
#include "landmarks.h"
#include "thin_plate.h"

namespace facenav::room {
namespace {

constexpr double kPixel_mm = 0.5, kRadius_mm = 80.0, kUp_mm = 130.0, kDown_mm = 170.0;
constexpr float kSkinAlbedo = 0.42f;

std::string portraitPath() { return (dataFolder() / "virtual_patient" / "portrait.png").string(); }

cv::Mat readPortrait() {
  cv::Mat grey = cv::imread(portraitPath(), cv::IMREAD_GRAYSCALE);
  if (grey.empty())
    throw Error("portrait cannot be read", portraitPath(),
                "install the package facenav-lab, or set FACENAV_DATA to the project's Data folder");
  return grey;
}

std::vector<cv::Point> faceOutline(const std::vector<Eigen::Vector2d>& points) {
  const Eigen::Vector2d middle = points[30];
  std::vector<cv::Point> outline;
  const auto add = [&](const Eigen::Vector2d& p) {
    outline.emplace_back(int(std::lround(p.x())), int(std::lround(p.y())));
  };
  for (int i = 1; i <= 15; ++i) add(middle + 0.86 * (points[i] - middle));
  const double lift = 0.13 * (points[8] - points[27]).norm();
  for (int i = 26; i >= 17; --i)
    add(middle + 0.97 * (points[i] - middle) - Eigen::Vector2d(0.0, lift * (i > 19 && i < 24 ? 0.9 : 0.5)));
  return outline;
}

/// Weight 0..1 of the portrait: 1 inside the face, feathered.
cv::Mat faceWeight(const cv::Size& size, const std::vector<Eigen::Vector2d>& points) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8U), weight;
  cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{faceOutline(points)}, 255);
  cv::erode(mask, mask, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
  mask.convertTo(weight, CV_32F, 1.0 / 255.0);
  cv::GaussianBlur(weight, weight, {}, 3.0);
  return weight;
}

/// Albedo from the photograph: linear light, with most of the photographer's lighting divided out.
cv::Mat flattened(const cv::Mat& grey, const cv::Mat& weight) {
  cv::Mat linear, light, norm;
  grey.convertTo(linear, CV_32F, 1.0 / 255.0);
  cv::pow(linear, 2.2, linear);
  cv::GaussianBlur(linear.mul(weight), light, {}, 14.0);
  cv::GaussianBlur(weight, norm, {}, 14.0);
  light = light / (norm + 1e-3f);
  cv::pow(light, 0.75, light);
  cv::Mat albedo = linear / (light + 1e-3f);
  const double mean = cv::sum(albedo.mul(weight))[0] / cv::sum(weight)[0];
  return albedo * (kSkinAlbedo / mean);
}

/// Landmarks that are reliable on both faces: all 68 but the outer jaw (silhouettes).
std::vector<int> anchors() {
  std::vector<int> chosen{4, 5, 6, 7, 8, 9, 10, 11, 12};
  for (int i = 17; i < 68; ++i) chosen.push_back(i);
  return chosen;
}

float bilinear(const cv::Mat& image, double x, double y) {
  const int column = int(x), row = int(y);
  const float fx = float(x - column), fy = float(y - row);
  const float* top = image.ptr<float>(row) + column;
  const float* bottom = image.ptr<float>(row + 1) + column;
  return (1 - fy) * ((1 - fx) * top[0] + fx * top[1]) + fy * ((1 - fx) * bottom[0] + fx * bottom[1]);
}

/// The portrait's albedo with both eyes closed: skin over the opening, lashes along its lower rim.
cv::Mat withClosedEyes(const cv::Mat& albedo, const std::vector<Eigen::Vector2d>& points) {
  cv::Mat closed = albedo.clone();
  for (const int first : {36, 42}) {
    cv::Mat opening = cv::Mat::zeros(albedo.size(), CV_8U), soft;
    std::vector<cv::Point> rim, lashes;
    for (int i = 0; i < 6; ++i)
      rim.emplace_back(int(points[std::size_t(first + i)].x()), int(points[std::size_t(first + i)].y()));
    for (const int i : {0, 5, 4, 3}) lashes.push_back(rim[std::size_t(i)]);
    cv::fillPoly(opening, std::vector<std::vector<cv::Point>>{rim}, 255);
    cv::dilate(opening, opening, cv::getStructuringElement(cv::MORPH_ELLIPSE, {7, 7}));
    opening.convertTo(soft, CV_32F, 1.0 / 255.0);
    cv::GaussianBlur(soft, soft, {}, 1.2);
    closed = closed.mul(1.0 - soft) + soft * (0.85 * kSkinAlbedo);
    cv::polylines(closed, lashes, false, 0.12, 1, cv::LINE_AA);
  }
  return closed;
}

struct Warp {
  cv::Mat x, y;
};

Warp mapToPortrait(const SkinTexture& texture, const cv::Size& size,
                   const std::vector<Eigen::Vector3d>& skin_mm,
                   const std::vector<Eigen::Vector2d>& portrait_px) {
  std::vector<Eigen::Vector2d> from, to;
  for (const int i : anchors()) {
    from.push_back(texture.toMap(skin_mm[i]) / 50.0);
    to.push_back(portrait_px[i]);
  }
  const ThinPlate warp(from, to, 0.02);
  constexpr int kCoarse = 4;  // the spline is smooth: evaluated at every 4th pixel, linear between
  const cv::Size coarse(size.width / kCoarse + 1, size.height / kCoarse + 1);
  Warp maps{cv::Mat(coarse, CV_32F), cv::Mat(coarse, CV_32F)};
  for (int row = 0; row < coarse.height; ++row)
    for (int column = 0; column < coarse.width; ++column) {
      const Eigen::Vector2d place(column * kCoarse * kPixel_mm - M_PI * kRadius_mm,
                                  kUp_mm - row * kCoarse * kPixel_mm);
      const Eigen::Vector2d p = warp.at(place / 50.0);
      const bool is_front = std::abs(place.x()) < 110.0 && place.y() < 90.0;
      maps.x.at<float>(row, column) = is_front ? float(p.x()) : -1000.f;
      maps.y.at<float>(row, column) = is_front ? float(p.y()) : -1000.f;
    }
  cv::Mat fine = (cv::Mat_<double>(2, 3) << 1.0 / kCoarse, 0, 0, 0, 1.0 / kCoarse, 0);
  Warp full;
  cv::warpAffine(maps.x, full.x, fine, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  cv::warpAffine(maps.y, full.y, fine, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  return full;
}

}  // namespace

SkinTexture::SkinTexture(const std::vector<Eigen::Vector3d>& landmarks68_mm,
                         const Eigen::Vector3d& head_centre_mm, bool has_sides_exchanged)
    : centre_mm_(head_centre_mm) {
  const cv::Size size(int(2 * M_PI * kRadius_mm / kPixel_mm) + 1, int((kUp_mm + kDown_mm) / kPixel_mm) + 1);
  albedo_ = cv::Mat(size, CV_32F, cv::Scalar(kSkinAlbedo));
  if (landmarks68_mm.empty()) return;
  cv::Mat portrait = readPortrait();
  if (has_sides_exchanged) cv::flip(portrait, portrait, 1);
  const auto points = findPortraitLandmarks(portrait);
  FACENAV_EXPECT(points, "the committed portrait holds a face");
  const cv::Mat weight = faceWeight(portrait.size(), *points), face = flattened(portrait, weight);
  const Warp warp = mapToPortrait(*this, size, landmarks68_mm, *points);
  cv::Mat share;
  cv::remap(weight, share, warp.x, warp.y, cv::INTER_LINEAR, cv::BORDER_CONSTANT, 0.0);
  const cv::Mat plain = albedo_;
  const auto lay = [&](const cv::Mat& image) {
    cv::Mat laid;
    cv::remap(image, laid, warp.x, warp.y, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
    return cv::Mat(plain.mul(1.0 - share) + cv::max(laid, 0.02f).mul(share));
  };
  albedo_ = lay(face);
  closed_ = lay(withClosedEyes(face, *points));
}

Eigen::Vector2d SkinTexture::toMap(const Eigen::Vector3d& p_mri_mm) const {
  const Eigen::Vector3d p = p_mri_mm - centre_mm_;
  return {kRadius_mm * double(std::atan2(float(-p.x()), float(p.y()))), p.z()};
}

float SkinTexture::at(const Eigen::Vector3d& p_mri_mm, float lids) const {
  const Eigen::Vector2d place = toMap(p_mri_mm);
  const double x = std::clamp((place.x() + M_PI * kRadius_mm) / kPixel_mm, 0.0, albedo_.cols - 1.001);
  const double y = std::clamp((kUp_mm - place.y()) / kPixel_mm, 0.0, albedo_.rows - 1.001);
  const float open = bilinear(albedo_, x, y);
  return lids > 0.f && !closed_.empty() ? open + lids * (bilinear(closed_, x, y) - open) : open;
}

}  // namespace facenav::room
