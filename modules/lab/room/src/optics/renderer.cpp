#include "renderer.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/parallel_for.h"

namespace facenav::room {
namespace {

// Samples along each side of a pixel: skin, silhouette, skin under dots, print.
constexpr int kCoarse = 2, kEdge = 3, kDots = 4, kFine = 6;
constexpr float kBend_mm = 3.f;  // a larger second difference of depth over one pixel is a silhouette

constexpr float kWallRedness = 0.1f;

/// Light at one sample: its grey, and the amount by which red is brighter.
struct Light {
  float grey = 0.f, red = 0.f;
  void operator+=(const Light& other) { grey += other.grey, red += other.red; }
  Light over(float count) const { return {grey / count, red / count}; }
};

bool areAlike(const Hit& a, const Hit& b) {
  return a.object == b.object && std::abs(a.distance - b.distance) < kBend_mm &&
         a.normal.dot(b.normal) > 0.98;
}

/// The centre of a cell of a side x side grid over the pixel (-0.5 .. 0.5), for texture without straight
/// edges.
std::pair<double, double> middleOfCell(int sample, int side) {
  return {(sample % side + 0.5) / side - 0.5, (sample / side + 0.5) / side - 0.5};
}

/// Position in its pixel (-0.5 .. 0.5) of a sample of a side x side grid. Each row and each column is shifted
/// relative to the previous one, so that edges along rows or columns meet side^2 phases instead of side. A
/// printed edge is then placed to 1/36 px instead of 1/6 px.
std::pair<double, double> place(int sample, int side) {
  const int row = sample / side, column = sample % side;
  return {(column + (row + 0.5) / side) / side - 0.5, (row + (column + 0.5) / side) / side - 0.5};
}

/// Everything that is constant for one image.
struct Shot {
  const CameraRays& rays;
  const RayScene& scene;
  const std::vector<std::shared_ptr<const Look>>& looks;
  const LightMeter& meter;
  const cv::Mat& backdrop;
  bool has_dots, has_gloss, has_colour;
  float backdrop_scale;

  Light wall(int x, int y) const {
    const float grey = backdrop_scale * backdrop.at<float>(y, x);
    return {grey, kWallRedness * grey};
  }

  Eigen::Vector3d toEye(const Eigen::Vector3d& p_mm) const { return (rays.origin_mm() - p_mm).normalized(); }

  LightMeter::Falling falling(const Hit& hit, const Eigen::Vector3d& p_mm) const {
    std::optional<Eigen::Vector3d> relief_normal;
    if (has_gloss)
      if (const auto slope = looks[hit.object]->relief({hit.p_object_mm, hit.triangle, hit.u, hit.v}))
        relief_normal = (hit.normal + scene.pose(hit.object).linear() * *slope).normalized();
    return meter.falling(p_mm, hit.normal, toEye(p_mm), relief_normal);
  }

  Light shade(const Hit& hit, const LightMeter::Falling& light, const Eigen::Vector3d& p_world_mm,
              const Eigen::Vector3d& p_object_mm) const {
    const SurfacePoint point{p_object_mm, hit.triangle, hit.u, hit.v};
    const Reflectance r = looks[hit.object]->at(point);
    float diffuse = light.diffuse;
    if (has_dots && light.sees_projector) diffuse += meter.dots(p_world_mm, hit.normal);
    const float grey = r.albedo * diffuse + r.gloss * light.highlight + light.sheen;
    return {grey, has_colour ? looks[hit.object]->redness(point) * r.albedo * diffuse : 0.f};
  }

  /// Takes samples on the tangent plane at the hit of the pixel's centre.
  Light smoothPixel(int x, int y, const Hit& hit, bool is_printed) const {
    const int side = is_printed ? kFine : has_dots ? kDots : kCoarse;
    const Eigen::Isometry3d& pose = scene.pose(hit.object);
    const Eigen::Vector3d centre_mm = pose * hit.p_object_mm;
    const LightMeter::Falling light = falling(hit, centre_mm);
    const double height = hit.facet_normal.dot(centre_mm - rays.origin_mm());
    Light sum;
    for (int sample = 0; sample < side * side; ++sample) {
      const auto [dx, dy] = is_printed || has_dots ? place(sample, side) : middleOfCell(sample, side);
      const Eigen::Vector3d along = rays.direction(x + dx, y + dy);
      const Eigen::Vector3d p_mm = rays.origin_mm() + height / hit.facet_normal.dot(along) * along;
      sum += shade(hit, light, p_mm, pose.linear().transpose() * (p_mm - pose.translation()));
    }
    return sum.over(float(side * side));
  }

