#include "patch_model.h"

#include <Eigen/LU>
#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace facenav::tracking {
namespace {

struct LevelPlan {
  int half;          // patch of (2 half + 1)^2 samples
  int cell_px;       // one patch per cell, pixels of the level
  std::size_t most;  // patches
};
constexpr LevelPlan kPlan[kLevels] = {{4, 8, 260}, {4, 7, 120}, {4, 5, 60}, {3, 4, 30}};
constexpr double kNoise_grey = 1.3;  // of a blurred image, neighbours' correlation included
constexpr double kModelError_px =
    0.08;  // what shape, light and sampling leave in a patch, pixels of the level
// Shading that changes across a patch as head or lamp turns. 0: 0.48 mm at the cortex on a head turning 30
// degrees under a fixed lamp; 0.001: 0.25; 0.003: 0.19; full: 0.16, but more noise in steady light (0.09,
// 0.10, 0.15, 0.18 mm).
constexpr double kShadingRamp_per_px = 0.001;
constexpr double kWorstSigma_px =
    0.5;  // patches that tell less than this along their best direction are left out
constexpr double kLeastFacing = 0.30;  // cosine of view against normal

double bicubic(const cv::Mat1f& image, double x, double y) {
  const int ix = int(std::floor(x)), iy = int(std::floor(y));
  const auto weights = [](double t, std::array<double, 4>& w) {  // Catmull-Rom
    w = {0.5 * (-t + 2 * t * t - t * t * t), 0.5 * (2 - 5 * t * t + 3 * t * t * t),
         0.5 * (t + 4 * t * t - 3 * t * t * t), 0.5 * (-t * t + t * t * t)};
  };
  std::array<double, 4> wx, wy;
  weights(x - ix, wx), weights(y - iy, wy);
  double sum = 0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) sum += wy[j] * wx[i] * image(iy - 1 + j, ix - 1 + i);
  return sum;
}

bool isInside(const cv::Mat1f& image, const Eigen::Vector2d& px, double margin) {
  return px.x() >= margin && px.y() >= margin && px.x() < image.cols - 1 - margin &&
         px.y() < image.rows - 1 - margin;
}

// Candidate centres (pixels of the level): the pixel of most texture in each cell, most textured first.
std::vector<Eigen::Vector2d> candidates(const cv::Mat1f& image, const FaceRegion& region,
                                        const LevelPlan& plan, int level) {
  cv::Mat1f dx, dy, energy;
  cv::Sobel(image, dx, CV_32F, 1, 0, 3, 0.125);
  cv::Sobel(image, dy, CV_32F, 0, 1, 3, 0.125);
  energy = dx.mul(dx) + dy.mul(dy);
  cv::boxFilter(energy, energy, CV_32F, {2 * plan.half + 1, 2 * plan.half + 1}, {-1, -1}, false);
  struct Candidate {
    float energy;
    Eigen::Vector2d px;
  };
  std::vector<Candidate> found;
  const double scale = 1 << level;
  const cv::Rect box(int(region.box().x / scale), int(region.box().y / scale),
                     int(region.box().width / scale) + 1, int(region.box().height / scale) + 1);
  for (int y0 = box.y; y0 < box.br().y; y0 += plan.cell_px)
    for (int x0 = box.x; x0 < box.br().x; x0 += plan.cell_px) {
      Candidate best{0.f, {}};
      for (int y = y0; y < std::min(y0 + plan.cell_px, image.rows); ++y)
        for (int x = x0; x < std::min(x0 + plan.cell_px, image.cols); ++x)
          if (energy(y, x) > best.energy && region.contains(scale * Eigen::Vector2d(x, y)))
            best = {energy(y, x), {double(x), double(y)}};
      if (best.energy > 0) found.push_back(best);
    }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.energy > b.energy; });
  std::vector<Eigen::Vector2d> centres;
  for (const auto& candidate : found) centres.push_back(candidate.px);
  return centres;
}

struct Samples {
  std::vector<Eigen::Vector3d> points_mm;
  Eigen::Vector3d centre_mm, normal;
};

