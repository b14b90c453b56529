#include "evaluate/face_to_face.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "evaluate/camera_pictures.h"
#include "facenav/align/align_from_capture.h"
#include "facenav/cameras/reduced_pair.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/rotation.h"
#include "facenav/measured_face/measured_face.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

constexpr double kBehind_mm = 80.0;
constexpr double kLeast_px_per_mm = 1.0, kUsualDepth_mm = 560.0;  // the scale at which plain skin is measured
constexpr int kCell_px = 4;  // mesh cell, some 3 mm: large enough that no cell in the face is empty
constexpr double kLongestEdge_mm = 12.0;

/// Axes of a head that looks at the camera: x to the patient's right, y anterior, z superior; mm, origin at
/// the camera.
RigidTransform<Mri, Camera> facing() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << -1, 0, 0, 0, 0, -1, 0, -1, 0;
  return RigidTransform<Mri, Camera>::fromIsometry(pose);
}

/// Adds the mean point and normal of each cell of the left picture that contains points.
std::map<std::pair<int, int>, int> addVertices(const stereo::FaceCloud& face, surface::TriangleMesh& mesh) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < face.cloud.size(); ++i)
    members[{int(face.left_px[i].x()) / kCell_px, int(face.left_px[i].y()) / kCell_px}].push_back(i);
  std::map<std::pair<int, int>, int> vertices;
  for (const auto& [cell, points] : members) {
    Eigen::Vector3d p = Eigen::Vector3d::Zero(), normal = p;
    for (const std::size_t i : points) p += face.cloud.points_mm[i], normal += face.cloud.normals[i];
    vertices[cell] = int(mesh.vertices_mm.size());
    mesh.vertices_mm.push_back((facing() * Point<Camera>(p / double(points.size()))).mm);
    mesh.normals.push_back(facing().rotation() * normal.normalized());
  }
  return vertices;
}

/// Adds a triangle that faces the camera, unless an edge is too long.
void addTriangle(surface::TriangleMesh& mesh, int a, int b, int c) {
  const auto at = [&](int i) { return mesh.vertices_mm[std::size_t(i)]; };
  for (const auto& [i, j] : {std::pair{a, b}, {b, c}, {c, a}})
    if ((at(i) - at(j)).norm() > kLongestEdge_mm) return;
  const Eigen::Vector3d normal = (at(b) - at(a)).cross(Eigen::Vector3d(at(c) - at(a)));
  if (normal.dot(mesh.normals[std::size_t(a)]) < 0) std::swap(b, c);
  mesh.triangles.push_back({a, b, c});
}

/// Measures the face from a plain pair as a replacement for a scan's skin, in the axes of `facing`.
surface::ScalpSurface asScalp(const cameras::StereoRig& whole, const cameras::StereoFrame& frame,
                              const face::FaceDetector& detector, TaskMonitor& monitor) {
  const int times = cameras::reductionFor(whole, kUsualDepth_mm, kLeast_px_per_mm);
  const auto rig = cameras::reduced(whole, times);
  const auto small = cameras::reduced(frame, times);
  surface::ScalpSurface scalp;
  scalp.has_face = true;
  const auto at = addVertices(
      measured_face::measurePair(rig, small, small, false, detector, monitor).cloud.face, scalp.mesh);
  for (const auto& [cell, a] : at) {
    const auto [x, y] = cell;
    const auto right = at.find({x + 1, y}), down = at.find({x, y + 1}), across = at.find({x + 1, y + 1});
    if (across == at.end()) continue;
    if (right != at.end()) addTriangle(scalp.mesh, a, right->second, across->second);
    if (down != at.end()) addTriangle(scalp.mesh, a, across->second, down->second);
  }
  return scalp;
}

/// Alignment in the shared camera.
struct Pose {
  Eigen::Isometry3d shared_T_mri;
  registration::AlignmentResult result;
};

struct Faces {
  Context& context;
  std::unique_ptr<registration::Aligner> aligner;
  std::shared_ptr<const face::FaceDetector> detector;

  Pose align(const surface::ScalpSurface& scalp, const cameras::StereoRig& rig,
             const cameras::StereoFrame& frame, bool is_right_shared) const {
    const std::vector<guidance::Target> none;
    const auto outcome = steps::alignFromCapture(rig, {frame, frame}, measured_face::AlignedFrom::plain,
                                                 {scalp, *aligner, *detector, none}, context.monitor);
    const Eigen::Isometry3d shared_T_left =
        is_right_shared ? rig.right_T_left.isometry() : Eigen::Isometry3d::Identity();
    return {shared_T_left * outcome.result.camera_T_mri.isometry(), outcome.result};
  }
};