  Light edgePixel(int x, int y) const {
    Light sum;
    std::optional<Hit> lit;  // the last hit with computed light; similar hits reuse its light
    LightMeter::Falling light;
    for (int sample = 0; sample < kEdge * kEdge; ++sample) {
      const auto [dx, dy] = place(sample, kEdge);
      const auto hit = scene.intersect(rays.origin_mm(), rays.direction(x + dx, y + dy));
      if (!hit) {
        sum += wall(x, y);
        continue;
      }
      const Eigen::Vector3d p_mm = scene.pose(hit->object) * hit->p_object_mm;
      if (!lit || !areAlike(*lit, *hit)) {
        light = falling(*hit, p_mm);
        lit = hit;
      }
      sum += shade(*hit, light, p_mm, hit->p_object_mm);
    }
    return sum.over(float(kEdge * kEdge));
  }
};

/// The first hits of all pixel centres inside `window`.
class Sights {
 public:
  Sights(const RayScene& scene, const CameraRays& rays, const cv::Rect& window)
      : window_(window), sights_(std::size_t(window.area())) {
    parallelRanges(0, window.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        for (int x = 0; x < window.width; ++x)
          sights_[std::size_t(y) * window.width + x] =
              scene.look(rays.origin_mm(), rays.direction(window.x + x, window.y + y));
    });
  }

  const Sight& at(int x, int y) const {
    return sights_[std::size_t(y - window_.y) * window_.width + (x - window_.x)];
  }

  /// True if a silhouette passes within a pixel: a neighbour shows another object, or the depth bends too
  /// sharply.
  bool isEdge(int x, int y) const {
    if (x <= window_.x || y <= window_.y || x + 1 >= window_.br().x || y + 1 >= window_.br().y) return false;
    const Sight& centre = at(x, y);
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
      const Sight &ahead = at(x + dx, y + dy), &behind = at(x - dx, y - dy);
      if (ahead.object != centre.object || behind.object != centre.object) return true;
      if (std::abs(ahead.distance + behind.distance - 2.f * centre.distance) > kBend_mm) return true;
    }
    return false;
  }

 private:
  cv::Rect window_;
  std::vector<Sight> sights_;
};

/// The part of the image in which any object can appear, from their bounding boxes.
cv::Rect windowOf(const RayScene& scene, int objects, const CameraRays& rays) {
  const cv::Rect image(0, 0, rays.width_px(), rays.height_px());
  cv::Rect window;
  for (int object = 0; object < objects; ++object) {
    if (!scene.isShown(object)) continue;
    const auto box = rays.boxOf(scene.bounds(object), scene.pose(object));
    if (!box) return image;
    window |= *box;
  }
  return window & image;
}

}  // namespace

Renderer::Renderer(const CameraRays& rays, cv::Mat backdrop) : rays_(rays), backdrop_(std::move(backdrop)) {}

View Renderer::render(const RayScene& scene, const std::vector<std::shared_ptr<const Look>>& looks,
                      const Lighting& lighting, const cv::Range& asked) const {
  const int width = rays_.width_px(), height = rays_.height_px();
  const cv::Range rows = asked == cv::Range::all() ? cv::Range(0, height) : asked;
  const LightMeter meter(lighting, scene);
  const Shot shot{rays_,
                  scene,
                  looks,
                  meter,
                  backdrop_,
                  lighting.projector.has_value(),
                  lighting.gloss > 0.0,
                  lighting.has_colour,
                  float(lighting.backdrop)};
  // One row more on both sides: a silhouette is found by its neighbours.
  const cv::Rect window =
      windowOf(scene, int(looks.size()), rays_) & cv::Rect(0, rows.start - 1, width, rows.size() + 2);
  const Sights sights(scene, rays_, window);
  View view{backdrop_ * lighting.backdrop,
            {},
            cv::Mat::zeros(height, width, CV_32F),
            cv::Mat::zeros(height, width, CV_8U)};
  if (lighting.has_colour) view.red = view.radiance * kWallRedness;
  const auto put = [&view](int x, int y, const Light& light) {
    view.radiance.at<float>(y, x) = light.grey;
    if (!view.red.empty()) view.red.at<float>(y, x) = light.red;
  };
  parallelRanges(std::max(window.y, rows.start), std::min(window.br().y, rows.end), [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = window.x; x < window.br().x; ++x) {
        const Sight& sight = sights.at(x, y);
        std::optional<Hit> hit;
        if (sight.object >= 0) {
          hit = scene.refine(sight, rays_.origin_mm(), rays_.direction(x, y));
          view.depth_mm.at<float>(y, x) = float(hit->distance);
          view.object.at<std::uint8_t>(y, x) = std::uint8_t(hit->object + 1);
        }
        if (sights.isEdge(x, y))
          put(x, y, shot.edgePixel(x, y));
        else if (hit)
          put(x, y, shot.smoothPixel(x, y, *hit, looks[hit->object]->isPrinted()));
      }
  });
  return view;
}

}  // namespace facenav::room
