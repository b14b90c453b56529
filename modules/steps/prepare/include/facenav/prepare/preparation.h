#pragma once
// The PREPARE arrow of the data flow: MRI -> head and brain masks -> scalp and brain model -> PreparedCase,
// with the import check (surface/navigation_check.h).
// Head and brain run on two threads. If there is no brain (in a CT, for example), the case has the scalp
// alone and a finding says so; a face can still be aligned to it. Without a head there is no case.

#include <functional>

#include "facenav/atlas/register_atlas.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/segmentation/segmenter.h"

namespace facenav::steps {

/// Returns the atlas, or null if there is none. Called once, on the brain's thread, so that it can load
/// meanwhile.
using AtlasSource = std::function<const atlas::BrainTemplate*()>;

/// Prepares a case. With an atlas, the brain is registered to it; a poor fit is a finding, and its map is
/// dropped. Throws Error when no head is found, Cancelled when `monitor` was cancelled. Both threads call the
/// monitor's listener, one call at a time. `mri` becomes the case's: move it in.
casefile::PreparedCase prepare(volume::Volume mri, const segmentation::Segmenter& head,
                               const segmentation::Segmenter& brain, TaskMonitor& monitor,
                               const AtlasSource& atlas = {});

}  // namespace facenav::steps
