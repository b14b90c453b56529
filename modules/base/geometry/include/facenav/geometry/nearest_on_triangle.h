#pragma once
// The point of a triangle nearest to a given point. It tests the regions of corners, edges and face (Ericson,
// Real-Time Collision Detection, 2005, section 5.1.5). All points in one frame and unit.

#include <Eigen/Core>

namespace facenav {

template <class Scalar>
struct TrianglePlace {
  Eigen::Matrix<Scalar, 3, 1> point;
  Eigen::Matrix<Scalar, 3, 1> weights;  // barycentric: of the corners a, b, c; each 0..1, sum 1
};

/// Point of the triangle a b c nearest to `p`. For a triangle without area: one of its points.
template <class Scalar>
inline TrianglePlace<Scalar> nearestOnTriangle(const Eigen::Matrix<Scalar, 3, 1>& p,
                                               const Eigen::Matrix<Scalar, 3, 1>& a,
                                               const Eigen::Matrix<Scalar, 3, 1>& b,
                                               const Eigen::Matrix<Scalar, 3, 1>& c) {
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  const Vector ab = b - a, ac = c - a, ap = p - a;
  const Scalar d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {a, {1, 0, 0}};
  const Vector bp = p - b;
  const Scalar d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {b, {0, 1, 0}};
  const Scalar vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) {  // d1 - d3 is the squared length of the edge
    const Scalar t = d1 / (d1 - d3);
    return {a + t * ab, {1 - t, t, 0}};
  }
  const Vector cp = p - c;
  const Scalar d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {c, {0, 0, 1}};
  const Scalar vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) {
    const Scalar t = d2 / (d2 - d6);
    return {a + t * ac, {1 - t, 0, t}};
  }
  const Scalar va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6 && (d4 > d3 || d5 > d6)) {
    const Scalar t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {b + t * (c - b), {0, 1 - t, t}};
  }
  const Scalar sum = va + vb + vc;
  if (sum <= 0) return {a, {1, 0, 0}};  // no area
  return {a + vb / sum * ab + vc / sum * ac, {va / sum, vb / sum, vc / sum}};
}

}  // namespace facenav