cameras::StereoFrame frameOf(const std::map<std::string, fs::path>& pictures, const std::string& rig,
                             const std::string& moment) {
  cameras::StereoFrame frame;
  frame.left = readGrey(pictures.at(rig.substr(0, 1) + "_" + moment));
  frame.right = readGrey(pictures.at(rig.substr(1, 1) + "_" + moment));
  return frame;
}

/// Compares two poses at the point `at_mri_mm`.
void compare(const Pose& a, const Pose& b, const Eigen::Vector3d& at_mri_mm, FaceAgreement& agreement) {
  agreement.off_mm = (a.shared_T_mri * at_mri_mm - b.shared_T_mri * at_mri_mm).norm();
  agreement.off_deg =
      rotationAngle(a.shared_T_mri.linear().transpose() * b.shared_T_mri.linear()) * kDegPerRad;
  agreement.bound_mm = std::hypot(a.result.errorBound_mm(Point<Mri>(at_mri_mm)),
                                  b.result.errorBound_mm(Point<Mri>(at_mri_mm)));
}

Eigen::Vector3d behind(const surface::ScalpSurface& face) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& p : face.mesh.vertices_mm) middle += p / double(face.mesh.vertices_mm.size());
  return middle - kBehind_mm * Eigen::Vector3d::UnitY();
}

}  // namespace

std::vector<FaceAgreement> alignToMeasuredFaces(Context& context, const std::vector<fs::path>& people,
                                                const fs::path& rig_folder, const std::string& aligner) {
  const Faces faces{context, context.registrations.aligners.create(aligner),
                    context.registrations.face_detector()};
  const auto rigs = rigsIn(rig_folder);
  std::vector<FaceAgreement> all;
  for (const auto& person : people)
    for (const auto& [left, left_rig] : rigs)
      for (const auto& [right, right_rig] : rigs) {
        if (left[1] != right[0]) continue;  // no shared camera
        const auto pictures = picturesIn(person);
        for (const auto& [name, rig] : {std::pair{&left, &left_rig}, {&right, &right_rig}})
          for (const auto& scanned : momentsOf(pictures, (*name)[0], (*name)[1])) {
            const auto scalp =
                asScalp(*rig, frameOf(pictures, *name, scanned), *faces.detector, context.monitor);
            for (const auto& seen : momentsOf(pictures, left[0], left[1])) {
              if (seen == scanned) continue;
              context.monitor.report("aligning faces", 0.0);
              FaceAgreement agreement{person.filename().string(), *name, scanned, seen};
              try {
                compare(faces.align(scalp, left_rig, frameOf(pictures, left, seen), true),
                        faces.align(scalp, right_rig, frameOf(pictures, right, seen), false), behind(scalp),
                        agreement);
              } catch (const Cancelled&) {
                throw;
              } catch (const Error& refusal) {
                agreement.refusal = refusal.what();
              }
              all.push_back(agreement);
            }
          }
      }
  return all;
}

std::string facesTable(const std::vector<FaceAgreement>& agreements) {
  std::vector<double> off_mm, off_deg;
  int inside = 0, refused = 0;
  std::string rows;
  for (const auto& a : agreements) {
    const std::string name =
        "| " + a.person + ", face of " + a.scanned_by + " at " + a.scanned + ", seen at " + a.seen + " | ";
    if (!a.refusal.empty()) {
      ++refused;
      rows += name + "refused: " + a.refusal + " | |\n";
      continue;
    }
    off_mm.push_back(a.off_mm), off_deg.push_back(a.off_deg);
    inside += a.off_mm <= a.bound_mm;
    rows += name + formatted("%.2f mm, %.2f deg | %.2f mm |\n", a.off_mm, a.off_deg, a.bound_mm);
  }
  if (agreements.empty()) return "";
  std::string text = formatted("\nTwo pairs aligned to one measured face: %zu of %zu aligned, %d refused",
                               off_mm.size(), agreements.size(), refused);
  if (!off_mm.empty())
    text +=
        formatted("; median %.2f mm, %.2f deg, largest %.2f mm, %.2f deg; %d inside both bounds",
                  upperMedian(off_mm), upperMedian(off_deg), *std::max_element(off_mm.begin(), off_mm.end()),
                  *std::max_element(off_deg.begin(), off_deg.end()), inside);
  return text + ".\n\n| face and moment | the two apart | both bounds |\n|---|---|---|\n" + rows;
}

}  // namespace facenav::app
