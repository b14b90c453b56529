#include "facenav/measured_face/projected_dots.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/core/robust_statistics.h"

namespace facenav::measured_face {
namespace {

constexpr int kFineScale_px = 9;       // larger structures are skin and light
constexpr int kReductions[] = {2, 4};  // larger dots are points in smaller pictures
constexpr int kPatch_px = 32;          // exposure and noise are estimated patch by patch
constexpr double kPoint_px = 0.8;      // blur that gathers a dot's light: dots are 2 px and more
constexpr double kAboveNoise = 4.0;
constexpr double kLeastNoise_grey = 0.3;  // rounding to whole grey levels
constexpr double kDark_grey = 4.0;        // darker patches show nothing
// Bright points must exceed the dark ones by this factor, and by this many standard deviations of their
// number.
constexpr double kMoreThanDark = 1.5, kBeyondChance = 5.0;
constexpr int kFewestDots = 12;
// Dense dots lie 4 to 8 px apart at 640 px, the paper's ten times as far.
constexpr double kTilesAcross = 40, kDotsInDenseTile = 1.0;

cv::Mat fineDetail(const cv::Mat& image) {
  cv::Mat grey, smooth;
  image.convertTo(grey, CV_32F);
  cv::boxFilter(grey, smooth, -1, {kFineScale_px, kFineScale_px});
  return grey - smooth;
}

/// Standard deviation of the pixels' noise, from the plain picture alone (Immerkaer 1996, with a median in
/// place of the mean). Fine texture of the skin counts as noise.
double noiseOf(const cv::Mat& patch) {
  static const cv::Mat kernel = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::Mat grey, second;
  patch.convertTo(grey, CV_32F);
  cv::filter2D(grey, second, CV_32F, kernel);
  std::vector<double> sizes;
  for (int y = 1; y + 1 < second.rows; ++y)
    for (int x = 1; x + 1 < second.cols; ++x) sizes.push_back(double(std::abs(second.at<float>(y, x))));
  return std::hypot(kSigmaPerMad * upperMedian(sizes) / 6.0, kLeastNoise_grey);
}

/// Factor of the plain picture's detail in the picture with dots: by least squares, since dots are
/// independent of that detail, but at least as the levels differ. A face that moved in between has its detail
/// elsewhere, and then least squares find none.
double gainOf(const cv::Mat& dotted, const cv::Mat& plain, double levels) {
  return std::max(levels, dotted.dot(plain) / std::max(1e-6, plain.dot(plain)));
}

bool isPeak(const cv::Mat& image, int x, int y, float sign) {
  const float here = sign * image.at<float>(y, x);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const float there = sign * image.at<float>(y + dy, x + dx);
      // Of two equal neighbours only one is counted.
      if (there > here || (there == here && (dy < 0 || (dy == 0 && dx < 0)))) return false;
    }
  return true;
}

/// True unless a ridge runs through the point: along an edge that moved between the pictures, many peaks lie
/// in a line. A dot is lower to at least one side in each direction.
bool isPoint(const cv::Mat& image, int x, int y) {
  constexpr int kAside_px = 3;
  const float half = 0.5f * std::abs(image.at<float>(y, x));
  const auto isHigh = [&](int dx, int dy) {
    const int to_x = x + kAside_px * dx, to_y = y + kAside_px * dy;
    const bool is_inside = to_x >= 0 && to_y >= 0 && to_x < image.cols && to_y < image.rows;
    return is_inside && std::abs(image.at<float>(to_y, to_x)) > half &&
           (image.at<float>(to_y, to_x) > 0) == (image.at<float>(y, x) > 0);
  };
  for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}})
    if (isHigh(dx, dy) && isHigh(-dx, -dy)) return false;
  return true;
}

/// Share of white noise that the blur leaves.
double leftByBlur() {
  static const double left = [] {
    const cv::Mat line = cv::getGaussianKernel(5, kPoint_px, CV_64F);
    return line.dot(line);
  }();
  return left;
}

struct Pictures {
  cv::Mat dotted, plain;            // grey
  cv::Mat dotted_fine, plain_fine;  // their detail
};

/// Heights of points above the noise, relative to the grey level around them.
struct Points {
  std::vector<double> bright, dark;
};

