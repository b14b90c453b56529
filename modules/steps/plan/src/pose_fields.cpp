#include "facenav/plan/pose_fields.h"

#include <algorithm>
#include <cmath>

#include "facenav/efield/local_sphere.h"
#include "facenav/efield/primary_field.h"
#include "facenav/geometry/rotation.h"
#include "facenav/prepare/case_field.h"
#include "kept_shells.h"

namespace facenav::steps {
namespace {

constexpr double kReach_mm = 80;  // that of the local sphere's fit

Eigen::Matrix3Xd placesOf(const ReadHead& head) {
  if (head.shells()) return head.shells()->at_mm;
  const auto& cortex = head.surfaces().cortex;
  const auto vertices = fieldVertices(cortex);
  Eigen::Matrix3Xd places_mm(3, Eigen::Index(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    places_mm.col(Eigen::Index(i)) = cortex.vertices_mm[vertices[i]];
  return places_mm;
}

void findPeak(const Eigen::Matrix3Xd& places_mm, PoseField& field) {
  if (field.strength.size() == 0) return;
  Eigen::Index strongest = 0;
  field.peak = field.strength.maxCoeff(&strongest);
  field.peak_place = Point<Mri>(places_mm.col(strongest));
}

/// Share of the field that moved poses have least and most, against the pose itself.
struct Shares {
  double least = 1, most = 1;
  void take(double share) {
    least = std::min(least, share);
    most = std::max(most, share);
  }
};

}  // namespace

PoseFields::PoseFields(std::shared_ptr<const ReadHead> head, efield::CoilDipoles coil)
    : head_(std::move(head)), coil_(std::move(coil)), places_mm_(placesOf(*head_)) {}

std::vector<Eigen::Index> PoseFields::nearestPlaces(const std::vector<Eigen::Vector3d>& points_mm) const {
  const KeptPlaces places(places_mm_.cast<float>());
  std::vector<Eigen::Index> nearest;
  nearest.reserve(points_mm.size());
  for (const auto& p_mm : points_mm) nearest.push_back(places.nearest(p_mm.cast<float>()));
  return nearest;
}

PoseField PoseFields::at(const CoilPose& mri_T_coil, const std::optional<Point<Mri>>& target) const {
  return head_->shells() ? inShells(mri_T_coil, target) : inSphere(mri_T_coil, target);
}

PoseField PoseFields::inShells(const CoilPose& mri_T_coil, const std::optional<Point<Mri>>& target) const {
  const KeptShells& kept = *head_->shells();
  const Eigen::Matrix3Xf shells = efield::fieldAt(kept.field, coil_, mri_T_coil);
  PoseField field;
  field.strength = shells.colwise().norm().transpose();
  findPeak(places_mm_, field);
  const auto model = head_->near(mri_T_coil);
  field.usual_error = model->usualError();
  if (!target) return field;
  const auto sphere = efield::localSphere(head_->surfaces().skull_mm, mri_T_coil.translation_mm());
  field.at_target =
      kept.elsewhere(shells, coil_, mri_T_coil, sphere.centre_mm, Eigen::Matrix3Xd(target->mm)).norm();
  return field;
}

PoseField PoseFields::inSphere(const CoilPose& mri_T_coil, const std::optional<Point<Mri>>& target) const {
  std::vector<Eigen::Index> near;
  for (Eigen::Index i = 0; i < places_mm_.cols(); ++i)
    if ((places_mm_.col(i) - mri_T_coil.translation_mm()).norm() <= kReach_mm) near.push_back(i);
  Eigen::Matrix3Xd near_mm(3, Eigen::Index(near.size()));
  for (std::size_t i = 0; i < near.size(); ++i) near_mm.col(Eigen::Index(i)) = places_mm_.col(near[i]);
  const auto model = head_->near(mri_T_coil);
  const Eigen::Matrix3Xd vectors = model->at(coil_, mri_T_coil, near_mm);
  PoseField field;
  field.strength = Eigen::VectorXf::Zero(places_mm_.cols());
  for (std::size_t i = 0; i < near.size(); ++i)
    field.strength[near[i]] = float(vectors.col(Eigen::Index(i)).norm());
  findPeak(places_mm_, field);
  field.usual_error = model->usualError();
  if (target) field.at_target = model->at(coil_, mri_T_coil, Eigen::Matrix3Xd(target->mm)).norm();
  return field;
}

FieldRange PoseFields::rangeAt(const CoilPose& mri_T_coil, const Point<Mri>& target, double strength,
                               double usual_error, const PoseBound& bound) const {
  const auto sphere = efield::localSphere(head_->surfaces().skull_mm, mri_T_coil.translation_mm());
  const auto strengthOf = [&](const CoilPose& pose) {
    return efield::sphereField(coil_, pose, sphere.centre_mm, Eigen::Matrix3Xd(target.mm)).norm();
  };
  const double here = strengthOf(mri_T_coil);
  Shares moved, turned;
  for (int axis = 0; axis < 3 && here > 0; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d along = sign * Eigen::Vector3d::Unit(axis);
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(bound.deg / kDegPerRad, along));
      using Step = RigidTransform<frames::Coil, frames::Coil>;
      const Eigen::Vector3d none = Eigen::Vector3d::Zero();
      moved.take(strengthOf(mri_T_coil * Step(Eigen::Quaterniond::Identity(), bound.mm * along)) / here);
      turned.take(strengthOf(mri_T_coil * Step(turn, none)) / here);
    }
  const auto combined = [&](double by_place, double by_turn) {
    return std::sqrt(usual_error * usual_error + by_place * by_place + by_turn * by_turn);
  };
  return {strength * std::max(0.0, 1 - combined(1 - moved.least, 1 - turned.least)),
          strength * (1 + combined(moved.most - 1, turned.most - 1))};
}

}  // namespace facenav::steps
