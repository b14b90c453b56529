#include "facenav/display/navigation_display.h"

#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkImageMapper3D.h>
#include <vtkImageProperty.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "actors.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"
#include "facenav/scene/bulls_eye.h"
#include "facenav/scene/palette.h"
#include "image_bridge.h"

namespace facenav::display {
namespace palette = scene::palette;
namespace {

/// Removes the sign of a number that is rounded to zero.
std::string withoutSideOfZero(std::string number) {
  const bool is_zero = number.find_first_of("123456789") == std::string::npos;
  if (is_zero && (number[0] == '-' || number[0] == '+')) number.erase(0, 1);
  return number;
}

double degrees(double rad) { return rad * kDegPerRad; }

/// A camera image fitted into its viewport, aspect ratio kept.
struct CameraPanel {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkImageData> image;
  vtkNew<vtkImageActor> actor;

  CameraPanel() {
    renderer->SetBackground(palette::kBackground.data());
    renderer->GetActiveCamera()->ParallelProjectionOn();
    renderer->InteractiveOff();
    actor->GetProperty()->SetInterpolationTypeToLinear();
  }
  void set(const RgbImage& picture, double aspect) {
    if (picture.empty()) return;
    scene::copyInto(picture, image);
    if (!renderer->HasViewProp(actor)) {
      actor->SetInputData(image);
      renderer->AddActor(actor);
    }
    const double w = picture.width_px, h = picture.height_px;
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetFocalPoint(0.5 * (w - 1), 0.5 * (h - 1), 0);
    camera->SetPosition(0.5 * (w - 1), 0.5 * (h - 1), 100);
    camera->SetParallelScale(0.5 * std::max(h, w / aspect));
    camera->SetClippingRange(1, 200);
  }
};

}  // namespace

struct NavigationDisplay::Implementation {
  scene::NavigationScene& scene;
  int width, height;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> page;  // bars, panels and text, in pixels, behind and beside the views
  CameraPanel left, right;
  scene::BullsEye bulls_eye;
  int bar, side, bottom;
  vtkSmartPointer<vtkTextActor> title, head, coil, timing, instruction;
  vtkSmartPointer<vtkActor2D> head_dot, coil_dot, banner;
  struct Figure {
    vtkSmartPointer<vtkTextActor> value, unit, name;
  };
  std::array<Figure, 4> figures;

