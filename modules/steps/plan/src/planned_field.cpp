#include "facenav/plan/planned_field.h"

#include <cmath>

#include "facenav/core/error.h"

namespace facenav::steps {
namespace {

/// |E| at the drawn surface, at 1 A/us. Takes the field of the cortex where that is the surface.
Eigen::VectorXd drawnStrength(const ReadHead& head, const HeadField& field, const FieldOnCortex& on_cortex,
                              const efield::CoilDipoles& coil, const WantedField& wanted) {
  const auto& places_mm = wanted.drawn->vertices_mm;
  if (places_mm == head.surfaces().cortex.vertices_mm) return on_cortex.field.colwise().norm().transpose();
  if (places_mm.empty()) return {};
  const Eigen::Map<const Eigen::Matrix3Xd> at_mm(places_mm[0].data(), 3, Eigen::Index(places_mm.size()));
  return field.at(coil, coilPoseOf(wanted.target), at_mm).colwise().norm().transpose();
}

std::unique_ptr<HeadField> modelOf(const ReadHead& head, const WantedField& wanted) {
  return wanted.imported ? head.imported(wanted.target) : head.near(coilPoseOf(wanted.target));
}

}  // namespace

double inA_per_us(const CurrentRate& rate, const efield::CoilDipoles& coil) {
  if (rate.unit == CurrentRate::Unit::A_per_us) return rate.value;
  if (coil.largest_didt_A_per_us <= 0)
    throw Error("the coil's file does not say how fast its current rises at 100 % output", {},
                "give the rate in A/us");
  return coil.largest_didt_A_per_us * rate.value / 100;
}

PlannedField plannedField(const ReadHead& head, const WantedField& wanted, TaskMonitor& monitor) {
  const auto coil = efield::fieldCoil(wanted.coil).dipoles;
  PlannedField result;
  result.rate_A_per_us = inA_per_us(wanted.rate, coil);
  const auto field = modelOf(head, wanted);
  result.tier = field->tier();
  result.usual_error = field->usualError();
  monitor.report("electric field", 0.2);
  const auto on_cortex = fieldOnCortex(*field, head.surfaces(), coil, wanted.target);
  result.at_target = result.rate_A_per_us * on_cortex.at_target.norm();
  result.along_normal = result.rate_A_per_us * std::abs(on_cortex.along_normal);
  result.peak = result.rate_A_per_us * on_cortex.peak;
  result.peak_distance_mm = on_cortex.peak_distance_mm;
  result.peak_place = on_cortex.peak_place;
  if (wanted.threshold && !wanted.imported)  // the hotspot's field would be another model's
    result.dose = thresholdDose(head, coil, *wanted.threshold, on_cortex.at_target.norm());
  monitor.report("electric field", 0.6);
  if (!wanted.drawn) return result;
  const Eigen::VectorXd strength =
      result.rate_A_per_us * drawnStrength(head, *field, on_cortex, coil, wanted);
  result.strength.resize(std::size_t(strength.size()));
  Eigen::VectorXf::Map(result.strength.data(), strength.size()) = strength.cast<float>();
  return result;
}

PlannedReach plannedReach(const ReadHead& head, const WantedField& wanted, const LabelOf& label,
                          TaskMonitor& monitor) {
  const auto coil = efield::fieldCoil(wanted.coil).dipoles;
  const double rate = inA_per_us(wanted.rate, coil);
  PlannedReach result;
  const auto field = modelOf(head, wanted);
  if (head.surfaces().brain_mask && field->fillsBrain()) {
    const auto on_cortex = fieldOnCortex(*field, head.surfaces(), coil, wanted.target);
    auto in_brain = fieldInBrain(*field, head.surfaces(), coil, wanted.target, on_cortex, monitor, label);
    result.regions = std::move(in_brain.regions);
    auto strength = std::make_shared<volume::Volume>(*in_brain.strength);
    for (float& value : strength->voxels) value *= float(rate);
    result.in_brain = std::move(strength);
  }
  monitor.report("comparison of poses", 0.8);
  if (wanted.against && !wanted.imported) result.against = comparePlanned(head, wanted, *wanted.against);
  return result;
}

PoseComparison comparePlanned(const ReadHead& head, const WantedField& wanted,
                              const guidance::Target& other) {
  const auto coil = efield::fieldCoil(wanted.coil).dipoles;
  const double rate = inA_per_us(wanted.rate, coil);
  auto compared = comparePoses(*head.near(coilPoseOf(wanted.target)), *head.near(coilPoseOf(other)),
                               head.surfaces(), coil, wanted.target, other);
  compared.at_target *= rate;
  compared.other_at_target *= rate;
  compared.other_at_its_own *= rate;
  return compared;
}

BestPose bestPlannedPose(const ReadHead& head, const PlannedHead& planned, const WantedField& wanted,
                         FieldAim aim, TaskMonitor& monitor) {
  const auto coil = efield::fieldCoil(wanted.coil).dipoles;
  const double rate = inA_per_us(wanted.rate, coil);
  monitor.report("best pose", 0.1);
  const auto field = head.near(coilPoseOf(wanted.target));
  auto best = bestPose(*field, head.surfaces(), planned, coil, wanted.target, aim);
  best.planned *= rate;
  best.best *= rate;
  return best;
}

}  // namespace facenav::steps
