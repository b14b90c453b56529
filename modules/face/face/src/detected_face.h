#pragma once
// Makes FaceLandmarks of a detector's box. Both detectors use it, so that a face has the same box and the
// same landmarks whichever found it.

#include "facenav/face/face_landmarks.h"
#include "facenav/face/landmark_model.h"

namespace facenav::face {

/// A face that a detector found.
struct DetectedFace {
  cv::Rect face;  // in px of the image: the cascade's box, forehead to lower lip
  double roll_rad = 0.0;
  double score = 0.0;  // of the detector; larger: surer
};

/// The box of dlib's detector and landmark model (brows to chin) for a box of the cascade, and back. Both are
/// in an image in which the face is upright.
cv::Rect dlibBox(const cv::Rect& cascade_box);
cv::Rect cascadeBox(const cv::Rect& dlib_box);

/// Adds the landmarks, if their model is installed. They are predicted twice: the box of the first ones is
/// steadier than a detector's box, which has coarse steps of position and scale.
FaceLandmarks withLandmarks(const LandmarkModel& model, const cv::Mat& grey, const DetectedFace& found);

/// The landmarks read from boxes shifted and scaled by some percent of the face, the box itself among them.
std::vector<FaceLandmarks> landmarkReadings(const LandmarkModel& model, const cv::Mat& grey,
                                            const FaceLandmarks& face);

/// The part of an image in which a face that was at `last` is searched, and how much it is reduced: the face
/// is about `width_px` wide in it. Empty if that part lies outside the image.
struct SearchWindow {
  cv::Rect part;
  double scale = 1.0;
};
SearchWindow windowAround(const cv::Mat& grey, const FaceLandmarks& last, double width_px);

/// Moves a face that was found in a part of an image.
void moveBy(const cv::Point& corner, FaceLandmarks& face);

}  // namespace facenav::face
