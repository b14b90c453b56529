#pragma once
// PlacementJudge: judges whether the two cameras are placed well: distance, overlap, light and focus, from
// the pictures of a person who sits where the patient will sit. Needs no calibration. Step 1 of the set-up.

#include <memory>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/core/setting.h"
#include "facenav/face/face_landmarks.h"

namespace facenav::steps {

struct PlacementRules {
  static constexpr const char* kModule = "workflow";
  static constexpr const char* kSubject = "placing of the cameras";

  double least_face_px = 120, least_face_share = 0.15, most_face_share = 0.6;
  double edge_share = 0.03, most_size_ratio = 1.3, most_height_share = 0.25;
  double least_grey = 50, most_grey = 210, most_white_share = 0.03, most_grey_ratio = 1.8;
  double most_blur = 0.45;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kPlace("least_face_px", 20, 4000, "px", "width of the face in a picture, at least"),
            self.least_face_px);
    visitor(kPlace("least_face_share", 0.01, 1, "1", "width of the face, of the picture's, at least"),
            self.least_face_share);
    visitor(kPlace("most_face_share", 0.01, 1, "1", "at most"), self.most_face_share);
    visitor(kPlace("edge_share", 0, 0.5, "1", "free between face and border, of the picture"),
            self.edge_share);
    visitor(kPlace("most_size_ratio", 1, 10, "1", "of the face in one picture to that in the other"),
            self.most_size_ratio);
    visitor(kPlace("most_height_share", 0, 1, "1",
                   "difference of the face's height in the two pictures, of the picture's"),
            self.most_height_share);
    visitor(kLight("least_grey", 0, 255, "1", "mean of the face"), self.least_grey);
    visitor(kLight("most_grey", 0, 255, "1", "mean of the face"), self.most_grey);
    visitor(kLight("most_white_share", 0, 1, "1", "of the face that is white (above 250)"),
            self.most_white_share);
    visitor(kLight("most_grey_ratio", 1, 20, "1", "of one picture's mean to the other's"),
            self.most_grey_ratio);
    visitor(kFocus("most_blur", 0, 1, "1", "of the face (Crete 2007: 0 sharp, 1 blurred)"), self.most_blur);
  }

  static constexpr Evidence kPlace{Origin::chosen,
                                   "by judgement: faces of the virtual room are 200 to 420 px wide"};
  static constexpr Evidence kLight{Origin::chosen, "by judgement: skin keeps its texture in this range"};
  static constexpr Evidence kFocus{
      Origin::chosen,
      "by judgement, between the sharp and the blurred texture of its test; no webcam was measured"};
};

/// Finding on one criterion.
struct PlacementFinding {
  enum class Subject { distance, overlap, light, focus };
  Subject subject;
  bool is_good = false;
  std::string words;  // what to do, or what is good
};

struct Placement {
  std::vector<PlacementFinding> findings;  // distance, overlap, light, focus; overlap alone without a face
  bool isGood() const;
  /// Words of the most urgent finding, one sentence.
  std::string words() const;
  std::optional<cv::Rect> left_face, right_face;
};

class PlacementJudge {
 public:
  explicit PlacementJudge(std::shared_ptr<const face::FaceDetector> detector);
  /// Judges a frame in some 10 ms while the face does not move.
  Placement judge(const cameras::StereoFrame& frame);

 private:
  std::shared_ptr<const face::FaceDetector> detector_;
  std::optional<face::FaceLandmarks> left_, right_;  // of the previous frame
};

/// Blur of a grey picture without a reference, 0 sharp .. 1 blurred: how little neighbouring pixels change
/// more than after further blurring. F. Crete et al., "The blur effect", SPIE 6492 (2007).
double blurEffect(const cv::Mat& grey);

}  // namespace facenav::steps
