#pragma once
// The main job: from the virtual patient's DICOM series to the coil on target, with pictures, figures and
// report. Every stage is the code a real patient gets; this file only chooses inputs.

#include "context.h"
#include "demo/demo_report.h"

namespace facenav::app {

struct DemoRequest {
  std::filesystem::path folder;  // result; made whole, replacing an earlier demo
  std::uint64_t seed = 1;
  int frames = 0;  // of the treatment; 0: the scenario's own length
};

/// Throws Error; then `folder` is as it was before.
DemoFigures runDemo(Context& context, const DemoRequest& request);

}  // namespace facenav::app
