#include "facenav/scene/field_layer.h"

#include <vtkBillboardTextActor3D.h>
#include <vtkContourFilter.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <limits>

#include "actors.h"
#include "facenav/scene/pulse_layer.h"
#include "image_bridge.h"
#include "scene_text.h"

namespace facenav::scene {
namespace {

constexpr double kLeastShare = 0.2;
constexpr double kLineShares[] = {0.5, 0.75, 0.9};
constexpr double kLineAbove_mm = 0.7;  // above the colours, which lie 0.4 mm above the brain
constexpr double kDot_mm = 1.8, kWordsAbove_mm = 9.0;
constexpr int kWords_pt = 12;
constexpr double kBehindWords = 0.7;
constexpr palette::Rgb kWhite{1, 1, 1};

/// The coloured part of a surface, with its strengths.
struct ColouredPart {
  surface::TriangleMesh mesh;
  std::vector<float> strength;
};

/// Takes the triangles whose field is not weaker than the colours begin: a small part, which is quickly drawn
/// anew while the coil moves.
ColouredPart colouredPart(const FieldPicture& picture) {
  const surface::TriangleMesh& whole = *picture.surface;
  const double least = kLeastShare * picture.peak;
  ColouredPart part;
  std::vector<int> number(whole.vertices_mm.size(), -1);
  for (const Eigen::Vector3i& triangle : whole.triangles) {
    bool is_coloured = true;
    for (const int v : triangle) is_coloured &= picture.strength[std::size_t(v)] >= least;
    if (!is_coloured) continue;
    Eigen::Vector3i corners;
    for (int c = 0; c < 3; ++c) {
      const auto v = std::size_t(triangle[c]);
      if (number[v] < 0) {
        number[v] = int(part.mesh.vertices_mm.size());
        part.mesh.vertices_mm.push_back(whole.vertices_mm[v]);
        part.mesh.normals.push_back(whole.normals[v]);
        part.strength.push_back(picture.strength[v]);
      }
      corners[c] = number[v];
    }
    part.mesh.triangles.push_back(corners);
  }
  return part;
}

/// Lines on the surface where the strength is 50, 75 and 90 % of the maximum.
vtkSmartPointer<vtkActor> linesActor(const ColouredPart& part, double peak) {
  surface::TriangleMesh raised = part.mesh;
  vtkNew<vtkFloatArray> strength;
  strength->SetNumberOfValues(vtkIdType(part.strength.size()));
  for (std::size_t i = 0; i < raised.vertices_mm.size(); ++i) {
    raised.vertices_mm[i] += kLineAbove_mm * raised.normals[i];
    strength->SetValue(vtkIdType(i), part.strength[i]);
  }
  const auto poly = toPolyData(raised);
  poly->GetPointData()->SetScalars(strength);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(poly);
  for (int i = 0; i < 3; ++i) contour->SetValue(i, kLineShares[i] * peak);
  contour->ComputeScalarsOff();
  contour->Update();
  auto actor = makeActor(contour->GetOutput(), kWhite);
  actor->GetProperty()->SetLineWidth(2.0f);
  actor->GetProperty()->LightingOff();
  return actor;
}

std::size_t nearestVertex(const surface::TriangleMesh& mesh, const Point<Mri>& p) {
  std::size_t nearest = 0;
  double least_mm2 = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    if (const double d_mm2 = (mesh.vertices_mm[i] - p.mm).squaredNorm(); d_mm2 < least_mm2)
      least_mm2 = d_mm2, nearest = i;
  return nearest;
}

}  // namespace

ColourRange fieldColours(double peak) { return {kLeastShare * peak, peak}; }

Overlay fieldOverlay(std::shared_ptr<const volume::Volume> strength,
                     std::shared_ptr<const volume::Mask> brain, double peak) {
  constexpr double kOpacity = 0.6;  // the sulci stay visible
  Overlay overlay;
  overlay.name = "|E|";
  overlay.opacity = kOpacity;
  overlay.map = std::move(strength);
  overlay.threshold = fieldColours(peak).low;
  overlay.full = fieldColours(peak).high;
  overlay.is_strength = true;
  overlay.within = std::move(brain);
  return overlay;
}

struct FieldLayer::Implementation {
  explicit Implementation(NavigationScene& scene) : renderer(scene.renderer()), colours(scene) {}
  vtkRenderer* renderer;
  PulseLayer colours;
  std::vector<vtkSmartPointer<vtkProp3D>> props;
  void clear() {
    colours.clearHeat();
    for (const auto& prop : props) renderer->RemoveViewProp(prop);
    props.clear();
  }
  void add(vtkSmartPointer<vtkProp3D> prop) {
    prop->PickableOff();
    renderer->AddViewProp(prop);
    props.push_back(std::move(prop));
  }
  /// Marks the maximum on the drawn surface, which may lie above the cortex.
  void addPeak(const FieldPicture& picture, double text_scale) {
    const std::size_t vertex = nearestVertex(*picture.surface, picture.peak_place);
    const Eigen::Vector3d at_mm = picture.surface->vertices_mm[vertex];
    const Eigen::Vector3d above_mm = at_mm + kWordsAbove_mm * picture.surface->normals[vertex];
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(kDot_mm);
    ball->SetCenter(at_mm.data());
    ball->Update();
    add(makeActor(ball->GetOutput(), kWhite));
    auto words = vtkSmartPointer<vtkBillboardTextActor3D>::New();
    setWords(*words, picture.peak_words);
    words->SetPosition(above_mm.x(), above_mm.y(), above_mm.z());
    words->GetTextProperty()->SetFontSize(int(std::lround(kWords_pt * text_scale)));
    words->GetTextProperty()->SetColor(kWhite[0], kWhite[1], kWhite[2]);
    words->GetTextProperty()->SetBackgroundColor(0, 0, 0);  // the coil is nearly always above them
    words->GetTextProperty()->SetBackgroundOpacity(kBehindWords);
    words->GetTextProperty()->BoldOn();
    words->GetTextProperty()->SetJustificationToCentered();
    add(words);
  }
};

FieldLayer::FieldLayer(NavigationScene& scene) : implementation_(std::make_unique<Implementation>(scene)) {}

FieldLayer::~FieldLayer() { implementation_->clear(); }

void FieldLayer::set(const FieldPicture* picture, double text_scale) {
  auto& layer = *implementation_;
  layer.clear();
  if (!picture || !picture->surface || picture->surface->vertices_mm.empty()) return;
  const ColouredPart part = colouredPart(*picture);
  if (!part.mesh.triangles.empty()) {
    layer.colours.setHeat(part.mesh, part.strength, fieldColours(picture->peak));
    layer.add(linesActor(part, picture->peak));
  }
  layer.addPeak(*picture, text_scale);
}

}  // namespace facenav::scene
