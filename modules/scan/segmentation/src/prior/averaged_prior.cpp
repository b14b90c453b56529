#include "prior/averaged_prior.h"

#include <algorithm>
#include <cmath>

#include "brain_start.h"
#include "facenav/geometry/rotation.h"
#include "facenav/volume/regrid.h"
#include "prior/head_window.h"
#include "scan_grid.h"

namespace facenav::segmentation {
namespace {

using volume::Volume;
using volume::VoxelGrid;

constexpr float kMostValue = 1.2f;  // largest window value; 0 is black, 1 white
constexpr float kAir = 0.06f;
constexpr float kBrighter = 0.6f, kDarker = 1.7f;  // exponents
constexpr double kZoom = 0.9;  // voxel size relative to the network's: the head is seen this much finer
constexpr double kTurn_deg = 12;
constexpr double kShift_mm = 1.8;  // half a voxel of the finer window
constexpr int kFirstViews = 4;     // number of views in findBrainPrior
constexpr int kPerVoxel = 4;       // working voxels along a window's voxel

struct View {
  Volume window;
  bool is_mirrored;
};

Volume mirroredWindow(Volume window) {
  const int row = window.grid.size[0];
  for (auto from = window.voxels.begin(); from != window.voxels.end(); from += row)
    std::reverse(from, from + row);
  return window;
}

/// The window about `centre`, finer than the network's by kZoom and turned about the left-right axis.
Volume turnedWindow(const Volume& working, const Point<Mri>& centre, double turn_deg) {
  VoxelGrid fine;
  Eigen::Vector3d middle;
  for (int a = 0; a < 3; ++a) {
    fine.size[a] = kPriorSize[std::size_t(a)] * kPerVoxel;
    middle[a] = (fine.size[a] - 1) / 2.0;
  }
  fine.mri_from_voxel.setIdentity();
  fine.mri_from_voxel.linear() =
      kZoom * Eigen::AngleAxisd(kRadPerDeg * turn_deg, Eigen::Vector3d::UnitX()).toRotationMatrix();
  fine.mri_from_voxel.translation() = centre.mm - fine.mri_from_voxel.linear() * middle;
  const Volume coarse = halved(halved(volume::resample(working, fine)));
  return headWindow(coarse,
                    coarse.grid.toMri({kPriorSize[0] / 2.0, kPriorSize[1] / 2.0, kPriorSize[2] / 2.0}));
}

std::vector<View> moreViews(const Volume& working, const BrainPrior& prior) {
  const Volume half = halved(working);
  const Point<Mri> centre = prior.brain.grid.centre(), brain(ballLike(prior.mask()).centre_mm);
  const Volume first = headWindow(halved(half), centre), second = headWindow(halved(half, 1), centre);
  const Point<Mri> shifted(brain.mm + Eigen::Vector3d::Constant(kShift_mm));
  return {{withCurve(first, IntensityCurve::brighter), false},
          {withCurve(second, IntensityCurve::darker), true},
          {withCurve(first, IntensityCurve::inverted), false},
          {withCurve(second, IntensityCurve::inverted), true},
          {turnedWindow(working, brain, 0), false},
          {turnedWindow(working, shifted, 0), true},
          {turnedWindow(working, brain, kTurn_deg), false},
          {turnedWindow(working, brain, -kTurn_deg), true}};
}

Volume brainShare(const PriorNetwork& network, const View& view, const VoxelGrid& grid) {
  const Volume seen = view.is_mirrored ? mirroredWindow(view.window) : view.window;
  const Volume share{seen.grid, network.shares(seen)[kPriorBrain], {}, {}};
  return volume::resample(view.is_mirrored ? mirroredWindow(share) : share, grid);
}

}  // namespace

Volume withCurve(Volume window, IntensityCurve curve) {
  for (float& value : window.voxels) {
    const float x = std::clamp(value, 0.f, kMostValue);
    if (curve == IntensityCurve::inverted)
      value = x < kAir ? x : std::max(0.f, 1 + kAir - x);
    else
      value = std::pow(x, curve == IntensityCurve::brighter ? kBrighter : kDarker);
  }
  return window;
}

BrainPrior averagedPrior(const PriorNetwork& network, const Volume& working, BrainPrior prior) {
  const std::vector<View> views = moreViews(working, prior);
  for (float& share : prior.brain.voxels) share *= kFirstViews;
  for (const View& view : views) {
    const Volume share = brainShare(network, view, prior.brain.grid);
    for (std::size_t v = 0; v < share.voxels.size(); ++v) prior.brain.voxels[v] += share.voxels[v];
  }
  for (float& share : prior.brain.voxels) share /= float(kFirstViews + int(views.size()));
  return prior;
}

}  // namespace facenav::segmentation
