#pragma once
// What must agree before an imported field belongs to a case: the mesh's scalp with the case's skin, the
// volume's grid or the named T1 with the case's T1, the coil's pose with the target's. Private to plan.

#include <string>
#include <vector>

#include "facenav/plan/imported_field.h"
#include "imported_samples.h"

namespace facenav::steps {

/// What was compared and found, in words. Throws Error if the field is of another head, or of another T1.
std::vector<std::string> checkedAgainst(const casefile::CaseStore& store, const FieldSurfaces& surfaces,
                                        const OtherField& other, const FieldImport& order);

/// The difference of the coil's pose, where SimNIBS wrote it beside the field. Throws Error if the coil stood
/// elsewhere.
std::vector<std::string> poseNotes(const guidance::Target& target, const std::filesystem::path& file);

/// Throws Error unless half of the points lie within 5 mm of the cortex. Returns that distance, mm.
double requireOnCortex(const Eigen::Matrix3Xd& points_mm, const surface::TriangleMesh& cortex,
                       const std::filesystem::path& file);

}  // namespace facenav::steps
