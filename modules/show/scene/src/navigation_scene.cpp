#include "facenav/scene/navigation_scene.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellPicker.h>
#include <vtkImageSlice.h>
#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <array>
#include <cmath>

#include "actors.h"
#include "brain_layer.h"
#include "coil_slice_layer.h"
#include "facenav/volume/vtk_image.h"
#include "head_icon.h"
#include "image_bridge.h"
#include "scene_banner.h"
#include "scene_camera.h"
#include "scene_setting.h"
#include "skin_layer.h"
#include "target_layer.h"

namespace facenav::scene {
struct NavigationScene::Implementation {
  vtkNew<vtkRenderer> renderer, on_top;
  HeadIcon icon;
  vtkNew<vtkTransform> head_transform, coil_transform, ghost_transform;
  SkinLayer scalp{renderer, head_transform};
  BrainLayer brain{renderer, head_transform};
  std::array<vtkSmartPointer<vtkImageSlice>, 3> slices;
  volume::VoxelGrid grid;
  CoilActors coil, ghost;
  CoilSliceLayer coil_slices{on_top, coil_transform};
  TargetLayer targets{renderer, on_top, head_transform};
  SceneCamera viewpoint{renderer->GetActiveCamera()};
  SceneBanner banner;
  vtkSmartPointer<vtkRenderWindow> offscreen;
  SceneLayers layers;
  ViewFrame view_frame = ViewFrame::head_fixed;
  double text_scale = 1.0;
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  bool has_ghost = false, is_live = false, is_on_target = false, is_grey = false, is_quick = false,
       hides_skin = false;

