#pragma once
// The PREPARE arrow of the data flow: MRI -> head and brain masks -> scalp and brain model -> PreparedCase,
// with the import check (surface/navigation_check.h).
// Head and brain run on two threads. Without a brain (a CT, say) the case goes on with the scalp alone, and a
// finding says so, since a face can still be aligned to it; without a head there is no case.

#include <functional>

#include "facenav/atlas/register_atlas.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/segmentation/segmenter.h"

namespace facenav::workflow {

/// Gives the atlas (null: there is none), called once on the brain's thread: it may be read in the meantime.
using AtlasSource = std::function<const atlas::BrainTemplate*()>;

/// With an atlas, the brain is registered to it; a poor fit is a finding, and no map is kept. Throws Error
/// when no head is found, Cancelled when `monitor` was cancelled. The monitor's listener is called from both
/// threads, one call at a time.
casefile::PreparedCase prepare(const volume::Volume& mri, const segmentation::Segmenter& head,
                               const segmentation::Segmenter& brain, TaskMonitor& monitor,
                               const AtlasSource& atlas = {});

}  // namespace facenav::workflow