// Points of the patch on the skin, at whole pixels of the level in the left key image.
std::optional<Samples> samplesOf(const stereo::StereoRig& rig, const FaceSurface& surface,
                                 const Eigen::Vector2d& centre_px, const LevelPlan& plan, int level) {
  const double scale = 1 << level;
  const auto local = surface.around(scale * centre_px, scale * (plan.half + 3));
  if (!local) return std::nullopt;
  const auto lift = [&](const Eigen::Vector2d& px) -> Eigen::Vector3d {
    return stereo::undistort(rig.left, px).homogeneous() / local->inverseDepth(px);
  };
  Samples samples;
  for (int v = -plan.half; v <= plan.half; ++v)
    for (int u = -plan.half; u <= plan.half; ++u) {
      const Eigen::Vector2d px = scale * (centre_px + Eigen::Vector2d(u, v));
      if (!(local->inverseDepth(px) > 0)) return std::nullopt;
      samples.points_mm.push_back(lift(px));
    }
  const Eigen::Vector2d c = scale * centre_px;
  samples.centre_mm = lift(c);
  const Eigen::Vector3d across = lift(c + Eigen::Vector2d(scale, 0)) - lift(c - Eigen::Vector2d(scale, 0));
  const Eigen::Vector3d down = lift(c + Eigen::Vector2d(0, scale)) - lift(c - Eigen::Vector2d(0, scale));
  samples.normal = down.cross(across).normalized();  // towards the camera
  return samples;
}

struct Looked {
  PatchView view;
  std::vector<float> grey, d_u, d_v;
};

void removeMean(std::vector<float>& values) {
  double sum = 0;
  for (float value : values) sum += value;
  for (float& value : values) value -= float(sum / double(values.size()));
}

// A pattern that may be added to a patch, and the share of it to be taken out.
struct Nuisance {
  const std::vector<float>* pattern;  // free of mean
  double share;
};

void removeAll(std::vector<float>& values, const std::vector<Nuisance>& nuisances) {
  removeMean(values);
  for (const auto& [pattern, share] : nuisances) {
    double dot = 0, squares = 1e-9;
    for (std::size_t i = 0; i < values.size(); ++i) {
      dot += double(values[i]) * (*pattern)[i];
      squares += double((*pattern)[i]) * (*pattern)[i];
    }
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= float(share * dot / squares) * (*pattern)[i];
  }
}

// A ramp of unknown strength, of standard deviation kShadingRamp_per_px, beside the noise: what of it to take
// out.
double rampShare(const std::vector<float>& ramp) {
  double squares = 0;
  for (float r : ramp) squares += double(r) * r;
  const double variance = kShadingRamp_per_px * kShadingRamp_per_px * squares;
  return variance / (variance + kNoise_grey * kNoise_grey);
}

// What a lamp that moves does to a patch beyond gain and offset, to first order: it brightens one side.
std::array<std::vector<float>, 2> shadingRamps(const std::vector<float>& grey) {
  const int side = int(std::lround(std::sqrt(double(grey.size()))));
  std::array<std::vector<float>, 2> ramps;
  for (int i = 0; i < side * side; ++i) {
    ramps[0].push_back(grey[i] * float(i % side - side / 2));
    ramps[1].push_back(grey[i] * float(i / side - side / 2));
  }
  return ramps;
}

void finishView(Looked& looked, const std::vector<float>& d_u, const std::vector<float>& d_v) {
  auto& view = looked.view;
  for (std::size_t i = 0; i < looked.grey.size(); ++i) {
    const Eigen::Vector2d d(looked.d_u[i], looked.d_v[i]);
    view.structure += d * Eigen::RowVector2d(d_u[i], d_v[i]);
  }
  const double least = 1e-3 * view.structure.trace() + 1e-6;
  view.structure_inverse = (view.structure + least * Eigen::Matrix2d::Identity()).inverse();
  const Eigen::Matrix2d covariance = kNoise_grey * kNoise_grey * view.structure_inverse +
                                     kModelError_px * kModelError_px * Eigen::Matrix2d::Identity();
  view.information = covariance.inverse();
  view.is_usable = view.structure.trace() > kNoise_grey * kNoise_grey / (kWorstSigma_px * kWorstSigma_px);
}

