#include "marker_plate.h"

#include <cmath>
#include <map>
#include <opencv2/aruco.hpp>

#include "facenav/core/error.h"
#include "optics/shapes.h"

namespace facenav::room {
namespace {

constexpr float kWhite = 0.72f, kBlack = 0.035f;

const std::map<std::string, int>& dictionaries() {
  using namespace cv::aruco;
  static const std::map<std::string, int> known{
      {"4x4_50", DICT_4X4_50},     {"4x4_100", DICT_4X4_100},        {"4x4_250", DICT_4X4_250},
      {"4x4_1000", DICT_4X4_1000}, {"5x5_50", DICT_5X5_50},          {"5x5_100", DICT_5X5_100},
      {"5x5_250", DICT_5X5_250},   {"5x5_1000", DICT_5X5_1000},      {"6x6_50", DICT_6X6_50},
      {"6x6_100", DICT_6X6_100},   {"6x6_250", DICT_6X6_250},        {"6x6_1000", DICT_6X6_1000},
      {"7x7_50", DICT_7X7_50},     {"7x7_100", DICT_7X7_100},        {"7x7_250", DICT_7X7_250},
      {"7x7_1000", DICT_7X7_1000}, {"original", DICT_ARUCO_ORIGINAL}};
  return known;
}

cv::Mat markerCells(const std::string& name, int id) {
  const auto found = dictionaries().find(name);
  if (found == dictionaries().end())
    throw Error("no marker dictionary of this name", name, "4x4_50, for example");
  const auto dictionary = cv::aruco::getPredefinedDictionary(found->second);
  if (id < 0 || id >= dictionary->bytesList.rows)
    throw Error("no marker of this number in the dictionary", name + " " + std::to_string(id),
                "choose a smaller id");
  cv::Mat cells;
  cv::aruco::drawMarker(dictionary, id, dictionary->markerSize + 2, cells, 1);
  return cells;
}

bool isFront(const Eigen::Vector3d& p_mm) { return p_mm.z() < 0.25 * kPlateThickness_mm; }

class MarkerLook : public Look {
 public:
  MarkerLook(cv::Mat cells, double size_mm) : cells_(std::move(cells)), size_mm_(size_mm) {}
  bool isPrinted() const override { return true; }
  Reflectance at(const SurfacePoint& point) const override {
    const double scale = cells_.cols / size_mm_;
    const double x = (point.p_object_mm.x() + 0.5 * size_mm_) * scale,
                 y = (point.p_object_mm.y() + 0.5 * size_mm_) * scale;
    if (!isFront(point.p_object_mm) || x < 0 || y < 0 || x >= cells_.cols || y >= cells_.rows)
      return {kWhite, 0.f};
    return {cells_.at<std::uint8_t>(int(y), int(x)) ? kWhite : kBlack, 0.f};
  }

 private:
  cv::Mat cells_;
  double size_mm_;
};

class ChessboardLook : public Look {
 public:
  ChessboardLook(int columns, int rows, double square_mm)
      : columns_(columns), rows_(rows), square_mm_(square_mm) {}
  bool isPrinted() const override { return true; }
  Reflectance at(const SurfacePoint& point) const override {
    const double x = point.p_object_mm.x() / square_mm_ + 0.5 * (columns_ + 1),
                 y = point.p_object_mm.y() / square_mm_ + 0.5 * (rows_ + 1);
    if (!isFront(point.p_object_mm) || x < 0 || y < 0 || x >= columns_ + 1 || y >= rows_ + 1)
      return {kWhite, 0.f};
    return {(int(x) + int(y)) % 2 ? kWhite : kBlack, 0.f};
  }

 private:
  int columns_, rows_;
  double square_mm_;
};

}  // namespace

surface::TriangleMesh plateMesh(double width_mm, double height_mm) {
  return box({-0.5 * width_mm, -0.5 * height_mm, 0.0}, {0.5 * width_mm, 0.5 * height_mm, kPlateThickness_mm});
}

std::shared_ptr<const Look> makeMarkerLook(const std::string& dictionary, int id, double size_mm) {
  return std::make_shared<MarkerLook>(markerCells(dictionary, id), size_mm);
}

std::shared_ptr<const Look> makeChessboardLook(int columns, int rows, double square_mm) {
  return std::make_shared<ChessboardLook>(columns, rows, square_mm);
}

}  // namespace facenav::room
