#pragma once
// Landmarks of a bald, untextured head mesh: the iBUG 68 points, found by dlib's predictor on a shaded
// frontal rendering and projected back onto the mesh. The photographic skin is placed by them.

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::room {

struct HeadLandmarks {
  std::vector<Eigen::Vector3d> points68_mm;  // Mri
};

/// Finds the landmarks. Returns nullopt if the mesh has no face (a scan without a face).
std::optional<HeadLandmarks> findHeadLandmarks(const surface::TriangleMesh& skin);

/// Finds the 68 points in a grey photograph, px; nullopt if no face is found.
std::optional<std::vector<Eigen::Vector2d>> findPortraitLandmarks(const cv::Mat& grey);

}  // namespace facenav::room
