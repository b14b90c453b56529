#include "facenav/scene/pulse_layer.h"

#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkGlyph3D.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>

#include "actors.h"

namespace facenav::scene {
namespace {

constexpr double kBall_mm = 1.3, kRim_mm = 2.8, kChosen_mm = 2.2, kExcluded_mm = 1.2, kHandle_mm = 7.0;
constexpr double kAboveBrain_mm = 0.4;  // keeps the heat map visible over the brain below
constexpr int kBallFacets = 8;

/// Points with a colour each, drawn with one glyph.
struct ColouredPoints {
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colours;
  ColouredPoints() { colours->SetNumberOfComponents(3); }
  void add(const Eigen::Vector3d& p_mm, const palette::Rgb& colour) {
    points->InsertNextPoint(p_mm.data());
    unsigned char bytes[3];
    for (int c = 0; c < 3; ++c) bytes[c] = (unsigned char)std::lround(255 * colour[std::size_t(c)]);
    colours->InsertNextTypedTuple(bytes);
  }
  bool isEmpty() const { return points->GetNumberOfPoints() == 0; }
  vtkSmartPointer<vtkPolyData> toPoly() const {
    auto poly = vtkSmartPointer<vtkPolyData>::New();
    poly->SetPoints(points);
    poly->GetPointData()->SetScalars(colours);
    return poly;
  }
};

vtkSmartPointer<vtkActor> colouredActor(vtkPolyData* poly) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(poly);
  mapper->ScalarVisibilityOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.45);
  actor->GetProperty()->SetDiffuse(0.6);
  return actor;
}

vtkSmartPointer<vtkActor> glyphs(const ColouredPoints& points, vtkPolyDataAlgorithm* shape) {
  vtkNew<vtkGlyph3D> glyph;
  glyph->SetInputData(points.toPoly());
  glyph->SetSourceConnection(shape->GetOutputPort());
  glyph->ScalingOff();
  glyph->SetColorModeToColorByScalar();
  glyph->Update();
  return colouredActor(glyph->GetOutput());
}

vtkSmartPointer<vtkSphereSource> ball(double radius_mm) {
  auto source = vtkSmartPointer<vtkSphereSource>::New();
  source->SetRadius(radius_mm);
  source->SetThetaResolution(kBallFacets);
  source->SetPhiResolution(kBallFacets);
  return source;
}

/// Makes the strokes from each coil's centre towards its handle.
vtkSmartPointer<vtkActor> handles(const std::vector<PulseMark>& marks) {
  ColouredPoints ends;
  vtkNew<vtkCellArray> lines;
  for (const PulseMark& mark : marks) {
    if (mark.is_excluded) continue;
    const Eigen::Vector3d centre_mm = mark.mri_T_coil.translation_mm();
    const vtkIdType first = ends.points->GetNumberOfPoints();
    ends.add(centre_mm, mark.colour);
    ends.add(centre_mm - kHandle_mm * mark.mri_T_coil.rotation().col(1), mark.colour);
    lines->InsertNextCell({first, first + 1});
  }
  auto poly = ends.toPoly();
  poly->SetLines(lines);
  auto actor = colouredActor(poly);
  actor->GetProperty()->SetLineWidth(1.5f);
  actor->GetProperty()->LightingOff();
  return actor;
}

}  // namespace

struct PulseLayer::Implementation {
  vtkRenderer* renderer;
  std::vector<vtkSmartPointer<vtkActor>> marks;
  vtkSmartPointer<vtkActor> heat;
  void removeMarks() {
    for (const auto& actor : marks) renderer->RemoveActor(actor);
    marks.clear();
  }
  void add(vtkSmartPointer<vtkActor> actor) {
    actor->PickableOff();
    renderer->AddActor(actor);
    marks.push_back(std::move(actor));
  }
};

PulseLayer::PulseLayer(NavigationScene& scene)
    : implementation_(std::make_unique<Implementation>(Implementation{scene.renderer(), {}, {}})) {}

PulseLayer::~PulseLayer() {
  implementation_->removeMarks();
  clearHeat();
}

void PulseLayer::set(const std::vector<PulseMark>& marks) {
  auto& layer = *implementation_;
  layer.removeMarks();
  if (marks.empty()) return;
  ColouredPoints counted, chosen, rims, excluded;
  for (const PulseMark& mark : marks) {
    std::vector<Eigen::Vector3d> places_mm{mark.mri_T_coil.translation_mm()};
    if (mark.on_cortex) places_mm.push_back(mark.on_cortex->mm);
    for (const auto& p_mm : places_mm) {
      if (mark.is_chosen) rims.add(p_mm, {1, 1, 1});
      ColouredPoints& points = mark.is_excluded ? excluded : mark.is_chosen ? chosen : counted;
      points.add(p_mm, mark.is_excluded ? palette::kLost : mark.colour);
    }
  }
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(kExcluded_mm);
  cube->SetYLength(kExcluded_mm);
  cube->SetZLength(kExcluded_mm);
  if (!counted.isEmpty()) layer.add(glyphs(counted, ball(kBall_mm)));
  if (!excluded.isEmpty()) layer.add(glyphs(excluded, cube));
  if (!chosen.isEmpty()) layer.add(glyphs(chosen, ball(kChosen_mm)));
  if (!rims.isEmpty()) {
    auto rim = glyphs(rims, ball(kRim_mm));
    rim->GetProperty()->FrontfaceCullingOn();  // only the far side: a rim around the ball in front of it
    rim->GetProperty()->LightingOff();
    layer.add(rim);
  }
  layer.add(handles(marks));
}

void PulseLayer::setHeat(const surface::TriangleMesh& surface, const std::vector<float>& values,
                         const ColourRange& range) {
  clearHeat();
  ColouredPoints vertices;
  for (std::size_t i = 0; i < surface.vertices_mm.size(); ++i)
    vertices.add(surface.vertices_mm[i] + kAboveBrain_mm * surface.normals[i],
                 std::isnan(values[i]) ? palette::kLost : sequentialColour(range.shareOf(values[i])));
  vtkNew<vtkCellArray> triangles;
  for (const Eigen::Vector3i& t : surface.triangles) {
    const std::array<vtkIdType, 3> corners{t[0], t[1], t[2]};
    bool is_whole = true;
    for (const vtkIdType corner : corners) is_whole &= !std::isnan(values[std::size_t(corner)]);
    if (is_whole) triangles->InsertNextCell(3, corners.data());
  }
  auto poly = vertices.toPoly();
  poly->SetPolys(triangles);
  implementation_->heat = colouredActor(poly);
  implementation_->heat->PickableOff();
  implementation_->renderer->AddActor(implementation_->heat);
}

void PulseLayer::clearHeat() {
  auto& layer = *implementation_;
  if (layer.heat) layer.renderer->RemoveActor(layer.heat);
  layer.heat = nullptr;
}

}  // namespace facenav::scene
