#include "facenav/scene/navigation_scene.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellPicker.h>
#include <vtkImageSlice.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTexture.h>
#include <vtkTransform.h>

#include <array>
#include <cmath>

#include "actors.h"
#include "facenav/volume/vtk_image.h"
#include "head_icon.h"
#include "image_bridge.h"

namespace facenav::scene {
namespace {

constexpr double kCameraDistance_mm = 540.0;  // fills the view with a head of 110 mm half height

}  // namespace

struct NavigationScene::Implementation {
  vtkNew<vtkRenderer> renderer, on_top;
  HeadIcon icon;
  vtkNew<vtkTransform> head_transform, coil_transform, ghost_transform;
  vtkSmartPointer<vtkActor> scalp, brain;
  vtkSmartPointer<vtkTexture> brain_texture;
  std::array<vtkSmartPointer<vtkImageSlice>, 3> slices;
  volume::VoxelGrid grid;
  CoilActors coil, ghost;
  std::vector<TargetActors> targets;
  std::size_t active_target = 0;
  std::optional<guidance::Target> active;
  vtkNew<vtkTextActor> banner;
  vtkSmartPointer<vtkRenderWindow> offscreen;
  SceneLayers layers;
  ViewFrame view_frame = ViewFrame::head_fixed;
  double camera_angle_rad = 0.58;
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  bool has_ghost = false, is_live = false, is_on_target = false, is_grey = false;
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
  double radius_mm = 110.0;

  Implementation();
  bool coilIsShown() const { return is_live && camera_T_mri && camera_T_coil; }
  void updateTransforms();
  void updateVisibility();
  void updateColours();
  void setGrey(bool grey);
  void placeCamera(const Eigen::Vector3d& from, const Eigen::Vector3d& up) {
    placeCamera(from, up, centre_mm, 1.0);
  }
  void placeCamera(const Eigen::Vector3d& from, const Eigen::Vector3d& up, const Eigen::Vector3d& at_mm,
                   double distance);
  void placeInCamera();
  void syncIcon();
};

NavigationScene::Implementation::Implementation() {
  renderer->SetBackground(palette::kBackground.data());
  renderer->SetBackground2(palette::kBackgroundTop.data());
  renderer->GradientBackgroundOn();
  renderer->SetLayer(0);
  on_top->SetLayer(1);
  on_top->InteractiveOff();
  on_top->SetActiveCamera(renderer->GetActiveCamera());
  renderer->GetActiveCamera()->SetViewAngle(28.0);
  renderer->UseFXAAOn();  // smooth edges at a tenth of multi-sampling's cost in software rendering
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToCameraLight();
  fill->SetPosition(-0.8, 0.9, 0.6);
  fill->SetIntensity(0.35);
  vtkNew<vtkLight> key;
  key->SetLightTypeToHeadlight();
  key->SetIntensity(0.8);
  renderer->AddLight(key);
  renderer->AddLight(fill);
  banner->GetTextProperty()->SetFontSize(22);
  banner->GetTextProperty()->BoldOn();
  banner->GetTextProperty()->SetJustificationToCentered();
  banner->GetTextProperty()->SetVerticalJustificationToCentered();
  banner->GetTextProperty()->SetColor(palette::kText[0], palette::kText[1], palette::kText[2]);
  banner->GetTextProperty()->SetBackgroundColor(0.02, 0.02, 0.025);
  banner->GetTextProperty()->SetBackgroundOpacity(0.82);
  banner->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  banner->SetPosition(0.5, 0.90);
  banner->VisibilityOff();
  on_top->AddActor2D(banner);
  vtkNew<vtkCallbackCommand> before_render;
  before_render->SetClientData(this);
  before_render->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    auto* scene = static_cast<Implementation*>(self);
    scene->on_top->ResetCameraClippingRange(scene->renderer->ComputeVisiblePropBounds());
    scene->renderer->ResetCameraClippingRange();
    scene->syncIcon();
  });
  renderer->AddObserver(vtkCommand::StartEvent, before_render);
}

void NavigationScene::Implementation::updateTransforms() {
  const bool follows_camera = view_frame == ViewFrame::camera;
  Eigen::Matrix4d head = Eigen::Matrix4d::Identity(), at = Eigen::Matrix4d::Identity();
  if (follows_camera && camera_T_mri) head = camera_T_mri->matrix();
  if (camera_T_mri && camera_T_coil)
    at = follows_camera ? camera_T_coil->matrix() : (camera_T_mri->inverse() * *camera_T_coil).matrix();
  head_transform->SetMatrix(volume::toVtkMatrix(head));
  coil_transform->SetMatrix(volume::toVtkMatrix(at));
  updateVisibility();
}

