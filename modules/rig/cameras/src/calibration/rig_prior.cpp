#include "rig_prior.h"

namespace facenav::cameras {
namespace {

// Centring of lens and sensor in C or S mount cameras: 0.1 - 0.3 mm, on sensors 6 - 11 mm wide.
constexpr double kCentreShare = 0.03;
// Decentring of assembled lenses: tangential terms above some 1e-3 are hardly ever reported.
constexpr double kTangential = 1e-3;
// Holds a term at 0: its effect is a millionth of a pixel.
constexpr double kHeld = 1e-8;
// Pixels are square to some 0.1 %; the rest allows for a board printed longer one way than the other.
constexpr double kAspect = 0.01;
// Upper limit of radial terms; no lens needs more. Only affects terms that no view determines (rational
// model).
constexpr double kRadial = 10.0;

constexpr int kFocal = 0, kCentre = 2, kDistortion = 4;

void addCamera(const CameraModel& camera, const cv::Size& size, int first_row, int first_column,
               bool is_tangential, PriorTerms& terms) {
  int row = first_row;
  const auto add = [&](int parameter, double difference, double sigma) {
    terms.residuals[row] = difference / sigma;
    terms.jacobian(row++, first_column + parameter) = 1 / sigma;
  };
  const double middle_x = 0.5 * (size.width - 1), middle_y = 0.5 * (size.height - 1);
  const double centre_px = kCentreShare * std::max(size.width, size.height);
  add(kCentre, camera.k(0, 2) - middle_x, centre_px);
  add(kCentre + 1, camera.k(1, 2) - middle_y, centre_px);
  const double tangential = is_tangential ? kTangential : kHeld;
  for (int i = 0; i < int(camera.distortion.total()); ++i)
    add(kDistortion + i, camera.distortion.at<double>(i), i == 2 || i == 3 ? tangential : kRadial);
  const double fx = camera.k(0, 0), fy = camera.k(1, 1);
  terms.residuals[row] = (fx / fy - 1) / kAspect;
  terms.jacobian(row, first_column + kFocal) = 1 / (fy * kAspect);
  terms.jacobian(row, first_column + kFocal + 1) = -fx / (fy * fy * kAspect);
}

}  // namespace

PriorTerms priorTerms(const CameraModel& left, const CameraModel& right, const cv::Size& size,
                      bool is_tangential) {
  const int rows_left = 3 + int(left.distortion.total()), rows_right = 3 + int(right.distortion.total());
  PriorTerms terms{Eigen::VectorXd::Zero(rows_left + rows_right),
                   Eigen::MatrixXd::Zero(rows_left + rows_right, rows_left + rows_right + 8)};
  addCamera(left, size, 0, 0, is_tangential, terms);
  addCamera(right, size, rows_left, rows_left + 1, is_tangential, terms);
  return terms;
}

}  // namespace facenav::cameras
