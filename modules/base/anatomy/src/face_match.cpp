#include "facenav/anatomy/face_match.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "mean_face.h"

namespace facenav::anatomy {
namespace {

constexpr double kLeastSeen =
    0.35;  // share of the mean face with skin: a scan that ends at mid-nose has 0.65
constexpr double kLeastBelow_mm = 15;  // skin below the nasion

/// The surface through the surroundings: constant, slopes and curvatures.
using Terms = Eigen::Matrix<double, 5, 1>;
Terms termsAt(int row, int column) {
  const double x = MeanFace::across_mm(column) / MeanFace::kReach_mm,
               z = MeanFace::up_mm(row) / MeanFace::kReach_mm;
  return (Terms() << 1, x, z, x * x, z * z).finished();
}

/// Sums over the cells with skin: moments of the surface's terms, the mean face (t) and the relief (h).
struct Moments {
  Eigen::Matrix<double, 5, 5> terms = Eigen::Matrix<double, 5, 5>::Zero();
  Terms with_t = Terms::Zero(), with_h = Terms::Zero();
  double tt = 0, th = 0, hh = 0;
  int cells = 0;
};

class Search {
 public:
  explicit Search(const SkinRelief& front) : front_(front) {
    for (int r = 0; r < MeanFace::kRows; ++r)
      for (int c = 0; c < MeanFace::kColumns; ++c)
        terms_.push_back(termsAt(r, c)), heights_.push_back(MeanFace::height_mm(r, c));
    lowest_mm_ = lowestSkin_mm();
  }

  /// Replaces `best` if the place is more like a face.
  void tryAt(double x_mm, double nasion_mm, double scale, std::optional<FaceMatch>& best) const {
    if (nasion_mm - kLeastBelow_mm * scale < lowest_mm_) return;
    const Moments m = momentsAt(x_mm, nasion_mm, scale);
    const double seen = double(m.cells) / double(heights_.size());
    if (seen < kLeastSeen) return;
    const auto solver = m.terms.ldlt();
    const Terms t = solver.solve(m.with_t), h = solver.solve(m.with_h);
    const double tt = m.tt - m.with_t.dot(t), th = m.th - m.with_t.dot(h), hh = m.hh - m.with_h.dot(h);
    if (!(tt > 0) || !(hh > 0)) return;
    const double likeness = th / std::sqrt(tt * hh);
    if (!best || likeness > best->likeness) best = FaceMatch{likeness, th / tt, scale, x_mm, nasion_mm, seen};
  }

 private:
  Moments momentsAt(double x_mm, double nasion_mm, double scale) const {
    Moments m;
    for (int r = 0, k = 0; r < MeanFace::kRows; ++r)
      for (int c = 0; c < MeanFace::kColumns; ++c, ++k) {
        const double across = x_mm + scale * MeanFace::across_mm(c),
                     up = nasion_mm + scale * MeanFace::up_mm(r);
        const float raw =
            front_.cell(int(std::lround(across - front_.left_mm)), int(std::lround(up - front_.bottom_mm)));
        if (raw <= SkinRelief::kNone) continue;
        const double h = raw / scale, t = heights_[std::size_t(k)];
        const Terms& b = terms_[std::size_t(k)];
        m.terms += b * b.transpose();
        m.with_t += t * b, m.with_h += h * b;
        m.tt += t * t, m.th += t * h, m.hh += h * h, ++m.cells;
      }
    return m;
  }

  /// The lowest row of the relief with 20 mm of skin.
  double lowestSkin_mm() const {
    for (int row = 0; row < front_.rows; ++row) {
      int cells = 0;
      for (int column = 0; column < front_.columns; ++column)
        cells += front_.cell(column, row) > SkinRelief::kNone;
      if (cells > 20) return front_.bottom_mm + row;
    }
    return front_.bottom_mm + front_.rows;
  }

  const SkinRelief& front_;
  std::vector<Terms, Eigen::aligned_allocator<Terms>> terms_;
  std::vector<double> heights_;
  double lowest_mm_ = 0;
};

}  // namespace

std::optional<FaceMatch> findFace(const SkinRelief& front, double top_mm) {
  constexpr double kHighest_mm = 45, kLowest_mm = 165, kAside_mm = 12, kStep_mm = 3;
  const Search search(front);
  std::optional<FaceMatch> best;
  for (const double scale : {0.74, 0.82, 0.9, 1.0, 1.1})  // from a small child's face to a large one
    for (double down = kHighest_mm; down <= kLowest_mm; down += kStep_mm)
      for (double x = -kAside_mm; x <= kAside_mm; x += kStep_mm) search.tryAt(x, top_mm - down, scale, best);
  if (!best) return best;
  for (double step_mm = 1.5; step_mm > 0.4; step_mm /= 2) {  // refine around the best place
    const FaceMatch from = *best;
    for (const double bigger : {-0.013 * step_mm, 0.0, 0.013 * step_mm})
      for (const double up : {-step_mm, 0.0, step_mm})
        for (const double aside : {-step_mm, 0.0, step_mm})
          search.tryAt(from.x_mm + aside, from.nasion_mm + up, from.scale + bigger, best);
  }
  return best;
}

std::optional<double> fineRelief_mm(const SkinRelief& front, const Eigen::AlignedBox2d& box_mm) {
  constexpr double kFiner_mm = 5, kMost_mm = 8;
  constexpr int kAround_mm = 10, kLeastCells = 400;
  const SkinRelief smooth = smoothed(front, kFiner_mm);
  double squares = 0;
  int cells = 0;
  const auto first = [](double mm, double from) { return int(std::lround(mm - from)); };
  for (int row = first(box_mm.min().y(), front.bottom_mm); row <= first(box_mm.max().y(), front.bottom_mm);
       ++row)
    for (int column = first(box_mm.min().x(), front.left_mm);
         column <= first(box_mm.max().x(), front.left_mm); ++column) {
      const float here = front.cell(column, row);
      bool is_inside = here > SkinRelief::kNone;
      for (const int away : {-kAround_mm, kAround_mm})
        is_inside = is_inside && front.cell(column + away, row) > SkinRelief::kNone &&
                    front.cell(column, row + away) > SkinRelief::kNone;
      if (!is_inside) continue;
      const double detail = std::clamp(double(here - smooth.cell(column, row)), -kMost_mm, kMost_mm);
      squares += detail * detail, ++cells;
    }
  if (cells < kLeastCells) return std::nullopt;
  return std::sqrt(squares / cells);
}

}  // namespace facenav::anatomy
