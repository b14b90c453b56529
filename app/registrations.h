#pragma once
// The only place that names implementations. A new camera, tracker, segmentation or aligner is one file in
// its module and one line in registrations.cpp; its name then appears in the command line's help and in the
// window.

#include "facenav/workflow/registrations.h"

namespace facenav::app {

workflow::Registrations makeRegistrations();

}  // namespace facenav::app
