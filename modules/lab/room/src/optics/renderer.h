#pragma once
// Renderer: the image of a RayScene in one camera, in linear light before the lens blur. One primary ray per
// pixel. Smooth surfaces get four samples on the tangent plane (16 under projected dots, 36 on prints); at
// silhouettes nine rays are cast.

#include <memory>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "camera_rays.h"
#include "lighting.h"
#include "look.h"
#include "ray_scene.h"

namespace facenav::room {

struct View {
  cv::Mat radiance;  // float, linear
  cv::Mat red;       // float: red minus grey (= grey minus blue); empty if no colour was requested
  cv::Mat depth_mm;  // float, along the camera's z at pixel centres; 0 where nothing is hit
  cv::Mat object;    // 8-bit, object number + 1 at pixel centres; 0: backdrop
};

class Renderer {
 public:
  /// `backdrop`: radiance of pixels without an object (float, H x W, at full light), one image per camera.
  Renderer(const CameraRays& rays, cv::Mat backdrop);
  void setBackdrop(cv::Mat backdrop) { backdrop_ = std::move(backdrop); }
  /// Renders an image. `rows`: only these; elsewhere there is the wall.
  View render(const RayScene& scene, const std::vector<std::shared_ptr<const Look>>& looks,
              const Lighting& lighting, const cv::Range& rows = cv::Range::all()) const;

 private:
  const CameraRays& rays_;
  cv::Mat backdrop_;
};

}  // namespace facenav::room