void NavigationScene::Implementation::updateVisibility() {
  if (scalp) scalp->SetVisibility(layers.scalp);
  if (brain) brain->SetVisibility(layers.brain);
  const bool shown[3] = {layers.sagittal, layers.coronal, layers.axial};
  for (int axis = 0; axis < 3; ++axis) {  // which voxel axis runs nearest to R, A, S
    if (!slices[axis]) continue;
    Eigen::Index nearest = 0;
    grid.mri_from_voxel.linear().col(axis).cwiseAbs().maxCoeff(&nearest);
    slices[axis]->SetVisibility(shown[nearest]);
  }
  coil.setVisible(coilIsShown() && layers.coil, layers.coil_axis);
  ghost.setVisible(has_ghost && layers.coil, true);
  for (auto& t : targets)
    for (vtkActor* actor : {t.ring.Get(), t.ring_on_top.Get(), t.line.Get(), t.cortex.Get()})
      actor->SetVisibility(layers.targets);
  setGrey(is_live && !coilIsShown());
}

void NavigationScene::Implementation::setGrey(bool grey) {
  is_grey = grey;
  if (scalp) {
    setColour(scalp, grey ? palette::kLost : palette::kSkin);
    scalp->GetProperty()->SetOpacity(layers.scalp_opacity * (grey ? 0.7 : 1.0));
  }
  if (brain) {
    setColour(brain, grey ? palette::Rgb{0.45, 0.46, 0.48} : palette::Rgb{1.0, 0.93, 0.88});
    brain->GetProperty()->SetOpacity(grey ? 0.6 : 1.0);
  }
  updateColours();
}

void NavigationScene::Implementation::updateColours() {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const bool is_active = active && i == active_target;
    const palette::Rgb colour =
        is_grey || !is_active ? palette::kLost : (is_on_target ? palette::kBlue : palette::kOrange);
    for (vtkActor* a : {targets[i].ring.Get(), targets[i].ring_on_top.Get(), targets[i].line.Get(),
                        targets[i].cortex.Get()})
      setColour(a, colour);
  }
}

void NavigationScene::Implementation::placeCamera(const Eigen::Vector3d& from, const Eigen::Vector3d& up,
                                                  const Eigen::Vector3d& at_mm, double distance) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d position =
      at_mm + from.normalized() * distance * kCameraDistance_mm * radius_mm / 110.0;
  camera->SetViewAngle(28.0);
  camera->SetFocalPoint(at_mm.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
  camera->OrthogonalizeViewUp();
}

void NavigationScene::Implementation::placeInCamera() {
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 0);
  camera->SetFocalPoint(0, 0, 1);
  camera->SetViewUp(0, -1, 0);  // Camera's y points down
  camera->SetViewAngle(camera_angle_rad * 180.0 / M_PI);
}

void NavigationScene::Implementation::syncIcon() {
  double rotation[3][3];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) rotation[r][c] = head_transform->GetMatrix()->GetElement(r, c);
  icon.follow(renderer, rotation);
}

NavigationScene::NavigationScene() : implementation_(std::make_unique<Implementation>()) {
  setCoilShape(makeCoilShape());
  setView(ViewPreset::left_front);
}

NavigationScene::~NavigationScene() = default;

void NavigationScene::setScalp(const surface::TriangleMesh& scalp) {
  auto& s = *implementation_;
  if (s.scalp) s.renderer->RemoveActor(s.scalp);
  s.scalp = makeScalpActor(scalp);
  s.scalp->SetUserTransform(s.head_transform);
  s.renderer->AddActor(s.scalp);
  if (!scalp.vertices_mm.empty()) {
    Eigen::Vector3d low = scalp.vertices_mm.front(), high = low;
    for (const auto& v : scalp.vertices_mm) low = low.cwiseMin(v), high = high.cwiseMax(v);
    low.z() = std::max(low.z(), high.z() - 235.0);  // a long neck or shoulders must not shrink the head
    s.centre_mm = 0.5 * (low + high);
    s.radius_mm = std::max(40.0, 0.5 * (high - low).maxCoeff());
  }
  s.updateVisibility();
}

void NavigationScene::setBrain(const surface::BrainModel& brain) {
  auto& s = *implementation_;
  clearBrain();
  s.brain = makeBrainActor(brain);
  s.brain->SetUserTransform(s.head_transform);
  s.renderer->AddActor(s.brain);
  s.updateVisibility();
}

void NavigationScene::clearBrain() {
  auto& s = *implementation_;
  if (s.brain) s.renderer->RemoveActor(s.brain);
  s.brain = nullptr;
}

