#include "facenav/scene/overlay_layer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace facenav::scene {
namespace {

constexpr double kOverBrain_mm = 0.5;  // keeps it visible over the brain below

unsigned char byteOf(double share) { return (unsigned char)std::lround(255 * share); }

/// Points of one actor with a colour each.
struct OverlayPoints {
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkUnsignedCharArray> colours;
  OverlayPoints() {
    normals->SetNumberOfComponents(3);
    colours->SetNumberOfComponents(4);
  }
  vtkIdType add(const Eigen::Vector3d& p_mm, const palette::Rgb& colour, double opacity) {
    const unsigned char bytes[4] = {byteOf(colour[0]), byteOf(colour[1]), byteOf(colour[2]), byteOf(opacity)};
    colours->InsertNextTypedTuple(bytes);
    return points->InsertNextPoint(p_mm.data());
  }
};

vtkSmartPointer<vtkActor> overlayActor(OverlayPoints& points, vtkCellArray* lines, vtkCellArray* triangles) {
  vtkNew<vtkPolyData> poly;
  poly->SetPoints(points.points);
  poly->GetPointData()->SetScalars(points.colours);
  if (points.normals->GetNumberOfTuples() == points.points->GetNumberOfPoints())
    poly->GetPointData()->SetNormals(points.normals);
  if (lines) poly->SetLines(lines);
  if (triangles) poly->SetPolys(triangles);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(poly);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->GetProperty()->SetAmbient(0.45);
  actor->GetProperty()->SetDiffuse(0.6);
  if (lines) actor->GetProperty()->LightingOff();
  return actor;
}

/// Makes the part of the brain's surface under which the map reaches its threshold.
vtkSmartPointer<vtkActor> mapActor(const Overlay& overlay, const surface::TriangleMesh& brain) {
  const bool is_mask = overlay.mask != nullptr;
  const auto values = valuesUnder(brain, is_mask ? *overlay.mask : *overlay.map);
  const double least = is_mask ? 0.5 : overlay.threshold;
  const auto isShown = [&](int vertex) {
    const float value = values[std::size_t(vertex)];
    return value != 0 && std::abs(value) >= least;
  };
  OverlayPoints points;
  for (std::size_t i = 0; i < brain.vertices_mm.size(); ++i) {
    points.add(brain.vertices_mm[i] + kOverBrain_mm * brain.normals[i],
               is_mask ? overlay.colour : mapColour(values[i], overlay.threshold, overlay.full),
               overlay.opacity);
    points.normals->InsertNextTuple(brain.normals[i].data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : brain.triangles)
    if (isShown(t[0]) && isShown(t[1]) && isShown(t[2])) triangles->InsertNextCell({t[0], t[1], t[2]});
  return overlayActor(points, nullptr, triangles);
}

vtkSmartPointer<vtkActor> tractActor(const Overlay& overlay) {
  const auto& tracts = overlay.tracts->tracts;
  const std::size_t step = (tracts.lines() + kMostLinesIn3d - 1) / kMostLinesIn3d;
  OverlayPoints points;
  vtkNew<vtkCellArray> lines;
  for (std::size_t i = 0; i < tracts.lines(); i += step) {
    const std::size_t begin = tracts.begin(i), end = tracts.ends[i];
    if (end < begin + 2) continue;
    lines->InsertNextCell(int(end - begin));
    for (std::size_t p = begin; p < end; ++p) {
      const Eigen::Vector3f along =
          tracts.points_mm[std::min(p + 1, end - 1)] - tracts.points_mm[p > begin ? p - 1 : p];
      lines->InsertCellPoint(
          points.add(tracts.points_mm[p].cast<double>(), directionColour(along), overlay.opacity));
    }
  }
  return overlayActor(points, lines, nullptr);
}

vtkSmartPointer<vtkActor> meshActor(const Overlay& overlay) {
  OverlayPoints points;
  for (std::size_t i = 0; i < overlay.mesh->vertices_mm.size(); ++i) {
    points.add(overlay.mesh->vertices_mm[i], overlay.colour, overlay.opacity);
    points.normals->InsertNextTuple(overlay.mesh->normals[i].data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : overlay.mesh->triangles) triangles->InsertNextCell({t[0], t[1], t[2]});
  return overlayActor(points, nullptr, triangles);
}

}  // namespace

struct OverlayLayer::Implementation {
  vtkRenderer* renderer;
  std::vector<vtkSmartPointer<vtkActor>> actors;
  void clear() {
    for (const auto& actor : actors) renderer->RemoveActor(actor);
    actors.clear();
  }
};

OverlayLayer::OverlayLayer(NavigationScene& scene)
    : implementation_(std::make_unique<Implementation>(Implementation{scene.renderer(), {}})) {}

OverlayLayer::~OverlayLayer() { implementation_->clear(); }

void OverlayLayer::set(const std::vector<Overlay>& overlays, const surface::TriangleMesh* brain) {
  auto& layer = *implementation_;
  layer.clear();
  for (const Overlay& overlay : overlays) {
    vtkSmartPointer<vtkActor> actor;
    if ((overlay.map || overlay.mask) && brain) actor = mapActor(overlay, *brain);
    if (overlay.tracts) actor = tractActor(overlay);
    if (overlay.mesh) actor = meshActor(overlay);
    if (!actor) continue;
    layer.renderer->AddActor(actor);
    layer.actors.push_back(actor);
  }
}

}  // namespace facenav::scene
