#pragma once
// Draws the skin without a screen: shaded triangles seen along a direction, far ones first. Marks and words
// are drawn over it with OpenCV. Private to pictures.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::pictures {

/// One orthographic view: image right, image down, towards the viewer; Mri directions.
struct SkinView {
  const char* title;
  Eigen::Vector3d right, down, toward;
};

struct SkinCanvas {
  SkinView view;
  cv::Mat image;  // 8-bit, 3 channels, R G B; 2 pixels per mm
  Eigen::Vector3d corner_mm;

  cv::Point at(const Eigen::Vector3d& p_mm) const;
};

/// Draws the upper `height_mm` of the skin, with a margin.
SkinCanvas drawSkin(const SkinView& view, const surface::TriangleMesh& mesh, double height_mm = 260);
/// Draws a dot with a word beside it.
void drawDot(SkinCanvas& canvas, const Eigen::Vector3d& p_mm, const std::string& word,
             const cv::Scalar& colour);
void drawTitle(SkinCanvas& canvas);
RgbImage sideBySide(const std::vector<SkinCanvas>& canvases);

}  // namespace facenav::pictures
