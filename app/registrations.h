#pragma once
// The only place that names implementations. A new camera, tracker, segmentation or aligner is one file in
// its module and one line in registrations.cpp; its name then appears in the command line's help and in the
// window.

#include "facenav/casefile/exporter.h"
#include "facenav/core/registry.h"
#include "facenav/registration/aligner.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/tracking/coil_tracker.h"
#include "facenav/tracking/face_landmarks.h"
#include "facenav/tracking/head_tracker.h"

namespace facenav::app {

struct Registrations {
  Registry<segmentation::Segmenter> head_segmenters{"head segmentation"};
  Registry<segmentation::Segmenter> brain_segmenters{"brain segmentation"};
  Registry<registration::Aligner> aligners{"aligner"};
  Registry<tracking::HeadTracker> head_trackers{"head tracker"};
  Registry<tracking::CoilTracker> coil_trackers{"coil tracker"};
  Registry<casefile::Exporter> exporters{"export format"};
  /// The program's one face detector (its landmark model takes 100 MB), made when first asked for.
  std::function<std::shared_ptr<const tracking::FaceDetector>()> face_detector;
};

Registrations makeRegistrations();

/// "model, features7": for help texts.
template <class Interface>
std::string namesOf(const Registry<Interface>& registry) {
  std::string names;
  for (const auto& entry : registry.entries()) names += (names.empty() ? "" : ", ") + entry.name;
  return names;
}

}  // namespace facenav::app
