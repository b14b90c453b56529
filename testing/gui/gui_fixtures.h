#pragma once
// A small case made of balls, and waiting for Qt.

#include <QApplication>
#include <QElapsedTimer>
#include <functional>

#include "facenav/session/preparation.h"
#include "presenters/case_model.h"
#include "support/test_data.h"

namespace facenav::ui::fixtures {

inline bool waitFor(const std::function<bool()>& condition, int limit_ms = 20000) {
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < limit_ms) QApplication::processEvents(QEventLoop::AllEvents, 20);
  return condition();
}

inline surface::TriangleMesh ballMesh(double radius_mm) {
  surface::TriangleMesh mesh;
  const int rows = 30, columns = 40;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double phi = M_PI * i / (rows - 1), theta = 2 * M_PI * j / (columns - 1);
      const Eigen::Vector3d d(std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta),
                              std::cos(phi));
      mesh.vertices_mm.push_back(radius_mm * d);
      mesh.normals.push_back(d);
    }
  for (int i = 0; i + 1 < rows; ++i)
    for (int j = 0; j + 1 < columns; ++j) {
      const int a = i * columns + j;
      mesh.triangles.emplace_back(a, a + columns, a + 1);
      mesh.triangles.emplace_back(a + 1, a + columns, a + columns + 1);
    }
  return mesh;
}

/// Skin at 90 mm, grey inside; no brain.
inline casefile::PreparedCase ballCase() {
  casefile::PreparedCase prepared;
  auto& grid = prepared.mri.grid;
  grid.size = {50, 50, 50};
  grid.mri_from_voxel.linear() *= 4.0;
  grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-98.0);
  for (int k = 0; k < 50; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 50; ++i) {
        const double r = grid.toMri(Eigen::Vector3d(i, j, k)).mm.norm();
        prepared.mri.voxels.push_back(r < 90 ? 160.f : 0.f);
        prepared.head_mask.voxels.push_back(r < 90);
      }
  prepared.head_mask.grid = grid;
  prepared.scalp.mesh = ballMesh(90.0);
  prepared.scalp.has_face = true;
  prepared.findings = {"no brain model: a ball has none"};
  return prepared;
}

inline std::filesystem::path writeBallCase(const std::filesystem::path& folder) {
  casefile::CaseStore::create(folder / "case", ballCase(), {}, false);
  return folder / "case";
}

inline std::shared_ptr<LoadedCase> loadBallCase(const std::filesystem::path& folder) {
  TaskMonitor monitor;
  return loadCase(writeBallCase(folder), monitor);
}

}  // namespace facenav::ui::fixtures
