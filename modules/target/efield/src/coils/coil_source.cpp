#include "facenav/efield/coil_source.h"

#include <cmath>

#include "facenav/core/parallel_for.h"

namespace facenav::efield {
namespace {

constexpr double kMu0By4Pi = 1e-7;  // T m / A
constexpr double kMetresPerMm = 1e-3;

/// Sum over the sources at each point, in parallel.
template <class Result, class Term>
Result summed(Result result, const Eigen::Matrix3Xd& sources_mm, const Eigen::Matrix3Xd& points_mm,
              const Term& term) {
  parallelRanges(0, int(points_mm.cols()), [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      for (Eigen::Index k = 0; k < sources_mm.cols(); ++k) {
        const Eigen::Vector3d away_m = kMetresPerMm * (points_mm.col(i) - sources_mm.col(k));
        term(result, i, k, away_m, 1 / away_m.norm());
      }
  });
  return result;
}

Eigen::Matrix3Xd zeroVectors(Eigen::Index count) { return Eigen::Matrix3Xd::Zero(3, count); }

}  // namespace

Eigen::Matrix3Xd potentialOf(const CoilDipoles& dipoles, const Eigen::Matrix3Xd& points_mm) {
  const auto& m = dipoles.moments_Am2;
  return summed(zeroVectors(points_mm.cols()), dipoles.positions_mm, points_mm,
                [&](auto& sum, int i, Eigen::Index k, const Eigen::Vector3d& d, double inverse) {
                  const Eigen::Vector3d moment = m.col(k);
                  sum.col(i) += kMu0By4Pi * std::pow(inverse, 3) * moment.cross(d);
                });
}

Eigen::Matrix3Xd potentialOf(const LineElements& lines, const Eigen::Matrix3Xd& points_mm) {
  return summed(zeroVectors(points_mm.cols()), lines.positions_mm, points_mm,
                [&](auto& sum, int i, Eigen::Index k, const Eigen::Vector3d&, double inverse) {
                  sum.col(i) += kMu0By4Pi * inverse * kMetresPerMm * lines.lengths_mm.col(k);
                });
}

Eigen::VectorXd fluxOf(const CoilDipoles& dipoles, const Eigen::Matrix3Xd& points_mm) {
  const auto& m = dipoles.moments_Am2;
  return summed(Eigen::VectorXd(Eigen::VectorXd::Zero(points_mm.cols())), dipoles.positions_mm, points_mm,
                [&](auto& sum, int i, Eigen::Index k, const Eigen::Vector3d& d, double inverse) {
                  const double along = m.col(k).dot(d) * inverse * inverse;
                  sum[i] += kMu0By4Pi * std::pow(inverse, 3) * (3 * along * d.z() - m(2, k));
                });
}

Eigen::VectorXd fluxOf(const LineElements& lines, const Eigen::Matrix3Xd& points_mm) {
  return summed(Eigen::VectorXd(Eigen::VectorXd::Zero(points_mm.cols())), lines.positions_mm, points_mm,
                [&](auto& sum, int i, Eigen::Index k, const Eigen::Vector3d& d, double inverse) {
                  const Eigen::Vector3d length_m = kMetresPerMm * lines.lengths_mm.col(k);
                  sum[i] += kMu0By4Pi * std::pow(inverse, 3) * length_m.cross(d).z();
                });
}

CoilDipoles dipolesOf(const LineElements& lines, double spacing_mm) {
  CoilDipoles coil;
  if (lines.positions_mm.cols() == 0) return coil;
  // The point lies at the winding's upper edge: the triangles then stay inside a casing that bends to the
  // head.
  const Eigen::RowVectorXd weights = lines.lengths_mm.colwise().norm();
  Eigen::Vector3d apex_mm = lines.positions_mm * weights.transpose() / weights.sum();
  apex_mm.z() = lines.positions_mm.row(2).minCoeff();
  std::vector<Eigen::Vector3d> places_mm, moments;
  for (Eigen::Index k = 0; k < lines.positions_mm.cols(); ++k) {
    const Eigen::Vector3d ray_mm = lines.positions_mm.col(k) - apex_mm, length_mm = lines.lengths_mm.col(k);
    const int strips = std::max(1, int(std::ceil(ray_mm.norm() / spacing_mm)));
    for (int s = 0; s < strips; ++s) {
      const double from = double(s) / strips, to = double(s + 1) / strips;
      const double area = (to * to - from * from) / 2;
      const double middle = (std::pow(to, 3) - std::pow(from, 3)) / 3 / area;
      places_mm.push_back(apex_mm + middle * ray_mm);
      moments.push_back(area * kMetresPerMm * kMetresPerMm * ray_mm.cross(length_mm));
    }
  }
  coil.positions_mm =
      Eigen::Map<const Eigen::Matrix3Xd>(places_mm[0].data(), 3, Eigen::Index(places_mm.size()));
  coil.moments_Am2 = Eigen::Map<const Eigen::Matrix3Xd>(moments[0].data(), 3, Eigen::Index(moments.size()));
  return coil;
}

CoilDipoles dipolesOf(const CoilSource& source) {
  CoilDipoles all = source.dipoles;
  const auto add = [&](const CoilDipoles& more) {
    const Eigen::Index before = all.positions_mm.cols(), count = more.positions_mm.cols();
    all.positions_mm.conservativeResize(3, before + count);
    all.moments_Am2.conservativeResize(3, before + count);
    all.positions_mm.rightCols(count) = more.positions_mm;
    all.moments_Am2.rightCols(count) = more.moments_Am2;
  };
  add(dipolesOf(source.lines));
  for (const auto& grid : source.grids) add(dipolesOf(grid));
  return all;
}

}  // namespace facenav::efield
