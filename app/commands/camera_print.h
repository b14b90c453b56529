#pragma once
// Text and JSON of a live pair: rate, delay between the cameras, counts, adjustments.

#include <string>

#include "facenav/capture/camera_pair_source.h"

namespace facenav::app {

/// `rate`: pairs a second; `latency_s`: longest time from capture to arrival here.
void printTrial(const capture::CameraPairSource& source, double rate, double latency_s);
std::string trialJson(const capture::CameraPairSource& source, double rate, double latency_s);

}  // namespace facenav::app