void NavigationScene::setVolume(const volume::Volume& mri) {
  auto& s = *implementation_;
  s.grid = mri.grid;
  for (int axis = 0; axis < 3; ++axis) {
    if (s.slices[axis]) s.renderer->RemoveViewProp(s.slices[axis]);
    s.slices[axis] = makeSliceActor(mri, axis, s.head_transform);
    s.renderer->AddViewProp(s.slices[axis]);
  }
  setSliceCentre(mri.grid.centre());
  s.updateVisibility();
}

void NavigationScene::setSliceCentre(const Point<Mri>& centre) {
  auto& s = *implementation_;
  const Eigen::Vector3d voxel = s.grid.toVoxel(centre);
  for (int axis = 0; axis < 3; ++axis)
    if (s.slices[axis])
      setSliceIndex(s.slices[axis], std::clamp(int(std::lround(voxel[axis])), 0, s.grid.size[axis] - 1));
}

void NavigationScene::setTargets(const std::vector<guidance::Target>& targets, const std::string& active) {
  auto& s = *implementation_;
  for (auto& t : s.targets) {
    for (vtkActor* actor : {t.ring.Get(), t.line.Get(), t.cortex.Get()}) s.renderer->RemoveActor(actor);
    for (vtkActor* actor : {t.ring_on_top.Get(), t.cortex.Get()}) s.on_top->RemoveActor(actor);
  }
  s.targets.clear();
  s.active.reset();
  for (const auto& target : targets) {
    const bool is_active = target.name == active;
    if (is_active) s.active = target, s.active_target = s.targets.size();
    s.targets.push_back(makeTargetActors(target, is_active));
    auto& t = s.targets.back();
    for (vtkActor* actor : {t.ring.Get(), t.ring_on_top.Get(), t.line.Get(), t.cortex.Get()})
      actor->SetUserTransform(s.head_transform);
    for (vtkActor* actor : {t.ring.Get(), t.line.Get()}) s.renderer->AddActor(actor);
    if (is_active) s.on_top->AddActor(t.ring_on_top);
    s.on_top->AddActor(t.cortex);
  }
  s.updateVisibility();
}

void NavigationScene::setCoilShape(const CoilShape& shape) {
  auto& s = *implementation_;
  for (CoilActors* coil : {&s.coil, &s.ghost}) {
    if (coil->body) {
      for (vtkActor* actor : {coil->body.Get(), coil->windings.Get(), coil->axis.Get()})
        s.renderer->RemoveActor(actor);
      for (vtkActor* actor : {coil->axis_on_top.Get(), coil->tip.Get()}) s.on_top->RemoveActor(actor);
    }
    *coil = makeCoilActors(shape);
    for (vtkActor* actor : {coil->body.Get(), coil->windings.Get(), coil->axis.Get()})
      s.renderer->AddActor(actor);
    for (vtkActor* actor : {coil->axis_on_top.Get(), coil->tip.Get()}) s.on_top->AddActor(actor);
  }
  s.coil.setTransform(s.coil_transform);
  vtkNew<vtkTransform> placed_ghost;
  placed_ghost->SetInput(s.head_transform);
  placed_ghost->Concatenate(s.ghost_transform);
  s.ghost.setTransform(placed_ghost);
  for (vtkActor* actor : {s.ghost.body.Get(), s.ghost.windings.Get()}) {
    setColour(actor, palette::kOrange);
    actor->GetProperty()->SetOpacity(0.22);
  }
  s.updateVisibility();
}

void NavigationScene::setCoilGhost(const std::optional<RigidTransform<Mri, Target>>& mri_T_target) {
  auto& s = *implementation_;
  s.has_ghost = mri_T_target.has_value();
  if (mri_T_target) s.ghost_transform->SetMatrix(volume::toVtkMatrix(mri_T_target->matrix()));
  s.updateVisibility();
}

void NavigationScene::setLayers(const SceneLayers& layers) {
  implementation_->layers = layers;
  implementation_->updateVisibility();
}

void NavigationScene::setView(ViewPreset preset) {
  auto& s = *implementation_;
  if (s.view_frame == ViewFrame::camera) return s.placeInCamera();
  const Eigen::Vector3d up(0, 0, 1);
  switch (preset) {  // Mri: x right, y anterior, z superior
    case ViewPreset::front:
      return s.placeCamera({0, 1, 0.05}, up);
    case ViewPreset::back:
      return s.placeCamera({0, -1, 0.05}, up);
    case ViewPreset::left:
      return s.placeCamera({-1, 0, 0.05}, up);
    case ViewPreset::right:
      return s.placeCamera({1, 0, 0.05}, up);
    case ViewPreset::top:
      return s.placeCamera({0, 0, 1}, {0, 1, 0});
    case ViewPreset::right_front:
      return s.placeCamera({0.75, 0.8, 0.42}, up);
    case ViewPreset::left_front:
      return s.placeCamera({-0.75, 0.8, 0.42}, up);
    case ViewPreset::target: {
      if (!s.active) return s.placeCamera({-0.75, 0.8, 0.42}, up);
      // Oblique to the coil's axis and from the front, so that axis, ring and face are all in sight.
      const Eigen::Vector3d out = -s.active->mri_T_target.rotation().col(2);
      const Eigen::Vector3d at = s.centre_mm + 0.28 * s.radius_mm * out;  // room for the coil above the head
      return s.placeCamera(out * 0.35 + Eigen::Vector3d(0.62 * (out.x() < 0 ? -1 : 1), 0.85, 0.0), up, at,
                           1.05);
    }
  }
}

