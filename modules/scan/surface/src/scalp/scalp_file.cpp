// scalp.vtp: the mesh with its normals; everything else of the scalp as field data.

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/surface/scalp_surface.h"
#include "mesh/mesh_polydata.h"

namespace facenav::surface {
namespace {

constexpr char kHasFace[] = "has_face", kHasCutEar[] = "has_cut_ear", kFindings[] = "findings",
               kFieldOfView[] = "field_of_view_mm", kDoubt[] = "doubt_mm",
               kMeasurement[] = "face_measurement";

Error malformed(const std::filesystem::path& path, const std::string& what) {
  return Error("not a scalp file: " + what, path.string(), "run 'facenav prepare' again");
}

vtkSmartPointer<vtkUnsignedCharArray> flag(const char* name, bool value) {
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(name);
  array->InsertNextValue(value ? 1 : 0);
  return array;
}

constexpr double kUnknownSize = -1;

/// points, point_mm, sight_mm, whole_mm, size; -1: size unknown
vtkSmartPointer<vtkDoubleArray> asField(const FaceMeasurement& face) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(kMeasurement);
  array->SetNumberOfComponents(5);
  const double row[5] = {double(face.points), face.point_mm, face.sight_mm, face.whole_mm,
                         face.size.value_or(kUnknownSize)};
  array->InsertNextTuple(row);
  return array;
}

std::optional<FaceMeasurement> readMeasurement(vtkFieldData& fields, const std::filesystem::path& path) {
  auto* array = vtkDataArray::SafeDownCast(fields.GetAbstractArray(kMeasurement));
  if (!array) return std::nullopt;
  if (array->GetNumberOfComponents() != 5 || array->GetNumberOfTuples() != 1)
    throw malformed(path, "face_measurement needs 5 components");
  double row[5];
  array->GetTuple(0, row);
  FaceMeasurement face{int(row[0]), row[1], row[2], row[3]};
  if (row[4] != kUnknownSize) face.size = row[4];
  for (const double value : {row[0], row[1], row[2], row[3], face.size.value_or(0.0)})
    if (!(value >= 0) || !std::isfinite(value))
      throw malformed(path, "face_measurement is no standard error");
  return face;
}

}  // namespace

void writeScalp(const ScalpSurface& scalp, const std::filesystem::path& path) {
  const auto poly_data = toPolyData(scalp.mesh);
  vtkNew<vtkStringArray> findings;
  findings->SetName(kFindings);
  for (const auto& finding : scalp.findings) findings->InsertNextValue(finding);
  vtkNew<vtkDoubleArray> planes;
  planes->SetName(kFieldOfView);
  planes->SetNumberOfComponents(6);
  for (const auto& [point, normal] : scalp.field_of_view) {
    const double row[6] = {point.mm[0], point.mm[1], point.mm[2], normal.v[0], normal.v[1], normal.v[2]};
    planes->InsertNextTuple(row);
  }
  if (!scalp.doubt_mm.empty()) addPointValues(*poly_data, kDoubt, scalp.doubt_mm);
  poly_data->GetFieldData()->AddArray(flag(kHasFace, scalp.has_face));
  poly_data->GetFieldData()->AddArray(flag(kHasCutEar, scalp.has_cut_ear));
  if (!scalp.findings.empty()) poly_data->GetFieldData()->AddArray(findings);
  if (!scalp.field_of_view.empty()) poly_data->GetFieldData()->AddArray(planes);
  if (scalp.measurement) poly_data->GetFieldData()->AddArray(asField(*scalp.measurement));
  writePolyData(*poly_data, path);
}

ScalpSurface readScalp(const std::filesystem::path& path) {
  const auto poly_data = readPolyData(path);
  ScalpSurface scalp;
  scalp.mesh = toTriangleMesh(*poly_data);
  if (scalp.mesh.triangles.empty()) throw malformed(path, "no triangles");
  if (auto* doubt = poly_data->GetPointData()->GetArray(kDoubt)) {
    if (doubt->GetNumberOfComponents() != 1) throw malformed(path, "doubt_mm needs 1 component");
    for (vtkIdType v = 0; v < doubt->GetNumberOfTuples(); ++v)
      scalp.doubt_mm.push_back(float(doubt->GetTuple1(v)));
  }
  vtkFieldData& fields = *poly_data->GetFieldData();
  auto* has_face = vtkDataArray::SafeDownCast(fields.GetAbstractArray(kHasFace));
  if (!has_face || has_face->GetNumberOfTuples() != 1) throw malformed(path, "no field has_face");
  scalp.has_face = has_face->GetTuple1(0) != 0;
  // Files written before this field existed lack it.
  if (auto* ear = vtkDataArray::SafeDownCast(fields.GetAbstractArray(kHasCutEar));
      ear && ear->GetNumberOfTuples() == 1)
    scalp.has_cut_ear = ear->GetTuple1(0) != 0;
  if (auto* findings = vtkStringArray::SafeDownCast(fields.GetAbstractArray(kFindings)))
    for (vtkIdType f = 0; f < findings->GetNumberOfValues(); ++f)
      scalp.findings.push_back(findings->GetValue(f));
  if (scalp.has_cut_ear && scalp.findings.empty()) throw malformed(path, "a cut ear without a finding");
  if (auto* planes = vtkDataArray::SafeDownCast(fields.GetAbstractArray(kFieldOfView))) {
    if (planes->GetNumberOfComponents() != 6) throw malformed(path, "field_of_view_mm needs 6 components");
    for (vtkIdType p = 0; p < planes->GetNumberOfTuples(); ++p) {
      double row[6];
      planes->GetTuple(p, row);
      scalp.field_of_view.emplace_back(Point<Mri>(row[0], row[1], row[2]),
                                       Direction<Mri>(Eigen::Vector3d(row[3], row[4], row[5])));
    }
  }
  scalp.measurement = readMeasurement(fields, path);
  return scalp;
}

ScalpSurface asStored(ScalpSurface scalp) {
  // Uses the same conversion as the file: with a loop of casts to float and back, GCC 12's vectoriser left
  // the last normals in double precision.
  scalp.mesh.normals = toTriangleMesh(*toPolyData(scalp.mesh)).normals;
  for (auto& [point, normal] : scalp.field_of_view) normal = Direction<Mri>(Eigen::Vector3d(normal.v));
  return scalp;
}

}  // namespace facenav::surface