Looked look(const stereo::CameraModel& camera, const Eigen::Isometry3d& camera_T_left, const cv::Mat1f& image,
            const Samples& samples, double scale) {
  Looked looked;
  const Eigen::Vector3d centre_mm = camera_T_left * samples.centre_mm;
  const double facing = -(camera_T_left.linear() * samples.normal).dot(centre_mm.normalized());
  if (facing < kLeastFacing) return looked;
  for (const auto& p_mm : samples.points_mm) {
    const Eigen::Vector2d px = stereo::project(camera, camera_T_left * p_mm) / scale;
    if (!isInside(image, px, 3)) return looked;
    looked.grey.push_back(float(bicubic(image, px.x(), px.y())));
    looked.d_u.push_back(
        float(0.5 * (bicubic(image, px.x() + 1, px.y()) - bicubic(image, px.x() - 1, px.y()))));
    looked.d_v.push_back(
        float(0.5 * (bicubic(image, px.x(), px.y() + 1) - bicubic(image, px.x(), px.y() - 1))));
  }
  auto ramps = shadingRamps(looked.grey);
  removeMean(looked.grey);
  double contrast = 0;
  for (float g : looked.grey) contrast += double(g) * g;
  if (contrast < 1e-3) return looked;
  removeAll(ramps[0], {{&looked.grey, 1.0}});
  removeAll(ramps[1], {{&looked.grey, 1.0}, {&ramps[0], 1.0}});
  for (auto* d : {&looked.d_u, &looked.d_v}) removeAll(*d, {{&looked.grey, 1.0}});
  const auto d_u = looked.d_u, d_v = looked.d_v;
  for (auto* d : {&looked.d_u, &looked.d_v})
    removeAll(*d, {{&ramps[0], rampShare(ramps[0])}, {&ramps[1], rampShare(ramps[1])}});
  looked.view.contrast = float(contrast);
  looked.view.px = stereo::project(camera, centre_mm);
  finishView(looked, d_u, d_v);
  return looked;
}

void append(PatchLevel& model, const Samples& samples, double rigidity, const std::array<Looked, 2>& looked) {
  Patch patch;
  patch.centre_mm = samples.centre_mm;
  patch.normal = samples.normal;
  patch.rigidity = rigidity;
  for (const auto& p : samples.points_mm) {
    model.x.push_back(float(p.x()));
    model.y.push_back(float(p.y()));
    model.z.push_back(float(p.z()));
  }
  const std::vector<float> none(samples.points_mm.size(), 0.f);
  for (int c = 0; c < 2; ++c) {
    patch.view[c] = looked[c].view;
    const auto add = [&](std::vector<float>& to, const std::vector<float>& from) {
      const auto& source = looked[c].view.is_usable ? from : none;
      to.insert(to.end(), source.begin(), source.end());
    };
    add(model.looks[c].grey, looked[c].grey);
    add(model.looks[c].d_u, looked[c].d_u);
    add(model.looks[c].d_v, looked[c].d_v);
  }
  model.patches.push_back(patch);
}

PatchLevel learnLevel(const stereo::StereoRig& rig, const std::array<ImagePyramid, 2>& key,
                      const FaceRegion& region, const FaceSurface& surface, int level) {
  const LevelPlan& plan = kPlan[level];
  const double scale = 1 << level;
  PatchLevel model;
  model.level = level;
  model.samples = (2 * plan.half + 1) * (2 * plan.half + 1);
  for (const auto& px : candidates(key[0].level[level], region, plan, level)) {
    if (model.patches.size() >= plan.most) break;
    const auto samples = samplesOf(rig, surface, px, plan, level);
    if (!samples) continue;
    const std::array<Looked, 2> looked = {
        look(rig.left, Eigen::Isometry3d::Identity(), key[0].level[level], *samples, scale),
        look(rig.right, rig.right_T_left.isometry(), key[1].level[level], *samples, scale)};
    if (!looked[0].view.is_usable && !looked[1].view.is_usable) continue;
    append(model, *samples, region.rigidity(scale * px), looked);
  }
  return model;
}

// d(displacement)/d(xi): the patch's point moves by exp(w)(X - c) + c + v before it is seen in the key frame.
void addJacobians(const stereo::StereoRig& rig, const Eigen::Vector3d& centre_mm, PatchLevel& model) {
  for (auto& patch : model.patches)
    for (int c = 0; c < 2; ++c) {
      const auto& camera = c == 0 ? rig.left : rig.right;
      const Eigen::Isometry3d camera_T_left =
          c == 0 ? Eigen::Isometry3d::Identity() : rig.right_T_left.isometry();
      Eigen::Matrix<double, 2, 3> d_p;
      stereo::project(camera, camera_T_left * patch.centre_mm, d_p);
      const Eigen::Matrix<double, 2, 3> d_x = d_p * camera_T_left.linear() / double(1 << model.level);
      patch.view[c].jacobian << d_x * -skew(patch.centre_mm - centre_mm), d_x;
    }
}

}  // namespace

PatchModel learnPatches(const stereo::StereoRig& rig, const std::array<ImagePyramid, 2>& key,
                        const FaceRegion& region, const FaceSurface& surface) {
  PatchModel model;
  for (int level = 0; level < kLevels; ++level)
    model.level[level] = learnLevel(rig, key, region, surface, level);
  for (const auto& patch : model.level[0].patches)
    model.centre_mm += patch.centre_mm / double(model.level[0].patches.size());
  for (auto& level : model.level) addJacobians(rig, model.centre_mm, level);
  return model;
}

}  // namespace facenav::tracking
