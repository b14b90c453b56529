#include "face_mask.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "optics/noise_field.h"
#include "skin_mesh.h"

namespace facenav::room {
namespace {

constexpr double kGrid_mm = 2.0, kHalfWidth_mm = 60.0, kOff_mm = 2.0, kSpan_mm = 26.0, kPleat_mm = 11.0;
constexpr float kNowhere = -1e4f;

/// The cloth seen from the front: a grid over x and z (Mri); each node has the y of the skin's foremost
/// point.
struct Sheet {
  Eigen::Vector2d low_mm;  // x, z of the first node
  cv::Mat y_mm;            // float, one row per z; kNowhere: no skin there
};

Sheet skinFromTheFront(const VirtualPatient& patient) {
  const Eigen::Vector3d &bridge = patient.landmarks68_mm[28], &chin = patient.landmarks68_mm[8];
  Sheet sheet;
  sheet.low_mm = {bridge.x() - kHalfWidth_mm, chin.z() - 14.0};
  const cv::Size size(int(2 * kHalfWidth_mm / kGrid_mm) + 1,
                      int((bridge.z() - sheet.low_mm.y()) / kGrid_mm) + 1);
  sheet.y_mm = cv::Mat(size, CV_32F, cv::Scalar(kNowhere));
  for (const auto& p_mm : patient.skin.vertices_mm) {
    const int column = int(std::lround((p_mm.x() - sheet.low_mm.x()) / kGrid_mm)),
              row = int(std::lround((p_mm.z() - sheet.low_mm.y()) / kGrid_mm));
    if (column < 0 || row < 0 || column >= size.width || row >= size.height || p_mm.y() < chin.y() - 60.0)
      continue;
    float& y = sheet.y_mm.at<float>(row, column);
    y = std::max(y, float(p_mm.y()));
  }
  return sheet;
}

/// Tightens the cloth: hollows are closed, edges rounded.
void tauten(Sheet& sheet) {
  const int reach = int(kSpan_mm / kGrid_mm);
  const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * reach + 1, 2 * reach + 1});
  cv::morphologyEx(sheet.y_mm, sheet.y_mm, cv::MORPH_CLOSE, disc);
  cv::Mat smooth;
  cv::GaussianBlur(sheet.y_mm, smooth, {}, 2.5);
  sheet.y_mm = cv::max(sheet.y_mm, smooth) + kOff_mm;
}

/// True inside the outline of the cloth, which is narrower at the nose bridge and under the chin.
bool isCloth(const Sheet& sheet, int row, int column) {
  if (sheet.y_mm.at<float>(row, column) < 0.5f * kNowhere) return false;
  const double aside = std::abs(column * kGrid_mm - kHalfWidth_mm), up = row * kGrid_mm,
               height = (sheet.y_mm.rows - 1) * kGrid_mm;
  return up < height - 0.35 * aside && up > 0.2 * aside;
}

surface::TriangleMesh meshOf(const Sheet& sheet) {
  surface::TriangleMesh mesh;
  cv::Mat number(sheet.y_mm.size(), CV_32S, cv::Scalar(-1));
  for (int row = 0; row < number.rows; ++row)
    for (int column = 0; column < number.cols; ++column) {
      if (!isCloth(sheet, row, column)) continue;
      number.at<int>(row, column) = int(mesh.vertices_mm.size());
      mesh.vertices_mm.push_back({sheet.low_mm.x() + column * kGrid_mm,
                                  double(sheet.y_mm.at<float>(row, column)),
                                  sheet.low_mm.y() + row * kGrid_mm});
    }
  for (int row = 0; row + 1 < number.rows; ++row)
    for (int column = 0; column + 1 < number.cols; ++column) {
      const int a = number.at<int>(row, column), b = number.at<int>(row, column + 1),
                c = number.at<int>(row + 1, column), d = number.at<int>(row + 1, column + 1);
      if (a < 0 || b < 0 || c < 0 || d < 0) continue;
      mesh.triangles.push_back({a, c, b});  // counter-clockwise seen from the front (+y)
      mesh.triangles.push_back({b, c, d});
    }
  mesh.normals = vertexNormals(mesh.vertices_mm, mesh.triangles);
  return mesh;
}

class ClothLook : public Look {
 public:
  Reflectance at(const SurfacePoint& point) const override {
    const double fold = std::fmod(point.p_object_mm.z() + 1000.0, kPleat_mm) / kPleat_mm;
    const float pleat = fold < 0.12 ? 0.75f : 1.f;
    const float weave = 1.f + 0.03f * sharedNoise().at(point.p_object_mm, 1.2);
    return {0.55f * pleat * weave, 0.005f};
  }
};

}  // namespace

surface::TriangleMesh faceMask(const VirtualPatient& patient) {
  if (patient.landmarks68_mm.empty()) return {};
  Sheet sheet = skinFromTheFront(patient);
  tauten(sheet);
  return meshOf(sheet);
}

std::shared_ptr<const Look> makeClothLook() { return std::make_shared<ClothLook>(); }

}  // namespace facenav::room
