#pragma once
// GUIDE: computes distance, tilt and twist, frame by frame, from poses of head and coil (poses.csv) and the
// case's plan.

#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/guidance/guidance_csv.h"

namespace facenav::steps {

/// Predicted error of the alignment at the target as it is planned now, mm; nothing if alignment.json lacks
/// it. Throws Error: no such target.
std::optional<double> predictedError_mm(const casefile::CaseStore& store, const std::string& target);

/// Computes rows of guidance.csv from poses and the case's plan. Throws Error: no such target, or poses that
/// are not placed in the MRI. `scalp`: for the gap; may be null.
std::vector<guidance::GuidanceRow> guidePoses(const casefile::CaseStore& store,
                                              const std::vector<casefile::PoseRow>& poses,
                                              const std::string& target_name,
                                              const registration::ScalpField* scalp = nullptr);

}  // namespace facenav::steps
