#include "skin_mesh.h"

#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "facenav/anatomy/head_norms.h"
#include "facenav/core/error.h"
#include "facenav/volume/regrid.h"

namespace facenav::room {
namespace {

constexpr int kClosing = 3;  // voxels: narrow openings of the skin are closed
// Voxels of air added around the scan: nose and ears may touch its edge, and smoothing and closing must not
// reach the rim.
constexpr int kPad = 2 * kClosing + 2;
constexpr double kOwnEdge = 0.4;  // smallest slope of the skin's edge, relative to the steepest within reach
constexpr float kLowestMr = -200.f, kAir_hu = -1000.f, kSoftTissue_hu = 200.f;

using Cells = std::vector<float>;

/// Sets air to 0. A CT (recognised by negative Hounsfield values) is clipped at soft tissue, so that skin and
/// bone have the same value.
volume::Volume withAirAtZero(volume::Volume scan) {
  if (volume::percentile(scan, 0.1) > kLowestMr) return scan;
  for (float& value : scan.voxels) value = std::clamp(value, kAir_hu, kSoftTissue_hu) - kAir_hu;
  return scan;
}

/// Returns the scan with a rim of air, in RAS order.
volume::Volume padded(const volume::Volume& in) {
  const volume::Volume ras = withAirAtZero(volume::toRasOrder(in));
  volume::Volume out;
  for (int axis = 0; axis < 3; ++axis) out.grid.size[axis] = ras.grid.size[axis] + 2 * kPad;
  out.grid.mri_from_voxel = ras.grid.mri_from_voxel;
  out.grid.mri_from_voxel.translation() = ras.grid.mri_from_voxel * Eigen::Vector3d::Constant(-kPad);
  out.voxels.assign(out.grid.count(), 0.f);
  for (int k = 0; k < ras.grid.size[2]; ++k)
    for (int j = 0; j < ras.grid.size[1]; ++j)
      std::copy_n(&ras.voxels[ras.grid.index(0, j, k)], ras.grid.size[0],
                  &out.voxels[out.grid.index(kPad, j + kPad, k + kPad)]);
  return out;
}

/// Gaussian-like (1 2 1) / 4 along each axis.
Cells smoothed(const volume::VoxelGrid& grid, const Cells& in) {
  Cells a = in, b(in.size());
  const std::size_t strides[3] = {1, std::size_t(grid.size[0]), std::size_t(grid.size[0]) * grid.size[1]};
  for (const std::size_t stride : strides) {
    b = a;
    for (std::size_t i = stride; i + stride < a.size(); ++i)
      b[i] = 0.25f * a[i - stride] + 0.5f * a[i] + 0.25f * a[i + stride];
    a.swap(b);
  }
  return a;
}

/// Otsu's threshold of the values.
float otsu(const Cells& values) {
  const float top = *std::max_element(values.begin(), values.end());
  if (!(top > 0.f)) return 1.f;
  std::vector<double> histogram(256, 0.0);
  for (const float value : values) ++histogram[std::clamp(int(255.f * value / top), 0, 255)];
  double total = 0.0, sum = 0.0;
  for (int i = 0; i < 256; ++i) total += histogram[i], sum += i * histogram[i];
  double below = 0.0, sum_below = 0.0, best = -1.0;
  int at = 0;
  for (int i = 0; i < 255; ++i) {
    below += histogram[i], sum_below += i * histogram[i];
    if (below == 0.0 || below == total) continue;
    const double gap = sum_below / below - (sum - sum_below) / (total - below);
    const double between = below * (total - below) * gap * gap;
    if (between > best) best = between, at = i;
  }
  return top * float(at + 1) / 256.f;
}

using Flags = std::vector<std::uint8_t>;

/// Voxels reachable from `seeds` through voxels whose flag equals `through`.
Flags flood(const volume::VoxelGrid& grid, const Flags& flags, std::uint8_t through,
            std::vector<std::size_t> seeds) {
  Flags reached(flags.size(), 0);
  const long strides[3] = {1, grid.size[0], long(grid.size[0]) * grid.size[1]};
  for (const auto seed : seeds) reached[seed] = 1;
  while (!seeds.empty()) {
    const std::size_t at = seeds.back();
    seeds.pop_back();
    for (const long stride : strides)
      for (const long step : {-stride, stride}) {
        const long next = long(at) + step;
        if (next < 0 || next >= long(flags.size()) || reached[next] || flags[next] != through) continue;
        reached[next] = 1;
        seeds.push_back(std::size_t(next));
      }
  }
  return reached;
}

/// The 6-connected component with the most voxels.
Flags largestPiece(const volume::VoxelGrid& grid, Flags flags) {
  Flags best;
  std::size_t most = 0;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (!flags[i]) continue;
    Flags piece = flood(grid, flags, 1, {i});
    std::size_t count = 0;
    for (std::size_t j = 0; j < flags.size(); ++j)
      if (piece[j]) flags[j] = 0, ++count;
    if (count > most) most = count, best = std::move(piece);
    if (most * 2 > std::size_t(std::count(flags.begin(), flags.end(), 1)) + most) break;
  }
  return best;
}

/// Box dilation by `radius` voxels of the flags equal to 1.
Flags dilated(const volume::VoxelGrid& grid, const Flags& in, int radius) {
  Flags a = in, b(in.size());
  const std::size_t strides[3] = {1, std::size_t(grid.size[0]), std::size_t(grid.size[0]) * grid.size[1]};
  for (const std::size_t stride : strides)
    for (int step = 0; step < radius; ++step) {
      b = a;
      for (std::size_t i = stride; i + stride < a.size(); ++i) b[i] = a[i - stride] | a[i] | a[i + stride];
      a.swap(b);
    }
  return a;
}

Flags inverted(Flags flags) {
  for (auto& flag : flags) flag = !flag;
  return flags;
}

/// Fills inner air of the head: closes sinuses, throat and ear canals (openings up to twice `kClosing`
/// voxels).
Flags solidHead(const volume::VoxelGrid& grid, const Cells& values, float threshold) {
  Flags tissue(values.size());
  std::transform(values.begin(), values.end(), tissue.begin(),
                 [&](float v) { return std::uint8_t(v > threshold); });
  tissue = largestPiece(grid, std::move(tissue));
  if (tissue.empty()) return Flags(values.size(), 0);
  const Flags sealed = dilated(grid, tissue, kClosing);
  const Flags outside = flood(grid, sealed, 0, {0});
  // Solid: voxels inside the closed skin and deeper than the closing reached, plus the tissue itself.
  Flags solid = inverted(dilated(grid, outside, kClosing + 1));
  for (std::size_t i = 0; i < solid.size(); ++i) solid[i] = solid[i] || tissue[i];
  const Flags air = flood(grid, solid, 0, {0});
  return inverted(air);
}

vtkSmartPointer<vtkPolyData> isoSurface(const volume::VoxelGrid& grid, const Cells& field, float level) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.size[0], grid.size[1], grid.size[2]);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(field.begin(), field.end(), static_cast<float*>(image->GetScalarPointer()));
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, level);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputConnection(edges->GetOutputPort());
  largest->SetExtractionModeToLargestRegion();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(largest->GetOutputPort());
  smooth->SetNumberOfIterations(12);
  smooth->SetPassBand(0.15);
  smooth->NormalizeCoordinatesOn();
  smooth->Update();
  return smooth->GetOutput();
}