  Implementation(scene::NavigationScene& s, int w, int h);
  vtkSmartPointer<vtkTextActor> text(double x, double y, int size, const palette::Rgb& colour,
                                     bool is_bold = false);
  vtkSmartPointer<vtkActor2D> box(double x, double y, double w, double h, const palette::Rgb& colour);
  void viewport(vtkRenderer* renderer, double x, double y, double w, double h);
  void layOut();
  void setFigure(Figure& figure, const std::string& value, const std::string& unit);
  void setStatus(vtkTextActor* words, vtkActor2D* dot, const StatusWords& status);
  void setGuidance(const guidance::GuidanceState& guidance);
};

vtkSmartPointer<vtkTextActor> NavigationDisplay::Implementation::text(double x, double y, int size,
                                                                      const palette::Rgb& colour,
                                                                      bool is_bold) {
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetPosition(x, y);
  auto* property = actor->GetTextProperty();
  property->SetFontSize(size * height / 720);
  property->SetColor(colour[0], colour[1], colour[2]);
  property->SetBold(is_bold);
  property->SetVerticalJustificationToCentered();
  page->AddActor2D(actor);
  return actor;
}

vtkSmartPointer<vtkActor2D> NavigationDisplay::Implementation::box(double x, double y, double w, double h,
                                                                   const palette::Rgb& colour) {
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(scene::makeRectangle({0, 0}, {w, h}));
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(x, y);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  page->AddActor2D(actor);
  return actor;
}

void NavigationDisplay::Implementation::viewport(vtkRenderer* renderer, double x, double y, double w,
                                                 double h) {
  renderer->SetViewport(x / width, y / height, (x + w) / width, (y + h) / height);
}

NavigationDisplay::Implementation::Implementation(scene::NavigationScene& s, int w, int h)
    : scene(s), width(w), height(h) {
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  window->SetNumberOfLayers(3);
  page->SetBackground(palette::kPanel.data());
  page->InteractiveOff();
  window->AddRenderer(page);
  layOut();
  for (vtkRenderer* r : {left.renderer.Get(), right.renderer.Get(), bulls_eye.renderer()})
    window->AddRenderer(r);
  scene.attach(window, 0, double(bottom) / height, 1.0 - double(side) / width, 1.0 - double(bar) / height);
}

void NavigationDisplay::Implementation::layOut() {
  const double u = height / 720.0;
  bar = int(44 * u), bottom = int(190 * u), side = int(436 * u);
  const double top = height - bar / 2.0, gap = 8 * u;
  text(18 * u, top, 20, palette::kText, true)->SetInput("FaceNav");
  title = text(120 * u, top, 18, palette::kMuted);
  timing = text(width - 16 * u, top, 14, palette::kMuted);
  timing->GetTextProperty()->SetJustificationToRight();
  head_dot = box(width - side - 395 * u, top - 6 * u, 12 * u, 12 * u, palette::kLost);
  head = text(width - side - 373 * u, top, 16, palette::kText);
  coil_dot = box(width - side - 185 * u, top - 6 * u, 12 * u, 12 * u, palette::kLost);
  coil = text(width - side - 163 * u, top, 16, palette::kText);
  const double camera_height = (height - bar - gap) / 2;
  viewport(right.renderer, width - side + gap, 0, side - gap, camera_height);
  viewport(left.renderer, width - side + gap, camera_height + gap, side - gap, camera_height);
  viewport(bulls_eye.renderer(), gap, gap, bottom - 2 * gap, bottom - 2 * gap);
  banner = box(bottom + gap, bottom - 62 * u, width - side - bottom - gap, 50 * u, palette::kLost);
  instruction = text(bottom + 24 * u, bottom - 38 * u, 24, palette::kBackground, true);
  const char* names[4] = {"across", "depth", "tilt", "twist"};
  const double step = (width - side - bottom - 20 * u) / 4.0;
  for (int i = 0; i < 4; ++i) {
    const double x = bottom + 20 * u + i * step;
    figures[i].value = text(x, 80 * u, i == 0 ? 54 : 44, palette::kText, true);
    figures[i].unit = text(x, 80 * u, 20, palette::kMuted);
    figures[i].name = text(x + 2 * u, 28 * u, 16, palette::kMuted);
    figures[i].name->SetInput(names[i]);
  }
}

void NavigationDisplay::Implementation::setFigure(Figure& figure, const std::string& value,
                                                  const std::string& unit) {
  figure.value->SetInput(value.c_str());
  double size[2];
  figure.value->GetSize(page, size);
  const double* position = figure.value->GetPosition();
  figure.unit->SetInput(unit.c_str());
  figure.unit->SetPosition(position[0] + size[0] + 8, position[1] - size[1] * 0.18);
}

void NavigationDisplay::Implementation::setStatus(vtkTextActor* words, vtkActor2D* dot,
                                                  const StatusWords& status) {
  words->SetInput(status.words.c_str());
  const palette::Rgb& colour = status.level == StatusLevel::good      ? palette::kBlue
                               : status.level == StatusLevel::caution ? palette::kOrange
                                                                      : palette::kLost;
  dot->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

void NavigationDisplay::Implementation::setGuidance(const guidance::GuidanceState& g) {
  const bool has_values = g.values.has_value() && g.state != guidance::State::lost;
  const auto figure = [&](int i, double value, const char* format, const char* unit) {
    setFigure(figures[i], has_values ? withoutSideOfZero(formatted(format, value)) : "\u2013",
              has_values ? unit : "");
  };
  const guidance::GuidanceValues* v = has_values ? &*g.values : nullptr;
  figure(0, v ? v->lateral_mm : 0, "%.1f", "mm");
  figure(1, v ? v->depth_mm : 0, "%+.1f", "mm");
  figure(2, v ? degrees(v->tilt_rad) : 0, "%.0f\u00b0", "");
  figure(3, v ? degrees(v->twist_rad) : 0, "%+.0f\u00b0", "");
  const bool is_on_target = g.state == guidance::State::on_target;
  const palette::Rgb& colour = !has_values    ? palette::kLost
                               : is_on_target ? palette::kBlue
                                              : palette::kOrange;
  banner->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  const std::string state_words = !has_values ? "" : is_on_target ? "ON TARGET: " : "ADJUST: ";
  instruction->SetInput((state_words + g.instruction).c_str());
  bulls_eye.set(g);
}

NavigationDisplay::NavigationDisplay(scene::NavigationScene& scene, int width_px, int height_px)
    : implementation_(std::make_unique<Implementation>(scene, width_px, height_px)) {}
NavigationDisplay::~NavigationDisplay() = default;

void NavigationDisplay::setTolerance(const guidance::Tolerance& tolerance) {
  implementation_->bulls_eye.setTolerance(tolerance);
}

RgbImage NavigationDisplay::render(const NavigationDisplayContent& content) {
  auto& d = *implementation_;
  const double aspect = double(d.side) / std::max(1, (d.height - d.bar) / 2);
  d.left.set(content.left, aspect);
  d.right.set(content.right, aspect);
  d.title->SetInput(content.title.c_str());
  d.timing->SetInput(content.timing.c_str());
  d.setStatus(d.head, d.head_dot, content.head);
  d.setStatus(d.coil, d.coil_dot, content.coil);
  d.setGuidance(content.guidance);
  return scene::grab(d.window);
}

}  // namespace facenav::display
