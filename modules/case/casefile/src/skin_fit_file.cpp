#include "facenav/casefile/skin_fit_file.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {

void writeSkinFit(const registration::AlignmentResult& alignment, const PointCloud<Camera>& face,
                  const std::filesystem::path& path) {
  FACENAV_EXPECT(alignment.residual_mm.size() == face.size(), "one residual a point");
  constexpr double kFar_mm = 100.0;  // beyond it: no counterpart
  const Eigen::Isometry3d mri_T_camera = alignment.camera_T_mri.isometry().inverse();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkFloatArray> residuals;
  residuals->SetName("residual_mm");
  vtkNew<vtkUnsignedCharArray> inliers;
  inliers->SetName("is_inlier");
  for (std::size_t p = 0; p < face.size(); ++p) {
    if (!(std::abs(alignment.residual_mm[p]) < kFar_mm)) continue;
    const Eigen::Vector3d at = mri_T_camera * face.points_mm[p];
    const vtkIdType number = points->InsertNextPoint(at.data());
    vertices->InsertNextCell(1, &number);
    residuals->InsertNextValue(float(alignment.residual_mm[p]));
    inliers->InsertNextValue(alignment.is_inlier[p] ? 1 : 0);
  }
  vtkNew<vtkPolyData> map;
  map->SetPoints(points);
  map->SetVerts(vertices);
  map->GetPointData()->SetScalars(residuals);
  map->GetPointData()->AddArray(inliers);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(map);
  writer->WriteToOutputStringOn();
  writer->SetDataModeToBinary();
  if (writer->Write() != 1) throw Error("the map of the skin's fit could not be written", path.string());
  writeWholeFile(path, writer->GetOutputString(), FileAccess::owner_only);
}

}  // namespace facenav::casefile
