#pragma once
// The methods available for the steps, by name. The program fills it (app/registrations.cpp); a step asks for
// a method by name and knows no implementation.

#include "facenav/capture/camera_backend.h"
#include "facenav/casefile/exporter.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/registry.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/registration/aligner.h"
#include "facenav/segmentation/segmenter.h"

namespace facenav::steps {

struct Registrations {
  Registry<segmentation::Segmenter> head_segmenters{"head segmentation"};
  Registry<segmentation::Segmenter> brain_segmenters{"brain segmentation"};
  Registry<registration::Aligner> aligners{"aligner"};
  Registry<head_tracking::HeadTracker> head_trackers{"head tracker"};
  Registry<coil_tracking::CoilTracker> coil_trackers{"coil tracker"};
  Registry<casefile::Exporter> exporters{"export format"};
  capture::CameraBackends cameras{"kind of camera"};
  /// Returns the program's one face detector (its landmark model takes 100 MB), made at first use.
  std::function<std::shared_ptr<const face::FaceDetector>()> face_detector;
};

/// Lists names for help texts: "head, brain".
template <class Interface>
std::string namesOf(const Registry<Interface>& registry) {
  std::string names;
  for (const auto& entry : registry.entries()) names += (names.empty() ? "" : ", ") + entry.name;
  return names;
}

}  // namespace facenav::steps
