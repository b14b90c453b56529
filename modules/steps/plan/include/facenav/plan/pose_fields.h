#pragma once
// PoseFields: the field of one coil for many poses in one head, some ms a pose: on about 20,000 places of the
// cortex, and at a target. The model is that of ReadHead. The live picture, the pulses and the map of the
// MEPs use it. Fields in V/m at a rate of the current of 1 A/us; places in Mri.

#include <optional>
#include <vector>

#include "facenav/plan/head_field.h"

namespace facenav::steps {

/// |E| of one pose.
struct PoseField {
  Eigen::VectorXf strength;  ///< at PoseFields::places_mm(); tier 0: 0 farther than 80 mm from the coil
  double peak = 0;
  Point<Mri> peak_place;
  std::optional<double> at_target;  ///< nothing: no target was given
  double usual_error = 0;           ///< of the model, relative
};

/// How far the coil may be from its pose: 95 of 100 errors lie below.
struct PoseBound {
  double mm = 0, deg = 0;
};
struct FieldRange {
  double low = 0, high = 0;
};

class PoseFields {
 public:
  PoseFields(std::shared_ptr<const ReadHead> head, efield::CoilDipoles coil);

  FieldTier tier() const { return head_->tier(); }
  const ReadHead& head() const { return *head_; }
  const efield::CoilDipoles& coil() const { return coil_; }
  const Eigen::Matrix3Xd& places_mm() const { return places_mm_; }
  /// Number of the place nearest to each point, to colour another surface.
  std::vector<Eigen::Index> nearestPlaces(const std::vector<Eigen::Vector3d>& points_mm) const;

  /// Field of a pose; at the target as ReadHead::near() gives it there.
  PoseField at(const CoilPose& mri_T_coil, const std::optional<Point<Mri>>& target = {}) const;

  /// Range of |E| at a target: the model's usual error, and what |E| becomes where the coil is moved by the
  /// bound along each of its axes and turned by it about each, the worst of both kinds; combined as
  /// independent errors. The moved poses are computed in the local sphere, as shares of its own field.
  FieldRange rangeAt(const CoilPose& mri_T_coil, const Point<Mri>& target, double strength,
                     double usual_error, const PoseBound& bound) const;

 private:
  PoseField inSphere(const CoilPose& mri_T_coil, const std::optional<Point<Mri>>& target) const;
  PoseField inShells(const CoilPose& mri_T_coil, const std::optional<Point<Mri>>& target) const;

  std::shared_ptr<const ReadHead> head_;
  efield::CoilDipoles coil_;
  Eigen::Matrix3Xd places_mm_;
};

}  // namespace facenav::steps
