#include "facenav/registration/scalp_field.h"

#include <limits>

#include "facenav/anatomy/nose.h"
#include "facenav/core/error.h"
#include "nearest_skin.h"

namespace facenav::registration {
namespace {

constexpr float kNoSkin = std::numeric_limits<float>::quiet_NaN();

const SkinModel& requireSurface(const SkinModel& skin) {
  if (skin.points.empty() || skin.points.normals.size() != skin.points.size() || skin.triangles.empty())
    throw Error("not aligned: the skin model has no surface", {}, "run 'facenav prepare' again");
  return skin;
}

}  // namespace

ScalpField::ScalpField(const SkinModel& skin, Unfilled) : skin_(requireSurface(skin)) {}

ScalpField::ScalpField(const SkinModel& skin) : ScalpField(skin, Unfilled{}) {
  low_ = nearest().low_mm();
  high_ = nearest().high_mm();
  origin_ = (low_ - Eigen::Vector3d::Constant(NearestSkin::kMargin_mm)).cast<float>();
  nose_tip_ = anatomy::findNoseTip(skin_.points.points_mm);
  fillCoarse();
  showGrids();
  fillBricks();
  showGrids();
}

ScalpField::~ScalpField() = default;

const NearestSkin& ScalpField::nearest() const {
  std::call_once(once_, [this] { nearest_ = std::make_unique<NearestSkin>(skin_); });
  return *nearest_;
}

void ScalpField::showGrids() {
  for (int a = 0; a < 3; ++a) {
    grids_.origin_mm[a] = origin_[a];
    grids_.coarse_size[a] = coarse_size_[std::size_t(a)];
    grids_.brick_size[a] = brick_size_[std::size_t(a)];
  }
  grids_.coarse = coarse_.data();
  grids_.brick_at = brick_at_.data();
  grids_.bricks = bricks_.empty() ? nullptr : bricks_.front().data();
}

float ScalpField::nodeDistance_mm(const Eigen::Vector3d& p) const {
  if (nearest_->isBeyondScan(p)) return kNoSkin;
  const SkinContact contact = nearest_->nearest(p);
  return contact.is_on_border ? kNoSkin : float(contact.distance_mm);
}

void ScalpField::fillCoarse() {
  for (int a = 0; a < 3; ++a)
    coarse_size_[a] =
        int(std::ceil((high_[a] - low_[a] + 2 * NearestSkin::kMargin_mm) / FieldGrids::kCoarse_mm)) + 1;
  coarse_.resize(std::size_t(coarse_size_[0]) * coarse_size_[1] * coarse_size_[2]);
  std::size_t node = 0;
  for (int k = 0; k < coarse_size_[2]; ++k)
    for (int j = 0; j < coarse_size_[1]; ++j)
      for (int i = 0; i < coarse_size_[0]; ++i, ++node)
        coarse_[node] =
            nodeDistance_mm(origin_.cast<double>() + FieldGrids::kCoarse_mm * Eigen::Vector3d(i, j, k));
}

void ScalpField::fillBricks() {
  constexpr float kWidth_mm = FieldGrids::kBrick * FieldGrids::kFine_mm;
  for (int a = 0; a < 3; ++a)
    brick_size_[a] = int(std::ceil((high_[a] - low_[a] + 2 * NearestSkin::kMargin_mm) / kWidth_mm));
  brick_at_.assign(std::size_t(brick_size_[0]) * brick_size_[1] * brick_size_[2], -1);
  const float reach_mm = kBand_mm + 0.5f * std::sqrt(3.0f) * kWidth_mm;
  std::size_t cell = 0;
  for (int c = 0; c < brick_size_[2]; ++c)
    for (int b = 0; b < brick_size_[1]; ++b)
      for (int a = 0; a < brick_size_[0]; ++a, ++cell) {
        const Eigen::Vector3f corner = origin_ + kWidth_mm * Eigen::Vector3f(float(a), float(b), float(c));
        const FieldSample middle = coarse(corner + Eigen::Vector3f::Constant(0.5f * kWidth_mm));
        // Near the scan's end the coarse grid gives NaN. The comparison is then false and the brick is built.
        if (std::abs(middle.distance_mm) > reach_mm) continue;
        const int vertex = nearest_->nearestVertex(corner.cast<double>());
        if (std::isnan(middle.distance_mm) &&
            (skin_.points.points_mm[std::size_t(vertex)] - corner.cast<double>()).norm() > 3 * reach_mm)
          continue;
        Brick brick;
        std::size_t node = 0;
        for (int k = 0; k < FieldGrids::kSide; ++k)
          for (int j = 0; j < FieldGrids::kSide; ++j)
            for (int i = 0; i < FieldGrids::kSide; ++i, ++node)
              brick[node] = nodeDistance_mm(corner.cast<double>() +
                                            double(FieldGrids::kFine_mm) * Eigen::Vector3d(i, j, k));
        brick_at_[cell] = std::int32_t(bricks_.size());
        bricks_.push_back(brick);
      }
}

}  // namespace facenav::registration
