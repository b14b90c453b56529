#pragma once
// The region that the field of a planned pose reaches: area of the cortex and volume of the brain above 50,
// 75 and 90 % of the maximum, the volume by the atlas' labels, and the strength in the brain for slices.
// Fields in V/m at a rate of the current of 1 A/us, places in Mri.

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "facenav/core/task_monitor.h"
#include "facenav/plan/cortex_field.h"

namespace facenav::steps {

/// Part of the brain where the field is at least a share of its maximum on the cortex.
struct FieldRegion {
  double share = 0;      ///< 0.5, 0.75, 0.9
  double area_mm2 = 0;   ///< of the cortex' surface, sulci included where the case has them
  double volume_ml = 0;  ///< of the brain mask: grey and white matter together
  std::map<std::string, double> by_label = {};  ///< ml; empty without an atlas
};
using FieldRegions = std::array<FieldRegion, 3>;

/// Name of the brain's part at a place; empty: none.
using LabelOf = std::function<std::string(const Point<Mri>&)>;
/// AAL labels through the case's atlas. Returns an empty function if the case has no atlas or the labels are
/// not installed.
LabelOf aalLabels(const casefile::CaseStore& store);

/// Area of the surface where `values` (one a vertex, linear on a triangle) are at least `least`, mm2.
double areaAbove_mm2(const surface::TriangleMesh& mesh, const Eigen::VectorXd& values, double least);

struct FieldInBrain {
  FieldRegions regions;
  /// |E| within 80 mm of the coil, in the brain mask and one voxel beyond it; 0 elsewhere. Its voxels are
  /// about 2 mm large.
  std::shared_ptr<const volume::Volume> strength;
};
/// Measures the field of fieldOnCortex in the brain, on a grid of about 2 mm. Throws Error if the case has no
/// brain mask; Cancelled within some 10 ms.
FieldInBrain fieldInBrain(const HeadField& head, const FieldSurfaces& surfaces,
                          const efield::CoilDipoles& coil, const guidance::Target& target,
                          const FieldOnCortex& on_cortex, TaskMonitor& monitor, const LabelOf& label = {});

/// How the field of another pose differs from that of a target's pose, on the same cortex, with the same coil
/// and rate.
struct PoseComparison {
  double at_target = 0;         ///< |E| at the target, from its own pose
  double other_at_target = 0;   ///< |E| there from the other pose
  double other_at_its_own = 0;  ///< |E| of the other pose at its own target
  double peak_ratio = 1;        ///< maximum of the other pose over that of the target's
  double peak_shift_mm = 0;     ///< distance between both maxima
  double correlation = 1;       ///< of the strengths at the cortex' vertices (Pearson)
  /// Change at the target if the other pose were taken, as a share: -0.2 is 20 % less.
  double change() const { return other_at_target / at_target - 1; }
};
/// Compares. Each head is the model near its own pose.
PoseComparison comparePoses(const HeadField& head, const HeadField& other_head, const FieldSurfaces& surfaces,
                            const efield::CoilDipoles& coil, const guidance::Target& target,
                            const guidance::Target& other);

}  // namespace facenav::steps
