#include <vtkCellArray.h>
#include <vtkConeSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTubeFilter.h>

#include "actors.h"
#include "image_bridge.h"

namespace facenav::scene {
namespace {

constexpr double kAxisAbove_mm = 35.0, kAxisBelow_mm = 45.0;  // visible part of the coil's z axis

vtkSmartPointer<vtkPolyData> segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius_mm) {
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(a.data());
  points->InsertNextPoint(b.data());
  vtkNew<vtkCellArray> lines;
  const vtkIdType ids[2] = {0, 1};
  lines->InsertNextCell(2, ids);
  vtkNew<vtkPolyData> line;
  line->SetPoints(points);
  line->SetLines(lines);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(line);
  tube->SetRadius(radius_mm);
  tube->SetNumberOfSides(16);
  tube->CappingOn();
  tube->Update();
  return tube->GetOutput();
}

vtkSmartPointer<vtkPolyData> ring(double radius_mm, double thickness_mm) {
  vtkNew<vtkRegularPolygonSource> circle;
  circle->SetNumberOfSides(72);
  circle->SetRadius(radius_mm);
  circle->GeneratePolygonOff();
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(circle->GetOutputPort());
  tube->SetRadius(thickness_mm);
  tube->SetNumberOfSides(12);
  tube->Update();
  return tube->GetOutput();
}

vtkSmartPointer<vtkActor> glowing(vtkPolyData* poly, const palette::Rgb& colour, double opacity = 1.0) {
  auto actor = makeActor(poly, colour);
  actor->GetProperty()->SetAmbient(0.55);
  actor->GetProperty()->SetDiffuse(0.5);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

}  // namespace

CoilActors makeCoilActors(const CoilShape& shape) {
  CoilActors actors;
  actors.body = makeActor(toPolyData(shape.body), palette::kCoil);
  actors.body->GetProperty()->SetOpacity(shape.windings.triangles.empty() ? 0.70 : 0.30);
  actors.body->GetProperty()->SetSpecular(0.3);
  actors.body->GetProperty()->SetSpecularPower(30);
  actors.body->GetProperty()->BackfaceCullingOn();
  actors.windings = makeActor(toPolyData(shape.windings), {0.80, 0.48, 0.27});
  actors.windings->GetProperty()->SetOpacity(0.62);  // keeps the target below visible
  actors.windings->GetProperty()->BackfaceCullingOn();
  actors.windings->GetProperty()->SetSpecular(0.35);
  actors.windings->GetProperty()->SetSpecularPower(25);
  auto line = segment({0, 0, -kAxisAbove_mm}, {0, 0, kAxisBelow_mm}, 0.9);
  actors.axis = glowing(line, palette::kBlue);
  actors.axis_on_top = glowing(line, palette::kBlue, 0.55);
  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0, 0, 1);
  cone->SetCenter(0, 0, kAxisBelow_mm);
  cone->SetHeight(8);
  cone->SetRadius(2.6);
  cone->SetResolution(24);
  cone->Update();
  actors.tip = glowing(cone->GetOutput(), palette::kBlue, 0.85);
  return actors;
}

void CoilActors::setTransform(vtkLinearTransform* coil) {
  for (vtkActor* actor : all()) actor->SetUserTransform(coil);
}

void CoilActors::addTo(vtkRenderer* renderer, vtkRenderer* on_top) const {
  for (vtkActor* actor : {body.Get(), windings.Get(), axis.Get()}) renderer->AddActor(actor);
  for (vtkActor* actor : {axis_on_top.Get(), tip.Get()}) on_top->AddActor(actor);
}

void CoilActors::removeFrom(vtkRenderer* renderer, vtkRenderer* on_top) const {
  for (vtkActor* actor : all()) {
    renderer->RemoveActor(actor);
    on_top->RemoveActor(actor);
  }
}

void CoilActors::setVisible(bool is_visible, bool is_axis_visible) {
  body->SetVisibility(is_visible);
  windings->SetVisibility(is_visible);
  for (vtkActor* actor : {axis.Get(), axis_on_top.Get(), tip.Get()})
    actor->SetVisibility(is_visible && is_axis_visible);
}

TargetActors makeTargetActors(const guidance::Target& target, bool is_active) {
  const Eigen::Vector3d centre = target.mri_T_target.translation_mm();
  const Eigen::Vector3d z = target.mri_T_target.rotation().col(2);
  vtkNew<vtkTransform> place;
  const Eigen::Matrix4d m = target.mri_T_target.matrix();
  double elements[16];
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) elements[4 * r + c] = m(r, c);
  place->SetMatrix(elements);
  const palette::Rgb colour = is_active ? palette::kOrange : palette::kMuted;
  TargetActors actors;
  auto placedRing = ring(is_active ? 9.0 : 5.0, is_active ? 1.1 : 0.7);
  for (vtkIdType i = 0; i < placedRing->GetNumberOfPoints(); ++i) {
    double p[3];
    place->TransformPoint(placedRing->GetPoint(i), p);
    placedRing->GetPoints()->SetPoint(i, p);
  }
  actors.ring = glowing(placedRing, colour);
  actors.ring_on_top = glowing(placedRing, colour, 0.35);
  actors.line = glowing(segment(centre - 14.0 * z, target.cortex_point.mm, 0.5), colour, 0.8);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(is_active ? 2.4 : 1.6);
  ball->SetCenter(target.cortex_point.mm.x(), target.cortex_point.mm.y(), target.cortex_point.mm.z());
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  ball->Update();
  actors.cortex = glowing(ball->GetOutput(), colour, 0.95);
  return actors;
}

}  // namespace facenav::scene