surface::TriangleMesh toMesh(vtkPolyData& poly, const volume::VoxelGrid& grid) {
  surface::TriangleMesh mesh;
  std::vector<int> number(std::size_t(poly.GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < poly.GetNumberOfCells(); ++cell) {
    poly.GetCellPoints(cell, corners);
    Eigen::Vector3i triangle;
    for (int corner = 0; corner < 3; ++corner) {
      int& n = number[std::size_t(corners->GetId(corner))];
      if (n < 0) {
        n = int(mesh.vertices_mm.size());
        mesh.vertices_mm.push_back(grid.toMri(Eigen::Vector3d(poly.GetPoint(corners->GetId(corner)))).mm);
      }
      triangle[corner] = n;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

double signedVolume(const surface::TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += mesh.vertices_mm[t[0]].dot(mesh.vertices_mm[t[1]].cross(mesh.vertices_mm[t[2]])) / 6.0;
  return sum;
}

void faceOutwards(surface::TriangleMesh& mesh) {
  if (signedVolume(mesh) > 0.0) return;
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

/// Offset (mm, along the normal) of the air/skin edge within reach of the vertex: the outermost position with
/// a steep fall of intensity. The steepest position is not used: if the dermis is dark, the edge of the fat
/// 2-4 mm below it is steeper than the skin's edge, and a surface that jumps to it has dents.
double edgeOffset(const volume::Volume& field, const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal) {
  constexpr double kReach_mm = 2.0, kApart_mm = 0.125;
  constexpr int kSteps = int(2 * kReach_mm / kApart_mm);
  double values[kSteps + 1];
  for (int i = 0; i <= kSteps; ++i)
    values[i] = volume::sampleLinear(
        field, field.grid.toVoxel(Point<Mri>(p_mm + (i * kApart_mm - kReach_mm) * normal)));
  double falls[kSteps + 1] = {}, steepest = 0.0;
  const auto offsetAt = [](double i) { return i * kApart_mm - kReach_mm; };
  for (int i = 4; i + 4 <= kSteps; ++i) {
    falls[i] = (values[i - 4] - values[i + 4]) * std::exp(-0.125 * offsetAt(i) * offsetAt(i));
    steepest = std::max(steepest, falls[i]);
  }
  for (int i = kSteps - 5; i >= 5; --i) {
    const bool is_peak = falls[i] > 0.0 && falls[i] >= falls[i + 1] && falls[i] > falls[i - 1];
    if (!is_peak || falls[i] < kOwnEdge * steepest) continue;
    const double bend = falls[i - 1] - 2.0 * falls[i] + falls[i + 1];
    return offsetAt(i + (bend < 0.0 ? 0.5 * (falls[i - 1] - falls[i + 1]) / bend : 0.0));
  }
  return 0.0;
}

std::vector<double> averagedOverNeighbours(const std::vector<double>& values,
                                           const std::vector<Eigen::Vector3i>& triangles, int rounds) {
  std::vector<double> now = values;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> sum = now, weight(now.size(), 1.0);
    for (const auto& t : triangles)
      for (int c = 0; c < 3; ++c) sum[t[c]] += now[t[(c + 1) % 3]], weight[t[c]] += 1.0;
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = sum[i] / weight[i];
  }
  return now;
}

void settleOnEdge(surface::TriangleMesh& mesh, const volume::Volume& field) {
  std::vector<double> offset(mesh.vertices_mm.size());
  for (std::size_t i = 0; i < offset.size(); ++i)
    offset[i] = edgeOffset(field, mesh.vertices_mm[i], mesh.normals[i]);
  offset = averagedOverNeighbours(offset, mesh.triangles, 6);
  for (std::size_t i = 0; i < offset.size(); ++i) mesh.vertices_mm[i] += offset[i] * mesh.normals[i];
  mesh.normals = vertexNormals(mesh.vertices_mm, mesh.triangles);
}

}  // namespace

std::vector<Eigen::Vector3d> vertexNormals(const std::vector<Eigen::Vector3d>& vertices_mm,
                                           const std::vector<Eigen::Vector3i>& triangles) {
  std::vector<Eigen::Vector3d> normals(vertices_mm.size(), Eigen::Vector3d::Zero());
  for (const auto& t : triangles) {
    const Eigen::Vector3d& a = vertices_mm[t[0]];
    const Eigen::Vector3d facet = (vertices_mm[t[1]] - a).cross(vertices_mm[t[2]] - a);
    for (int corner = 0; corner < 3; ++corner) normals[t[corner]] += facet;
  }
  for (auto& normal : normals) normal.normalize();
  return normals;
}

surface::TriangleMesh makeSkinMesh(const volume::Volume& input, TaskMonitor& monitor) {
  monitor.report("virtual patient: skin", 0.0);
  const volume::Volume scan = padded(input);
  Cells field = smoothed(scan.grid, scan.voxels);
  volume::Volume smooth_scan{scan.grid, field, scan.modality, scan.orientation_source};
  const float threshold =
      0.50037f * otsu(field);  // never equal to a voxel's value, which would give degenerate triangles
  const Flags solid = solidHead(scan.grid, field, threshold);
  const double volume_ml =
      std::accumulate(solid.begin(), solid.end(), 0.0) * scan.grid.voxelVolume_mm3() / 1000.0;
  if (!anatomy::kWholeHead.contains(volume_ml))
    throw Error("no head in the volume", "", "give a T1 scan of a whole head");
  monitor.report("virtual patient: skin", 0.4);
  // Raises the field above the level deep inside, so that only the outermost surface remains.
  const Flags near_air = dilated(scan.grid, inverted(solid), 1);
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (!near_air[i]) field[i] = std::max(field[i], 2.f * threshold);
    if (!solid[i]) field[i] = std::min(field[i], 0.98f * threshold);
  }
  auto mesh = toMesh(*isoSurface(scan.grid, field, threshold), scan.grid);
  faceOutwards(mesh);
  mesh.normals = vertexNormals(mesh.vertices_mm, mesh.triangles);
  monitor.report("virtual patient: skin", 0.8);
  // Twice: the first surface is at a low level, outside the edge, and its normals belong to that level.
  for (int round = 0; round < 2; ++round) settleOnEdge(mesh, smooth_scan);
  monitor.report("virtual patient: skin", 1.0);
  return mesh;
}

}  // namespace facenav::room
