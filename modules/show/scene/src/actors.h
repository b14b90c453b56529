#pragma once
// The actors of NavigationScene, one function per kind. Private to scene.

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>

#include "facenav/guidance/target.h"
#include "facenav/scene/coil_shape.h"
#include "facenav/scene/palette.h"
#include "facenav/surface/brain_model.h"
#include "facenav/volume/volume.h"

class vtkImageSlice;
class vtkLinearTransform;
class vtkPolyData;
class vtkRenderer;

namespace facenav::scene {

vtkSmartPointer<vtkActor> makeActor(vtkPolyData* poly, const palette::Rgb& colour);
/// Rectangle in the plane z = 0.
vtkSmartPointer<vtkPolyData> makeRectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high);
void setColour(vtkActor* actor, const palette::Rgb& colour);

vtkSmartPointer<vtkActor> makeBrainActor(const surface::BrainModel& brain);
/// Scalp that is almost transparent where seen head-on and denser at the rim: the outline is clear and the
/// brain stays visible.
vtkSmartPointer<vtkActor> makeScalpActor(vtkPolyData* scalp);
/// Slice along `axis` (0..2) of the voxel grid; pixels outside the head are transparent.
vtkSmartPointer<vtkImageSlice> makeSliceActor(const volume::Volume& mri, int axis, vtkLinearTransform* head);
void setSliceIndex(vtkImageSlice* slice, int index);

/// The coil's actors, in Coil coordinates.
struct CoilActors {
  vtkSmartPointer<vtkActor> body, windings, axis, axis_on_top, tip;
  std::array<vtkActor*, 5> all() const { return {body, windings, axis, axis_on_top, tip}; }
  /// Adds the actors; axis and tip are also drawn on top of the head.
  void addTo(vtkRenderer* renderer, vtkRenderer* on_top) const;
  void removeFrom(vtkRenderer* renderer, vtkRenderer* on_top) const;
  void setTransform(vtkLinearTransform* coil);
  void setVisible(bool is_visible, bool is_axis_visible);
};
CoilActors makeCoilActors(const CoilShape& shape);

/// A target's actors, in Mri coordinates.
struct TargetActors {
  vtkSmartPointer<vtkActor> ring, ring_on_top, line, cortex;
  std::array<vtkActor*, 4> all() const { return {ring, ring_on_top, line, cortex}; }
};
TargetActors makeTargetActors(const guidance::Target& target, bool is_active);

}  // namespace facenav::scene
