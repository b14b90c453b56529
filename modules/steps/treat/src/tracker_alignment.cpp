#include "facenav/treat/tracker_alignment.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "facenav/core/json_reader.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/geometry/rigid_fit.h"
#include "facenav/measured_face/skin_model.h"
#include "facenav/surface/closest_point.h"

namespace facenav::steps {
namespace {

constexpr double kLargestError_mm = 50;  // a larger one says that nothing is known
constexpr double kMostResidual = 3;      // residuals beyond three standard errors are mistakes
constexpr double kFromSkin_mm = 15;      // the skin of the MRI, and a pointer's tip pressed on hair or skin

double readError_mm(const JsonReader& json) {
  const auto value = json.at("error_mm");
  const double error_mm = value.number();
  if (!(error_mm > 0 && error_mm <= kLargestError_mm))
    value.refuse("the root mean square error in millimetres (above 0, at most 50) was expected");
  return error_mm;
}

std::vector<TouchedPoint> readPoints(const JsonReader& json) {
  std::vector<TouchedPoint> points;
  std::set<std::string> names;
  for (const auto& element : json.elements()) {
    TouchedPoint point;
    point.name = element.at("name").text();
    point.in_mri = readPoint<Mri>(element.at("mri_mm"));
    point.in_subject_mm = readPoint<Head>(element.at("subject_mm")).mm;
    if (!names.insert(point.name).second) element.at("name").refuse("each point once was expected");
    points.push_back(point);
  }
  if (points.size() < 3) json.refuse("at least three points were expected");
  return points;
}

/// Covariance of the pose by points with independent errors, at the image of Mri's origin.
Matrix6d covarianceBy(const std::vector<TouchedPoint>& points, const Eigen::Isometry3d& subject_T_mri,
                      double sigma_mm) {
  Matrix6d information = Matrix6d::Zero();
  for (const auto& point : points) {
    const Eigen::Vector3d arm_mm = subject_T_mri.linear() * point.in_mri.mm;
    Eigen::Matrix<double, 3, 6> moved;
    moved << 0, arm_mm.z(), -arm_mm.y(), 1, 0, 0, -arm_mm.z(), 0, arm_mm.x(), 0, 1, 0, arm_mm.y(),
        -arm_mm.x(), 0, 0, 0, 1;
    information += moved.transpose() * moved;
  }
  return sigma_mm * sigma_mm * information.inverse();
}

/// Root mean square residual if two points were exchanged; large if the file's order is certain.
double exchangedRms_mm(const std::vector<Eigen::Vector3d>& from_mm, std::vector<Eigen::Vector3d> to_mm) {
  double best_mm = 1e9;
  for (std::size_t i = 0; i < to_mm.size(); ++i)
    for (std::size_t j = i + 1; j < to_mm.size(); ++j) {
      std::swap(to_mm[i], to_mm[j]);
      best_mm = std::min(best_mm, fitRigidPoints(from_mm, to_mm).rms_mm);
      std::swap(to_mm[i], to_mm[j]);
    }
  return best_mm;
}

void fitPoints(TrackerAlignment& alignment, const JsonReader& json) {
  std::vector<Eigen::Vector3d> subject_mm, mri_mm;
  for (const auto& point : alignment.points) {
    subject_mm.push_back(point.in_subject_mm);
    mri_mm.push_back(point.in_mri.mm);
  }
  RigidFit fit{Eigen::Isometry3d::Identity(), 0};
  try {
    fit = fitRigidPoints(subject_mm, mri_mm);
  } catch (const Error& fault) {
    json.refuse(fault.what());
  }
  // The fit of N points, each with an error of e, leaves e sqrt(1 - 2 / N) (Fitzpatrick, West 2001).
  const double expected_mm = alignment.error_mm * std::sqrt(1 - 2 / double(alignment.points.size()));
  if (fit.rms_mm > kMostResidual * expected_mm)
    json.refuse(
        formatted("the points do not fit each other (%.1f mm rms, %.1f expected by error_mm): points "
                  "are exchanged, or a frame is mirrored or not in millimetres",
                  fit.rms_mm, expected_mm));
  alignment.rms_mm = fit.rms_mm;
  alignment.mri_T_subject = RigidTransform<Mri, Head>::fromIsometry(fit.to_T_from);
  const double excess = std::max(1.0, fit.rms_mm / expected_mm);
  alignment.covariance =
      covarianceBy(alignment.points, fit.to_T_from.inverse(), excess * alignment.error_mm / std::sqrt(3.0));
  if (exchangedRms_mm(subject_mm, mri_mm) <= kMostResidual * expected_mm)
    alignment.cautions.push_back(
        "the touched points fit as well with two of them exchanged (left and right?): touch a point apart "
        "from "
        "them, such as the vertex");
}

}  // namespace

TrackerAlignment readTrackerAlignment(const std::filesystem::path& path) {
  const auto json = JsonReader::readFile(path);
  TrackerAlignment alignment;
  alignment.error_mm = readError_mm(json);
  if (json.has("points") && json.has("mri_T_subject"))
    json.at("points").refuse("either points or mri_T_subject was expected, not both");
  if (json.has("points")) {
    alignment.points = readPoints(json.at("points"));
    fitPoints(alignment, json.at("points"));
    return alignment;
  }
  alignment.mri_T_subject = readTransform<Mri, Head>(json.at("mri_T_subject"));
  alignment.covariance.diagonal().tail<3>().setConstant(alignment.error_mm * alignment.error_mm / 3);
  return alignment;
}

void writeTouchedPoints(const std::vector<TouchedPoint>& points, double error_mm,
                        const std::filesystem::path& path) {
  auto all = nlohmann::ordered_json::array();
  for (const auto& point : points)
    all.push_back({{"name", point.name},
                   {"mri_mm", rowMajor(point.in_mri)},
                   {"subject_mm", rowMajor(Point<Head>(point.in_subject_mm))}});
  const nlohmann::ordered_json json{{"points", all}, {"error_mm", error_mm}};
  WholeFile file(path);
  std::ofstream(file.temporaryPath()) << json.dump(1) << "\n";
  readTrackerAlignment(file.temporaryPath());
  file.commit();
}

void requireOnSkin(const TrackerAlignment& alignment, const surface::ScalpSurface& scalp) {
  if (alignment.points.empty()) return;
  const surface::ClosestPoint skin(scalp.mesh);
  for (const auto& point : alignment.points) {
    const double off_mm = skin.nearest(point.in_mri).distance_mm;
    if (off_mm > kFromSkin_mm)
      throw Error(
          formatted("its point '%s' lies %.0f mm from the skin of the case", point.name.c_str(), off_mm),
          "the tracker's alignment", "is it of this head, and in RAS?");
  }
}

AlignmentOutcome outcomeOf(const TrackerAlignment& alignment, const casefile::CaseStore& store) {
  const auto scalp = std::make_shared<surface::ScalpSurface>(store.scalp());
  requireOnSkin(alignment, *scalp);
  AlignmentOutcome outcome;
  outcome.result.camera_T_mri = alignment.mri_T_subject.inverse().reframe<Camera, Mri>();
  outcome.result.covariance = alignment.covariance;
  outcome.result.rms_mm = alignment.rms_mm;
  outcome.result.points = int(alignment.points.size());
  outcome.result.inlier_fraction = 1;
  outcome.result.cautions = alignment.cautions;
  outcome.skin = scalp;
  outcome.scalp = registration::keptScalpField(measured_face::skinModel(*scalp), store.scalpField());
  return outcome;
}

}  // namespace facenav::steps
