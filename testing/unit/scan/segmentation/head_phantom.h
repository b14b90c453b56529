#pragma once
// A head whose brain is known: scalp, skull, fluid, a brain with sulci, neck with muscle and spinal cord,
// eyes.

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "facenav/volume/volume.h"

namespace facenav::testing {

struct PhantomOptions {
  double spacing_mm = 1.5;
  double size = 1.0;    // size of the head: 0.85 is a child's
  double noise = 0.03;  // share of white matter's value
  double gain = 1.0, offset = 0.0;
  double bias = 0.0;       // log gain from back to front
  bool has_dura = false;   // a piece of dura at the vertex, as bright as cortex, beyond a film of fluid
  bool has_tissue = true;  // if false, one value throughout the brain, as CT shows it
};

struct HeadPhantom {
  volume::Volume volume;
  volume::Mask brain;  // with its sulci closed: the pial ellipsoid, cerebellum included
  volume::Mask dura;   // empty unless requested
};

inline HeadPhantom makeHeadPhantom(const PhantomOptions& options = {}) {
  using Eigen::Vector3d;
  HeadPhantom phantom;
  const double h = options.spacing_mm;
  auto& grid = phantom.volume.grid;
  grid.size = {int(180 / h), int(216 / h), int(250 / h)};
  grid.mri_from_voxel = Eigen::Translation3d(-90, -108, -150) * Eigen::Scaling(h);
  phantom.brain.grid = grid;
  phantom.brain.voxels.assign(grid.count(), 0);
  phantom.dura = phantom.brain;
  phantom.volume.voxels.resize(grid.count());
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, options.noise * 100);
  // < 0 inside an ellipsoid, about mm from its surface.
  const auto ellipsoid = [](const Vector3d& p, const Vector3d& c, const Vector3d& r) {
    return (((p - c).cwiseQuotient(r)).norm() - 1) * r.minCoeff();
  };
  std::size_t at = 0;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i, ++at) {
        const Vector3d p = grid.toMri({double(i), double(j), double(k)}).mm / options.size;
        const double cerebrum = ellipsoid(p, {0, 0, 10}, {66, 84, 58});
        const double cerebellum = ellipsoid(p, {0, -45, -38}, {48, 34, 26});
        const double brain = std::min(cerebrum, cerebellum);
        const double head = std::min(ellipsoid(p, {0, 0, 5}, {80, 99, 78}),
                                     std::max(std::hypot(p.x(), p.y() + 10) - 62, p.z()));
        const double cord = std::max(std::hypot(p.x(), p.y() + 20) - 8, p.z() + 30);
        const double eyes =
            std::min(ellipsoid(p, {32, 82, -30}, {12, 12, 12}), ellipsoid(p, {-32, 82, -30}, {12, 12, 12}));
        double value = 0;
        if (head < 0) value = 60 + 70 * (head > -5 && p.z() > -60);  // muscle, under fat
        if (head < -5 && brain < 9) value = 8;                       // skull
        if (brain < 3) value = 25;                                   // fluid
        if (eyes < 0) value = 30;
        if (options.has_dura && brain >= 0 && brain < 7 && p.z() > 0 && std::hypot(p.x(), p.y()) < 25) {
          const bool is_film = brain < 2;  // too thin for the voxels: half of what they hold is tissue
          value = is_film ? 48 : 70;
          phantom.dura.voxels[at] = !is_film;
        }
        if (brain < 0) {
          const double folds = std::sin(p.x() / 4.2) * std::sin(p.y() / 4.6) * std::sin(p.z() / 4.4);
          const bool is_sulcus = folds > 0.75 && brain > -12;
          value = is_sulcus ? 25 : brain > -3.5 || folds > 0.1 ? 70 : 100;
          if (!options.has_tissue) value = 70;
          phantom.brain.voxels[at] = 1;
        } else if (cord < 0) {
          value = 90;
        } else if (cord < 4) {
          value = 20;
        }
        value *= std::exp(options.bias * p.y() / 100);
        value = std::hypot(value + noise(random), noise(random));
        phantom.volume.voxels[at] = float(value * options.gain + options.offset);
      }
  return phantom;
}

}  // namespace facenav::testing
