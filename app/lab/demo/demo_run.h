#pragma once
// The demo: from the virtual patient's DICOM series to the coil on target, with pictures, figures and report.
// Every stage runs the same code as for a real patient; this file only chooses inputs.

#include "context.h"
#include "demo/demo_report.h"

namespace facenav::app {

struct DemoRequest {
  std::filesystem::path folder;  // result; written whole, replaces an earlier demo
  std::uint64_t seed = 1;
  int frames = 0;  // length of the treatment; 0: the scenario's own
};

/// Runs the demo. Throws Error; `folder` is then unchanged.
DemoFigures runDemo(Context& context, const DemoRequest& request);

}  // namespace facenav::app
