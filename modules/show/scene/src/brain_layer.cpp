#include "brain_layer.h"

#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "image_bridge.h"

namespace facenav::scene {
namespace {

constexpr palette::Rgb kBrainTint{1.0, 0.93, 0.88}, kGreyTint{0.45, 0.46, 0.48};
constexpr double kGreyOpacity = 0.6;
constexpr int kColours = 256;

vtkSmartPointer<vtkLookupTable> greyTable(const palette::Rgb& tint) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kColours);
  for (int i = 0; i < kColours; ++i) {
    const double grey = i / (kColours - 1.0);
    table->SetTableValue(i, grey * tint[0], grey * tint[1], grey * tint[2]);
  }
  table->SetRange(0, kColours - 1);
  return table;
}

vtkSmartPointer<vtkLookupTable> distanceTable(double full_mm) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kColours);
  for (int i = 0; i < kColours; ++i) {
    const auto colour = distanceColour((2.0 * i / (kColours - 1.0) - 1.0) * full_mm, full_mm);
    table->SetTableValue(i, colour[0], colour[1], colour[2]);
  }
  table->SetRange(-full_mm, full_mm);
  return table;
}

}  // namespace

void BrainLayer::setModel(const surface::BrainModel& brain) {
  clear();
  model_ = makeBrainActor(brain);
  model_->SetUserTransform(head_);
  renderer_->AddActor(model_);
  update();
}

BrainLayer::Level BrainLayer::makeLevel(const surface::TriangleMesh& mesh, const surface::PeelTexture& peel,
                                        const std::vector<float>& distance_mm) {
  Level level;
  level.distances = vtkSmartPointer<vtkFloatArray>::New();
  level.distances->SetNumberOfValues(vtkIdType(distance_mm.size()));
  std::copy(distance_mm.begin(), distance_mm.end(), level.distances->GetPointer(0));
  level.peel = &peel;
  level.greys = vtkSmartPointer<vtkUnsignedCharArray>::New();
  level.greys->SetNumberOfValues(vtkIdType(mesh.vertices_mm.size()));
  level.actor = makeActor(toPolyData(mesh), kBrainTint);
  vtkProperty* look = level.actor->GetProperty();
  look->SetAmbient(0.30);
  look->SetDiffuse(0.85);
  look->SetSpecular(0.08);
  look->SetSpecularPower(18);
  look->BackfaceCullingOn();  // closed surface: hides half of the triangles
  vtkMapper* mapper = level.actor->GetMapper();
  mapper->ScalarVisibilityOn();
  mapper->SetScalarModeToUsePointData();
  mapper->SetColorModeToMapScalars();
  mapper->UseLookupTableScalarRangeOn();
  level.actor->SetUserTransform(head_);
  renderer_->AddActor(level.actor);
  return level;
}

void BrainLayer::setCortex(std::shared_ptr<const CortexPicture> cortex) {
  for (Level* level : {&fine_, &coarse_}) {
    if (level->actor) renderer_->RemoveActor(level->actor);
    *level = {};
  }
  detailed_ = std::move(cortex);
  if (detailed_) {
    fine_ = makeLevel(detailed_->cortex.mesh, detailed_->peel, detailed_->cortex.distance_mm);
    coarse_ = makeLevel(detailed_->coarse_mesh, detailed_->coarse_peel, detailed_->coarse_distance_mm);
  }
  update();
}

void BrainLayer::clear() {
  if (model_) renderer_->RemoveActor(model_);
  model_ = nullptr;
  setCortex(nullptr);
}

void BrainLayer::setLook(BrainLook look) {
  if (look_ == look) return;
  look_ = look;
  update();
}

void BrainLayer::setPeelDepth(double depth_mm) {
  if (peel_mm_ == depth_mm) return;
  peel_mm_ = depth_mm;
  if (look_ == BrainLook::cortex) colourCortex();
}

void BrainLayer::setVisible(bool is_visible) {
  is_visible_ = is_visible;
  update();
}

void BrainLayer::setGrey(bool is_grey) {
  if (is_grey_ == is_grey) return;
  is_grey_ = is_grey;
  update();
}

void BrainLayer::setQuick(bool is_quick) {
  if (is_quick_ == is_quick) return;
  is_quick_ = is_quick;
  update();
}

vtkActor* BrainLayer::shown() const {
  if (!is_visible_) return nullptr;
  return detailed_ && look_ != BrainLook::model ? level().actor : model_;
}

void BrainLayer::update() {
  for (vtkActor* actor : {model_.Get(), fine_.actor.Get(), coarse_.actor.Get()})
    if (actor) {
      actor->SetVisibility(actor == shown());
      actor->GetProperty()->SetOpacity(is_grey_ ? kGreyOpacity : 1.0);
    }
  if (model_) setColour(model_, is_grey_ ? kGreyTint : kBrainTint);
  if (look_ != BrainLook::model) colourCortex();
}

void BrainLayer::colourCortex() {
  if (!detailed_) return;
  vtkMapper* mapper = level().actor->GetMapper();
  auto* data = vtkPolyData::SafeDownCast(mapper->GetInput())->GetPointData();
  if (showsDistance()) {
    mapper->SetLookupTable(is_grey_ ? greyTable(kGreyTint) : distanceTable(detailed_->full_mm));
    data->SetScalars(level().distances);
    return;
  }
  mapper->SetLookupTable(greyTable(is_grey_ ? kGreyTint : kBrainTint));
  const auto greys = level().peel->greyAt(peel_mm_);
  std::copy(greys.begin(), greys.end(), level().greys->GetPointer(0));
  level().greys->Modified();
  data->SetScalars(level().greys);
}

}  // namespace facenav::scene
