#pragma once
// BoardCollector: chooses the views of a calibration. A person holds the board before both cameras, moves it
// and holds it still. A view is taken when the board is still in both pictures, sharp, well lit, and in a
// pose that no earlier view shows. Each refusal has a reason; wish() names what is still missing.
// cameras::calibrateCorners makes the rig from the views.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/board_quality.h"
#include "facenav/cameras/calibrate.h"
#include "facenav/cameras/stereo_frame.h"
#include "facenav/core/setting.h"

namespace facenav::steps {

struct BoardRules {
  static constexpr const char* kModule = "workflow";
  static constexpr const char* kSubject = "views of the calibration board";

  double still_s = 0.4, still_share = 0.0008;
  double most_edge_px = 4.0, most_edge_share = 0.2;
  double least_contrast = 40, most_white = 252;
  double new_place = 0.12, new_size = 0.15, new_tilt = 0.2;
  int wanted_views = 15, most_views = 30;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kHeld("still_s", 0, 5, "s", "how long the board must stand still"), self.still_s);
    visitor(kHeld("still_share", 0.00001, 0.1, "1",
                  "largest motion of a corner meanwhile, as a share of the picture's width"),
            self.still_share);
    visitor(kShown("most_edge_px", 0.5, 50, "px", "blurred: an edge between squares is wider (20 to 80 %)"),
            self.most_edge_px);
    visitor(kShown("most_edge_share", 0.01, 1, "1", "and wider than this share of a square"),
            self.most_edge_share);
    visitor(kShown("least_contrast", 1, 255, "1", "too dark: white and black squares differ by less, grey"),
            self.least_contrast);
    visitor(kShown("most_white", 1, 255, "1", "too bright: the white squares are above this grey"),
            self.most_white);
    visitor(kNew("new_place", 0, 1, "1", "a view is new: its middle moved by this share of the picture"),
            self.new_place);
    visitor(kNew("new_size", 0, 2, "1", "or its size changed by this share"), self.new_size);
    visitor(kNew("new_tilt", 0, 2, "1", "or the direction of its normal by so much (radians, nearly)"),
            self.new_tilt);
    visitor(kNew("wanted_views", 5, 200, "1", "views that are enough where they cover everything"),
            self.wanted_views);
    visitor(kNew("most_views", 5, 200, "1", "views after which no more is wished for"), self.most_views);
  }

  static constexpr Evidence kHeld{
      Origin::chosen, "by judgement: half a pixel at 640 px; a hand that holds a board up moves more"};
  static constexpr Evidence kShown{Origin::chosen,
                                   "by judgement; 19 real boards (boards_2, camera m) have edges of 1.4 to "
                                   "2.0 px; webcams were not measured"};
  static constexpr Evidence kNew{Origin::chosen,
                                 "by judgement; calibrate asks for 5 views and is better with 15 to 20"};
};

/// Result of the last pair.
struct BoardSight {
  enum class State {
    none,      // no board in either picture
    one_side,  // in one picture only
    moving,    // it is not still
    refused,   // blurred, dark or bright: `reason`
    known,     // nothing new
    taken,     // a view was taken
  };
  State state = State::none;
  std::string reason;                // why it was not taken; empty if it was
  cameras::SeenCorners left, right;  // for drawing; empty: not seen
};

/// Poses and picture areas covered by the views.
struct BoardCoverage {
  std::vector<bool> left_cells, right_cells;  // 3 x 3, row by row: true where a corner was seen
  // Set by views tilted so that this edge of the board, as seen in the left picture, is the farther one.
  bool is_left_far = false, is_right_far = false, is_top_far = false, is_bottom_far = false;
  double size_ratio = 1;  // size of the nearest view divided by that of the farthest
  int cellsMissing() const;
  int tiltsMissing() const;
};

class BoardCollector {
 public:
  BoardCollector(const cameras::Board& board, const cv::Size& picture, const BoardRules& rules);
  BoardCollector(const cameras::Board& board, const cv::Size& picture);  // with the settings in force

  /// Adds a pair of a film, in the order of the capture times.
  BoardSight add(const cameras::StereoFrame& frame);
  /// Adds a pair taken on request, with the board at rest. Until there are enough views, it need not show
  /// something new.
  BoardSight addStill(const cameras::CalibrationPair& pair);

  const std::vector<cameras::BoardView>& views() const { return views_; }
  BoardCoverage coverage() const;
  /// True if the views suffice for a good calibration.
  bool isEnough() const;
  /// What to do next, one sentence: "hold the board in the upper left of the picture".
  std::string wish() const;
  /// Number of refused pairs by reason, since the start.
  const std::map<std::string, int>& refusals() const { return refusals_; }
  /// Calibrates the rig from the views. Throws Error as calibrateCorners does.
  cameras::Calibration calibrate(TaskMonitor& monitor) const;
  void clear();

 private:
  struct Shape {         // of a view in the left picture
    cv::Point2d middle;  // share of the picture
    double size = 0;     // share of its width
    cv::Point2d normal;  // x and y of the unit normal in the left camera, focal length assumed
  };
  struct Held {
    double t_s;
    cameras::SeenCorners left, right;
  };

  BoardSight seen(const cv::Mat& left, const cv::Mat& right, bool is_live) const;
  std::string fault(const cv::Mat& image, const cameras::SeenCorners& corners) const;
  Shape shapeOf(const cameras::SeenCorners& corners) const;
  bool isNew(const Shape& shape) const;
  bool isStill(double now_s);
  bool isNearlyStill() const;
  void judge(const cv::Mat& left, const cv::Mat& right, const std::string& name, bool is_live,
             BoardSight& sight);
  BoardSight counted(BoardSight sight);

  cameras::Board board_;
  cv::Size picture_;
  BoardRules rules_;
  std::vector<cameras::BoardView> views_;
  std::vector<Shape> shapes_;
  std::vector<Held> held_;
  cameras::SeenCorners last_left_;  // in the pair before the newest
  std::map<std::string, int> refusals_;
};

}  // namespace facenav::steps
