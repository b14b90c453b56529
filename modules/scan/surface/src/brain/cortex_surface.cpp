#include "facenav/surface/cortex_surface.h"

#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "facenav/core/error.h"
#include "facenav/surface/detailed_cortex.h"
#include "facenav/volume/vtk_image.h"
#include "insideness.h"
#include "mesh/mesh_polydata.h"
#include "scalp/scalp_outline.h"

namespace facenav::surface {
namespace {

/// VTK's connectivity keeps the points of the parts that it drops; removes them.
TriangleMesh withoutLoosePoints(const TriangleMesh& mesh) {
  std::vector<bool> is_used(mesh.vertices_mm.size());
  for (const auto& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) is_used[std::size_t(t[c])] = true;
  return subMesh(mesh, is_used);
}

}  // namespace

TriangleMesh extractCortex(const volume::Volume& tissue, int smoothing_steps, TaskMonitor& monitor) {
  monitor.report("extracting the brain's surface", 0.3);
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputData(volume::toVtkImage(tissue));
  surface->SetValue(0, 0.5);
  surface->ComputeNormalsOff();
  surface->ComputeGradientsOff();
  surface->ComputeScalarsOff();
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputConnection(surface->GetOutputPort());
  largest->SetExtractionModeToLargestRegion();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(largest->GetOutputPort());
  smooth->SetNumberOfIterations(smoothing_steps);
  smooth->SetPassBand(0.1);
  smooth->NormalizeCoordinatesOn();
  smooth->NonManifoldSmoothingOn();
  vtkPolyDataAlgorithm* last =
      smoothing_steps > 0 ? static_cast<vtkPolyDataAlgorithm*>(smooth) : largest.Get();
  last->Update();
  monitor.report("extracting the brain's surface", 0.9);
  TriangleMesh mesh = withoutLoosePoints(toTriangleMesh(*last->GetOutput()));
  if (mesh.triangles.empty()) throw Error("the brain has no surface", {}, "segment the brain, or paint it");
  for (auto& v : mesh.vertices_mm) v = tissue.grid.mri_from_voxel * v;
  mesh.normals = vertexNormals(mesh);
  return mesh;
}

TriangleMesh extractCortex(const volume::Mask& brain, const CortexOptions& options, TaskMonitor& monitor) {
  monitor.report("smoothing the brain's surface", 0);
  return extractCortex(insideness(brain, options.spacing_mm), options.smoothing_steps, monitor);
}

}  // namespace facenav::surface