  Implementation();
  bool coilIsShown() const { return is_live && camera_T_mri && camera_T_coil; }
  void updateTransforms();
  void updateVisibility();
  void setGrey(bool grey);
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
  renderer->UseFXAAOn();  // smooth edges at a tenth of the cost of multi-sampling in software rendering
  addLights(renderer);
  on_top->AddActor2D(banner.actor());
  vtkNew<vtkCallbackCommand> before_render;
  before_render->SetClientData(this);
  before_render->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    auto* scene = static_cast<Implementation*>(self);
    scene->on_top->ResetCameraClippingRange(scene->renderer->ComputeVisiblePropBounds());
    scene->renderer->ResetCameraClippingRange();
    scene->syncIcon();
    scene->banner.fit(scene->on_top);
    scene->coil_slices.cut();
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
  brain.setVisible(layers.brain);
  const bool shown[3] = {layers.sagittal, layers.coronal, layers.axial};
  for (int axis = 0; axis < 3; ++axis) {  // finds the world axis (R, A, S) closest to this voxel axis
    if (!slices[axis]) continue;
    Eigen::Index nearest = 0;
    grid.mri_from_voxel.linear().col(axis).cwiseAbs().maxCoeff(&nearest);
    slices[axis]->SetVisibility(shown[nearest]);
  }
  coil.setVisible(coilIsShown() && layers.coil, layers.coil_axis);
  ghost.setVisible(has_ghost && layers.coil, true);
  targets.setVisible(layers.targets);
  setGrey(is_live && !coilIsShown());
  coil_slices.follow(coilIsShown() && layers.coil ? std::optional(camera_T_mri->inverse() * *camera_T_coil)
                                                  : std::nullopt);
}

void NavigationScene::Implementation::setGrey(bool grey) {
  is_grey = grey;
  scalp.setLook(layers.scalp && !hides_skin, is_quick, grey, layers.scalp_opacity);
  brain.setGrey(grey);
  targets.setColours(is_grey, is_on_target);
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
  s.scalp.set(scalp);
  s.viewpoint.fit(scalp);
  s.updateVisibility();
}

void NavigationScene::setBrain(const surface::BrainModel& brain) {
  implementation_->brain.setModel(brain);
  implementation_->updateVisibility();
}

void NavigationScene::setCortex(std::shared_ptr<const CortexPicture> cortex) {
  implementation_->brain.setCortex(std::move(cortex));
}

void NavigationScene::clearBrain() { implementation_->brain.clear(); }

void NavigationScene::setBrainLook(BrainLook look) { implementation_->brain.setLook(look); }

void NavigationScene::shareCamera(NavigationScene& other) {
  vtkCamera* camera = other.implementation_->renderer->GetActiveCamera();
  implementation_->renderer->SetActiveCamera(camera);
  implementation_->on_top->SetActiveCamera(camera);
}

void NavigationScene::setQuick(bool is_quick, bool is_skin_shown) {
  auto& s = *implementation_;
  s.is_quick = is_quick;
  s.hides_skin = is_quick && !is_skin_shown;
  s.brain.setQuick(is_quick);
  s.renderer->SetUseFXAA(!is_quick);
  s.updateVisibility();
}

void NavigationScene::setPeelDepth(double depth_mm) { implementation_->brain.setPeelDepth(depth_mm); }

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

void NavigationScene::setCoilSlices(std::shared_ptr<const volume::Volume> mri) {
  implementation_->coil_slices.setVolume(std::move(mri));
  implementation_->updateVisibility();
}

bool NavigationScene::showsCoilSlices() const { return implementation_->coil_slices.isShown(); }

void NavigationScene::setTargets(const std::vector<guidance::Target>& targets, const std::string& active) {
  auto& s = *implementation_;
  s.targets.set(targets, active);
  s.updateVisibility();
}

void NavigationScene::setCoilShape(const CoilShape& shape) {
  auto& s = *implementation_;
  for (CoilActors* coil : {&s.coil, &s.ghost}) {
    if (coil->body) coil->removeFrom(s.renderer, s.on_top);
    *coil = makeCoilActors(shape);
    coil->addTo(s.renderer, s.on_top);
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
  if (s.view_frame == ViewFrame::camera) return s.viewpoint.placeInCamera();
  s.viewpoint.place(preset, s.targets.active());
}

void NavigationScene::setViewFrame(ViewFrame frame) {
  implementation_->view_frame = frame;
  implementation_->updateTransforms();
  setView(ViewPreset::target);
}

void NavigationScene::setCameraAngle(double vertical_rad) {
  implementation_->viewpoint.setAngle(vertical_rad);
}

void NavigationScene::setHeadPose(const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri) {
  auto& s = *implementation_;
  s.is_live = true;
  s.camera_T_mri = camera_T_mri ? std::optional(*camera_T_mri) : std::nullopt;
  s.updateTransforms();
}

void NavigationScene::setCoilPose(const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil) {
  auto& s = *implementation_;
  s.is_live = true;
  s.camera_T_coil = camera_T_coil ? std::optional(*camera_T_coil) : std::nullopt;
  s.updateTransforms();
}

void NavigationScene::setOnTarget(bool is_on_target) {
  auto& s = *implementation_;
  s.is_on_target = is_on_target;
  s.targets.setColours(s.is_grey, is_on_target);
}

void NavigationScene::setBackground(const palette::Rgb& bottom, const palette::Rgb& top) {
  implementation_->renderer->SetBackground(bottom[0], bottom[1], bottom[2]);
  implementation_->renderer->SetBackground2(top[0], top[1], top[2]);
}

void NavigationScene::setBanner(const std::string& words) { implementation_->banner.setWords(words); }

void NavigationScene::setTextScale(double scale) {
  auto& s = *implementation_;
  s.text_scale = scale;
  s.banner.setTextScale(scale);
  s.icon.setTextScale(scale);
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
  const double smaller = std::min(width, height);
  // Size of the head icon: 64 px at least, so that its letters are whole.
  const double side = std::min(0.5 * smaller, std::max(0.24 * smaller, 64.0 * s.text_scale));
  s.icon.renderer()->SetViewport(x0, y0, x0 + (x1 - x0) * side / width, y0 + (y1 - y0) * side / height);
  for (vtkRenderer* r : {s.renderer.Get(), s.on_top.Get(), s.icon.renderer()})
    if (!window->HasRenderer(r)) window->AddRenderer(r);
}

std::optional<ScenePick> NavigationScene::pick(int x_px, int y_px) const {
  auto& s = *implementation_;
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.0005);
  picker->PickFromListOn();
  // A click on the brain selects the brain, even through the translucent skin.
  vtkActor* brain = s.brain.shown();
  if (brain) picker->AddPickList(brain);
  if (!brain || !picker->Pick(x_px, y_px, 0, s.renderer)) {
    picker->InitializePickList();
    if (vtkActor* skin = s.scalp.shown()) picker->AddPickList(skin);
  }
  if (!picker->Pick(x_px, y_px, 0, s.renderer)) return std::nullopt;
  double p[3];
  s.head_transform->GetLinearInverse()->TransformPoint(picker->GetPickPosition(), p);
  return ScenePick{Point<Mri>(p[0], p[1], p[2]), brain && picker->GetActor() == brain};
}

SceneProjection NavigationScene::projection(int width_px, int height_px) const {
  auto& s = *implementation_;
  vtkCamera* camera = s.renderer->GetActiveCamera();
  const double aspect = double(width_px) / std::max(1, height_px);
  vtkNew<vtkMatrix4x4> screen;
  vtkMatrix4x4::Multiply4x4(camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1),
                            s.head_transform->GetMatrix(), screen);
  SceneProjection projection;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) projection.screen_from_mri(r, c) = screen->GetElement(r, c);
  double eye[3];
  s.head_transform->GetLinearInverse()->TransformPoint(camera->GetPosition(), eye);
  projection.eye = Point<Mri>(eye[0], eye[1], eye[2]);
  return projection;
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
