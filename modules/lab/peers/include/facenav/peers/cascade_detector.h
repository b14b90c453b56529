#pragma once
// CascadeDetector: a peer method to compare face detection with: the 2010 paper's Haar cascade
// (Viola & Jones 2001; paper, section 4).

#include <memory>

#include "facenav/face/face_landmarks.h"
#include "facenav/face/landmark_model.h"

namespace facenav::peers {

/// Makes the paper's detector. Throws Error naming the missing package if the cascade file is not installed.
std::unique_ptr<face::FaceDetector> makeCascadeDetector(std::shared_ptr<const face::LandmarkModel> landmarks);

}  // namespace facenav::peers