void NavigationScene::setViewFrame(ViewFrame frame) {
  implementation_->view_frame = frame;
  implementation_->updateTransforms();
  setView(ViewPreset::target);
}

void NavigationScene::setCameraAngle(double vertical_rad) {
  implementation_->camera_angle_rad = vertical_rad;
}

void NavigationScene::setHeadPose(const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri) {
  auto& s = *implementation_;
  s.is_live = true;
  s.camera_T_mri.reset();
  if (camera_T_mri) s.camera_T_mri = *camera_T_mri;
  s.updateTransforms();
}

void NavigationScene::setCoilPose(const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil) {
  auto& s = *implementation_;
  s.is_live = true;
  s.camera_T_coil.reset();
  if (camera_T_coil) s.camera_T_coil = *camera_T_coil;
  s.updateTransforms();
}

void NavigationScene::setOnTarget(bool is_on_target) {
  implementation_->is_on_target = is_on_target;
  implementation_->updateColours();
}

void NavigationScene::setBanner(const std::string& words) {
  auto& s = *implementation_;
  s.banner->SetInput((words.empty() ? "" : "  " + words + "  ").c_str());
  s.banner->SetVisibility(!words.empty());
}

void NavigationScene::setLive(bool is_live) {
  auto& s = *implementation_;
  s.is_live = is_live;
  if (!is_live) s.camera_T_mri.reset(), s.camera_T_coil.reset();
  s.updateTransforms();
}

bool NavigationScene::showsCoil() const { return implementation_->coil.body->GetVisibility() != 0; }

vtkRenderer* NavigationScene::renderer() const { return implementation_->renderer; }

void NavigationScene::attach(vtkRenderWindow* window, double x0, double y0, double x1, double y1) {
  auto& s = *implementation_;
  if (window->GetNumberOfLayers() < 3) window->SetNumberOfLayers(3);
  s.renderer->SetViewport(x0, y0, x1, y1);
  s.on_top->SetViewport(x0, y0, x1, y1);
  const int* size = window->GetSize();
  const double width = std::max(1, size[0]) * (x1 - x0), height = std::max(1, size[1]) * (y1 - y0);
  const double side = 0.24 * std::min(width, height);
  s.icon.renderer()->SetViewport(x0, y0, x0 + (x1 - x0) * side / width, y0 + (y1 - y0) * side / height);
  for (vtkRenderer* r : {s.renderer.Get(), s.on_top.Get(), s.icon.renderer()})
    if (!window->HasRenderer(r)) window->AddRenderer(r);
}

std::optional<ScenePick> NavigationScene::pick(int x_px, int y_px) const {
  auto& s = *implementation_;
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.0005);
  picker->PickFromListOn();
  for (vtkActor* actor : {s.brain.Get(), s.scalp.Get()})
    if (actor && actor->GetVisibility()) picker->AddPickList(actor);
  // A click means the brain where brain is under the mouse; the translucent skin in front of it does not
  // count.
  if (s.brain && s.brain->GetVisibility()) {
    picker->InitializePickList();
    picker->AddPickList(s.brain);
    if (!picker->Pick(x_px, y_px, 0, s.renderer) && s.scalp) {
      picker->InitializePickList();
      picker->AddPickList(s.scalp);
    }
  }
  if (!picker->Pick(x_px, y_px, 0, s.renderer)) return std::nullopt;
  double p[3];
  s.head_transform->GetLinearInverse()->TransformPoint(picker->GetPickPosition(), p);
  return ScenePick{Point<Mri>(p[0], p[1], p[2]), picker->GetActor() == s.brain};
}

RgbImage NavigationScene::render(int width_px, int height_px) {
  auto& s = *implementation_;
  if (!s.offscreen) {
    s.offscreen = vtkSmartPointer<vtkRenderWindow>::New();
    s.offscreen->SetOffScreenRendering(1);
    s.offscreen->SetMultiSamples(0);
  }
  s.offscreen->SetSize(width_px, height_px);
  attach(s.offscreen);
  return grab(s.offscreen);
}

}  // namespace facenav::scene
