// The dipoles that stand for a vector potential on a grid. Both are compared by the same differences between
// neighbouring nodes, so that the grid's spacing adds no error of its own.

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/efield/coil_source.h"
#include "layer_fit.h"

namespace facenav::efield {
namespace {

constexpr double kNearest_mm = 8, kFarthest_mm = 14;  // below the contact face: nodes that are compared
constexpr double kLayer_mm = -6.5;                    // the dipoles' plane, z of the frame Coil
constexpr double kDeeper_mm = 8;                      // there the field is weaker, or the grid is upside down
constexpr double kPitch_mm = 8;
constexpr double kMargin_mm = 40;  // nodes this far beside the dipoles are compared, too
constexpr int kMostDipoles = 900, kMostNodes = 4000;
constexpr double kRidge = 1e-4;
constexpr double kLargestResidual = 0.1;  // of the flux; right files leave less than 0.02

/// Nodes with all six neighbours, and the differences that give the curl along z.
class CurlNodes {
 public:
  CurlNodes(const PotentialGrid& grid, double nearest_mm, double farthest_mm) : grid_(grid) {
    voxel_from_coil_ = grid.coil_from_voxel.linear().inverse();
    for (int k = 1; k + 1 < grid.size[2]; ++k)
      for (int j = 1; j + 1 < grid.size[1]; ++j)
        for (int i = 1; i + 1 < grid.size[0]; ++i) {
          const Eigen::Vector3d p_mm = grid.coil_from_voxel * Eigen::Vector3d(i, j, k);
          if (p_mm.z() >= nearest_mm && p_mm.z() <= farthest_mm) nodes_.push_back({{i, j, k}, p_mm});
        }
  }
  struct Node {
    Eigen::Vector3i ijk;
    Eigen::Vector3d p_mm;
  };
  std::vector<Node>& nodes() { return nodes_; }

  /// Curl along z per mm at a node, of a potential given by node index.
  template <class PotentialAt>
  double curlAt(const Node& node, const PotentialAt& potential) const {
    Eigen::Matrix3d by_voxel;  // column c: change along voxel axis c
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector3i step = Eigen::Vector3i::Unit(c);
      by_voxel.col(c) = (potential(node.ijk + step) - potential(node.ijk - step)) / 2;
    }
    const Eigen::Matrix3d by_mm = by_voxel * voxel_from_coil_;
    return by_mm(1, 0) - by_mm(0, 1);
  }
  double curlOfGrid(const Node& node) const {
    return curlAt(node, [this](const Eigen::Vector3i& n) -> Eigen::Vector3d {
      return grid_.potential_Tm.col(grid_.index(n[0], n[1], n[2]));
    });
  }
  /// The same of a dipole along z at a place.
  double curlOfDipole(const Node& node, const Eigen::Vector3d& place_mm) const {
    return curlAt(node, [&](const Eigen::Vector3i& n) -> Eigen::Vector3d {
      const Eigen::Vector3d away_m = 1e-3 * (grid_.coil_from_voxel * n.cast<double>() - place_mm);
      return 1e-7 * Eigen::Vector3d(-away_m.y(), away_m.x(), 0) / std::pow(away_m.norm(), 3);
    });
  }

