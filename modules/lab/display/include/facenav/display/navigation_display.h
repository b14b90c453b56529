#pragma once
// NavigationDisplay: the whole navigation display as one picture (paper, figure 9): the 3-D scene on the
// left, the camera pair with overlays on the right, the bull's eye and the values below. Used for the demo's
// pictures and video; the window shows the same parts as widgets.

#include <memory>
#include <string>

#include "facenav/core/rgb_image.h"
#include "facenav/guidance/guidance.h"
#include "facenav/scene/navigation_scene.h"

namespace facenav::display {

enum class StatusLevel { good, caution, lost };
struct StatusWords {
  std::string words;  // "FACE tracked"
  StatusLevel level = StatusLevel::lost;
};

struct NavigationDisplayContent {
  std::string title;     // "M1 hand L"
  RgbImage left, right;  // the camera images with their overlays
  guidance::GuidanceState guidance;
  StatusWords head, coil;
  std::string timing;  // "frame 214   3.57 s   4.1 ms"
};

class NavigationDisplay {
 public:
  /// `scene` must outlive the display. The caller sets its poses before render().
  explicit NavigationDisplay(scene::NavigationScene& scene, int width_px = 1280, int height_px = 720);
  ~NavigationDisplay();
  NavigationDisplay(const NavigationDisplay&) = delete;
  NavigationDisplay& operator=(const NavigationDisplay&) = delete;

  void setTolerance(const guidance::Tolerance& tolerance);
  RgbImage render(const NavigationDisplayContent& content);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::display
