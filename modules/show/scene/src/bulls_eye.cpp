#include "facenav/scene/bulls_eye.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDiskSource.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "actors.h"
#include "facenav/geometry/rotation.h"
#include "facenav/scene/palette.h"
#include "image_bridge.h"

namespace facenav::scene {
namespace {

constexpr double kEdge_mm = 20.0, kHalfHeight_mm = 1.18 * kEdge_mm;
constexpr double kStroke_mm_per_deg = 1.0;

vtkSmartPointer<vtkActor> disk(double inner, double outer, double opacity, double depth) {
  vtkNew<vtkDiskSource> source;
  source->SetInnerRadius(inner);
  source->SetOuterRadius(outer);
  source->SetCircumferentialResolution(128);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(0, 0, depth);
  actor->GetProperty()->SetOpacity(opacity);
  actor->GetProperty()->LightingOff();
  return actor;
}

/// Makes a bar from (0,0) along +x, length 1, width 1; scaled and rotated per frame.
vtkSmartPointer<vtkActor> bar(double depth) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(makeRectangle({0, -0.5}, {1, 0.5}));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(0, 0, depth);
  actor->GetProperty()->LightingOff();
  return actor;
}

void placeBar(vtkActor* actor, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
              double depth) {
  const Eigen::Vector2d d = to - from;
  actor->SetScale(std::max(1e-3, d.norm()), width, 1);
  actor->SetOrientation(0, 0, std::atan2(d.y(), d.x()) * kDegPerRad);
  actor->SetPosition(from.x(), from.y(), depth);
}

void colourAll(std::initializer_list<vtkActor*> actors, const palette::Rgb& colour) {
  for (vtkActor* actor : actors) actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

}  // namespace

struct BullsEye::Implementation {
  vtkNew<vtkRenderer> renderer;
  DialColours colours;
  vtkSmartPointer<vtkActor> dial, zone, rim, centre, coil_ring, stroke, stroke_end, twist;
  std::array<vtkSmartPointer<vtkActor>, 3> rings;
  bool has_values = false, is_on_target = false;
  std::array<vtkSmartPointer<vtkActor>, 4> cross;
  vtkSmartPointer<vtkRenderWindow> offscreen;

  Implementation();
  void place(const guidance::GuidanceValues& values);
  void colour();
};

BullsEye::Implementation::Implementation() {
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(kHalfHeight_mm);
  camera->SetPosition(0, 0, 100);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetClippingRange(1, 200);
  renderer->InteractiveOff();
  dial = disk(0, kEdge_mm, 1.0, 0);
  renderer->AddActor(dial);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const double radius = 5.0 * double(i + 1);
    rings[i] = disk(radius - 0.08, radius + 0.08, 1.0, 0.1);
    renderer->AddActor(rings[i]);
  }
  rim = disk(kEdge_mm - 0.35, kEdge_mm, 1.0, 0.2);
  zone = disk(0, 2.0, 0.30, 0.3);
  centre = disk(0, 0.55, 1.0, 0.4);
  coil_ring = disk(2.6, 3.3, 1.0, 1.0);
  stroke = bar(0.9);
  stroke_end = disk(0, 0.75, 1.0, 0.95);
  twist = bar(0.8);
  for (auto& arm : cross) arm = bar(1.0);
  for (vtkActor* actor :
       {rim.Get(), zone.Get(), centre.Get(), coil_ring.Get(), stroke.Get(), stroke_end.Get(), twist.Get()})
    renderer->AddActor(actor);
  for (auto& arm : cross) renderer->AddActor(arm);
}

void BullsEye::Implementation::colour() {
  renderer->SetBackground(colours.around[0], colours.around[1], colours.around[2]);
  colourAll({dial}, colours.dial);
  for (auto& ring : rings) colourAll({ring}, colours.lines);
  colourAll({coil_ring, stroke, stroke_end, twist}, colours.coil);
  for (auto& arm : cross) colourAll({arm}, colours.coil);
  colourAll({zone, centre, rim}, !has_values    ? colours.lines
                                 : is_on_target ? colours.on_target
                                                : colours.adjust);
}

void BullsEye::Implementation::place(const guidance::GuidanceValues& values) {
  const auto toScreen = [](double coil_x, double coil_y) { return Eigen::Vector2d(-coil_x, coil_y); };
  Eigen::Vector2d at = toScreen(-values.lateral_in_coil_mm.x(), -values.lateral_in_coil_mm.y());
  const double reach = at.norm();
  if (reach > kEdge_mm) at *= kEdge_mm / reach;
  coil_ring->SetPosition(at.x(), at.y(), 1.0);
  const Eigen::Vector2d arms[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int i = 0; i < 4; ++i) placeBar(cross[i], at + 1.0 * arms[i], at + 4.4 * arms[i], 0.45, 1.0);
  // The rotation (rx, ry) that would align z moves z by r x z = (ry, -rx), so the coil's z is now offset in
  // the opposite direction.
  const Eigen::Vector2d tilt_deg = values.tilt_in_coil_rad * kDegPerRad;
  Eigen::Vector2d lean = toScreen(-tilt_deg.y(), tilt_deg.x()) * kStroke_mm_per_deg;
  if (lean.norm() > kEdge_mm) lean *= kEdge_mm / lean.norm();
  placeBar(stroke, at, at + lean, 0.6, 0.9);
  stroke_end->SetPosition(at.x() + lean.x(), at.y() + lean.y(), 0.95);
  // A positive rotation about z appears clockwise, because the view is along +z.
  const double angle = M_PI / 2 - values.twist_rad;
  const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
  placeBar(twist, ray * (kEdge_mm - 2.6), ray * (kEdge_mm + 1.6), 1.1, 0.8);
}

BullsEye::BullsEye() : implementation_(std::make_unique<Implementation>()) { set({}); }
BullsEye::~BullsEye() = default;

void BullsEye::setColours(const DialColours& colours) {
  implementation_->colours = colours;
  implementation_->colour();
}

void BullsEye::setTolerance(const guidance::Tolerance& tolerance) {
  implementation_->zone->SetScale(tolerance.lateral_mm / 2.0, tolerance.lateral_mm / 2.0, 1.0);
}

void BullsEye::set(const guidance::GuidanceState& guidance) {
  auto& b = *implementation_;
  b.has_values = guidance.values.has_value() && guidance.state != guidance::State::lost;
  b.is_on_target = guidance.state == guidance::State::on_target;
  for (vtkActor* actor : {b.coil_ring.Get(), b.stroke.Get(), b.stroke_end.Get(), b.twist.Get()})
    actor->SetVisibility(b.has_values);
  for (auto& arm : b.cross) arm->SetVisibility(b.has_values);
  b.colour();
  if (b.has_values) b.place(*guidance.values);
}

void BullsEye::fit(int width_px, int height_px) {
  const double narrowness = double(std::max(1, height_px)) / std::max(1, width_px);
  implementation_->renderer->GetActiveCamera()->SetParallelScale(kHalfHeight_mm * std::max(1.0, narrowness));
}

vtkRenderer* BullsEye::renderer() const { return implementation_->renderer; }

RgbImage BullsEye::render(int width_px, int height_px) {
  auto& b = *implementation_;
  if (!b.offscreen) {
    b.offscreen = vtkSmartPointer<vtkRenderWindow>::New();
    b.offscreen->SetOffScreenRendering(1);
    b.offscreen->SetMultiSamples(4);
    b.offscreen->AddRenderer(b.renderer);
  }
  fit(width_px, height_px);
  b.offscreen->SetSize(width_px, height_px);
  return grab(b.offscreen);
}

}  // namespace facenav::scene