/// Adds the points of one patch.
void addPoints(const cv::Rect& patch, const Pictures& all, DotsSeen& seen, Points& points) {
  const double level = cv::mean(all.dotted(patch))[0];
  if (level < kDark_grey) return;
  const cv::Mat dotted = all.dotted_fine(patch), plain = all.plain_fine(patch);
  const double gain = gainOf(dotted, plain, level / std::max(1.0, cv::mean(all.plain(patch))[0]));
  cv::Mat difference = dotted - gain * plain;
  cv::GaussianBlur(difference, difference, {5, 5}, kPoint_px);
  const double limit = kAboveNoise * leftByBlur() * noiseOf(all.plain(patch)) * std::sqrt(1.0 + gain * gain);
  seen.area_px += patch.area();
  for (int y = 1; y + 1 < difference.rows; ++y)
    for (int x = 1; x + 1 < difference.cols; ++x) {
      const double height = double(difference.at<float>(y, x));
      if (std::abs(height) < limit || !isPeak(difference, x, y, height > 0 ? 1.0f : -1.0f)) continue;
      if (isPoint(difference, x, y))
        (height > 0 ? points.bright : points.dark).push_back(std::abs(height) / level);
    }
}

/// Number of values from `least` on.
int countFrom(const std::vector<double>& values, double least) {
  return int(std::count_if(values.begin(), values.end(), [least](double v) { return v >= least; }));
}

double excess(const DotsSeen& seen) {
  return double(seen.bright - seen.dark) / std::sqrt(std::max(1.0, double(seen.bright + seen.dark)));
}

/// Counts all points, the higher half or the highest fifth of the bright ones, each with the dark ones of
/// that height: whichever shows more dots. A dot has a dark ring, since the mean around it was subtracted,
/// but one that is lower than the dot.
DotsSeen counted(const DotsSeen& seen, const Points& points) {
  DotsSeen best = seen;
  if (points.bright.empty()) return best;
  std::vector<double> heights = points.bright;
  std::sort(heights.begin(), heights.end());
  best.contrast = heights[heights.size() / 2];
  for (const double share : {1.0, 0.5, 0.2}) {
    const double least = heights[std::size_t((1 - share) * double(heights.size()))];
    DotsSeen these = best;
    these.share = share;
    these.bright = countFrom(points.bright, least), these.dark = countFrom(points.dark, least);
    if (share == 1.0 || excess(these) > excess(best)) best = these;
  }
  return best;
}

/// Counts the points at this size of the pictures.
DotsSeen countedIn(const cv::Mat& dotted, const cv::Mat& plain) {
  DotsSeen seen;
  const Pictures all{dotted, plain, fineDetail(dotted), fineDetail(plain)};
  Points points;
  for (int y = 0; y < plain.rows; y += kPatch_px)
    for (int x = 0; x < plain.cols; x += kPatch_px) {
      const cv::Rect patch = cv::Rect(x, y, kPatch_px, kPatch_px) & cv::Rect({}, plain.size());
      if (patch.width >= kFineScale_px && patch.height >= kFineScale_px) addPoints(patch, all, seen, points);
    }
  return counted(seen, points);
}

}  // namespace

bool DotsSeen::areThere() const {
  return bright >= kFewestDots && bright > kMoreThanDark * dark && excess(*this) > kBeyondChance;
}

double DotsSeen::areaOfOne_px() const { return share * double(area_px) / std::max(1, bright - dark); }

DotsSeen findDots(const capture::CapturePair& capture, const std::optional<cv::Rect>& face) {
  const cv::Mat &dotted = capture.pattern.left, &plain = capture.plain.left;
  if (dotted.empty() || dotted.size() != plain.size() || dotted.type() != CV_8U || plain.type() != CV_8U)
    return {};
  const cv::Rect whole(0, 0, dotted.cols, dotted.rows), region = face ? (*face & whole) : whole;
  if (region.area() == 0) return {};
  DotsSeen seen = countedIn(dotted(region), plain(region));
  for (const int times : kReductions) {
    if (seen.areThere() || std::min(region.width, region.height) < times * kPatch_px) break;
    cv::Mat small_dotted, small_plain;
    cv::resize(dotted(region), small_dotted, {}, 1.0 / times, 1.0 / times, cv::INTER_AREA);
    cv::resize(plain(region), small_plain, {}, 1.0 / times, 1.0 / times, cv::INTER_AREA);
    DotsSeen larger = countedIn(small_dotted, small_plain);
    larger.area_px *= times * times;
    if (larger.areThere()) seen = larger;
  }
  return seen;
}

bool showsDots(const capture::CapturePair& capture, const std::optional<cv::Rect>& face) {
  return findDots(capture, face).areThere();
}

bool areDotsSparse(const capture::CapturePair& capture, const std::optional<cv::Rect>& face) {
  const DotsSeen seen = findDots(capture, face);
  const double tile_px = double(capture.pattern.left.cols) / kTilesAcross;
  return seen.areThere() && tile_px * tile_px < kDotsInDenseTile * seen.areaOfOne_px();
}

}  // namespace facenav::measured_face