 private:
  const PotentialGrid& grid_;
  Eigen::Matrix3d voxel_from_coil_;
  std::vector<Node> nodes_;
};

/// Box around the nodes where the flux is at least a twentieth of its largest value.
Eigen::AlignedBox2d boxOfCoil(const std::vector<CurlNodes::Node>& nodes, const Eigen::VectorXd& curl) {
  const double least = curl.cwiseAbs().maxCoeff() / 20;
  Eigen::AlignedBox2d box;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (std::abs(curl[Eigen::Index(n)]) >= least) box.extend(Eigen::Vector2d(nodes[n].p_mm.head<2>()));
  return {box.min().array() - kPitch_mm, box.max().array() + kPitch_mm};
}

Eigen::VectorXd curlsOfGrid(const CurlNodes& differences, const std::vector<CurlNodes::Node>& nodes) {
  Eigen::VectorXd curl{Eigen::Index(nodes.size())};
  for (std::size_t n = 0; n < nodes.size(); ++n) curl[Eigen::Index(n)] = differences.curlOfGrid(nodes[n]);
  return curl;
}

/// Every so many of the nodes near the box, kMostNodes at most.
std::vector<CurlNodes::Node> chosen(const std::vector<CurlNodes::Node>& nodes, Eigen::AlignedBox2d box) {
  box = {box.min().array() - kMargin_mm, box.max().array() + kMargin_mm};
  std::vector<CurlNodes::Node> near;
  for (const auto& node : nodes)
    if (box.contains(Eigen::Vector2d(node.p_mm.head<2>()))) near.push_back(node);
  if (near.size() <= std::size_t(kMostNodes)) return near;
  std::vector<CurlNodes::Node> some;
  const double step = double(near.size()) / kMostNodes;
  for (int n = 0; n < kMostNodes; ++n) some.push_back(near[std::size_t(n * step)]);
  return some;
}

/// Throws Error if the flux grows with the distance from the contact face.
void requireWeakerBelow(const PotentialGrid& grid, double largest) {
  CurlNodes deeper(grid, kNearest_mm + kDeeper_mm, kFarthest_mm + kDeeper_mm);
  const auto& nodes = deeper.nodes();
  if (nodes.empty() || curlsOfGrid(deeper, nodes).cwiseAbs().maxCoeff() < largest) return;
  throw Error("the coil's field grows with the distance from the contact face", grid.file,
              "check the file's frame: the coil lies at z < 0, z points into the head");
}

}  // namespace

CoilDipoles dipolesOf(const PotentialGrid& grid) {
  CurlNodes differences(grid, kNearest_mm, kFarthest_mm);
  const auto& all = differences.nodes();
  if (all.size() < 100)
    throw Error("the coil's field is not sampled 8 to 14 mm below the contact face (z = 0)", grid.file,
                "use the coil's .ccd or .tcd file");
  const Eigen::VectorXd curl = curlsOfGrid(differences, all);
  if (!(curl.cwiseAbs().maxCoeff() > 0))
    throw Error("the coil's field has no magnetic flux below the contact face", grid.file, "check the file");
  requireWeakerBelow(grid, curl.cwiseAbs().maxCoeff());
  const auto box = boxOfCoil(all, curl);
  const auto nodes = chosen(all, box);
  const Eigen::Vector2d size_mm = box.sizes();
  const double pitch_mm = std::max(kPitch_mm, std::sqrt(size_mm.prod() / kMostDipoles));
  CoilDipoles coil;
  coil.positions_mm = planePoints(box.min(), box.max(), kLayer_mm, pitch_mm);
  Eigen::MatrixXd matrix{Eigen::Index(nodes.size()), coil.positions_mm.cols()};
  for (Eigen::Index c = 0; c < matrix.cols(); ++c)
    for (Eigen::Index n = 0; n < matrix.rows(); ++n)
      matrix(n, c) = differences.curlOfDipole(nodes[std::size_t(n)], coil.positions_mm.col(c));
  const Eigen::VectorXd wanted = curlsOfGrid(differences, nodes);
  const Eigen::VectorXd moments = leastSquares(matrix, wanted, kRidge);
  const double residual = (matrix * moments - wanted).norm() / wanted.norm();
  if (!(residual <= kLargestResidual))
    throw Error(
        formatted(
            "the coil's field below the contact face is not that of a coil behind it (%.0f %% are left)",
            100 * residual),
        grid.file, "use the coil's .ccd or .tcd file, and check that z points into the head");
  coil.moments_Am2.setZero(3, moments.size());
  coil.moments_Am2.row(2) = moments.transpose();
  return coil;
}

}  // namespace facenav::efield
