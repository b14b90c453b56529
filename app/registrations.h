#pragma once
// The only place that names implementations. A new camera, tracker, segmentation or aligner needs one file in
// its module and one line in registrations.cpp. Its name then appears in the command line's help and in the
// window.

#include "facenav/methods/registrations.h"

namespace facenav::app {

steps::Registrations makeRegistrations();

}  // namespace facenav::app
