#pragma once
// The scenario plain_align of `facenav evaluate`: one seated patient, aligned from dense dots, the paper's
// sparse dots, the plain pair and a film in which the head turns; and plain pairs that must be refused:
// another person's scan, a mirrored scan, moved cameras. If the right camera was rotated about its vertical
// axis, each alignment must be refused, corrected or inside its bound. One RunRecord each.

#include <functional>
#include <vector>

#include "context.h"
#include "evaluate/evaluation_head.h"
#include "evaluate/evaluation_run.h"
#include "facenav/evaluation/run_record.h"
#include "facenav/room/scenario.h"

namespace facenav::app {

/// Which alignments to try: all, or only those that must succeed.
enum class AlignTries { all, right };

/// Runs the alignments. `names`: scenario, head, rig and seed, copied into each record. `other`: a scan of
/// another person, if there is one. Refusals are recorded; only Cancelled is thrown.
std::vector<evaluation::RunRecord> runPlainAlign(Context& context, const room::ScenarioOptions& options,
                                                 const EvaluationHead& head,
                                                 const surface::ScalpSurface* other, const Methods& methods,
                                                 const evaluation::RunRecord& names,
                                                 AlignTries tries = AlignTries::all);

}  // namespace facenav::app
