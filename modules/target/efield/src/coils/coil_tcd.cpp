// .tcd: JSON with "coilElementList"; an element is of type 1 (dipoles: points mm, values A m^2), 2 (pieces of
// wire: points mm, values mm along the current) or 3 (data: T m per ampere on a grid, affine to mm). Arrays
// are lists, or base64 texts. Movable parts are taken as they stand at first ("initial").

#include <cmath>

#include "coil_readers.h"
#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/geometry/rotation.h"
#include "packed_numbers.h"

namespace facenav::efield {
namespace {

Eigen::Matrix3Xd vectorsIn(const JsonReader& json) {
  std::vector<double> numbers;
  if (json.isText()) {
    const auto unpacked = unpackedNumbers(json.text());
    if (!unpacked || unpacked->size() % 3 != 0) json.refuse("is no base64 of three numbers a point");
    numbers = *unpacked;
  } else {
    for (const auto& row : json.elements())
      for (const double number : row.numbers(3)) numbers.push_back(number);
  }
  for (const double number : numbers)
    if (!std::isfinite(number)) json.refuse("holds a value that is no number");
  return Eigen::Map<const Eigen::Matrix3Xd>(numbers.data(), 3, Eigen::Index(numbers.size() / 3));
}

Eigen::Matrix4d matrixIn(const JsonReader& json) {
  Eigen::Matrix4d matrix;
  const auto rows = json.elements();
  if (rows.size() != 4) json.refuse("four rows of four numbers were expected");
  for (int r = 0; r < 4; ++r) {
    const auto row = rows[std::size_t(r)].numbers(4);
    for (int c = 0; c < 4; ++c) matrix(r, c) = row[std::size_t(c)];
  }
  return matrix;
}

Eigen::Vector3d pointIn(const JsonReader& json) {
  const auto p = json.numbers(3);
  return {p[0], p[1], p[2]};
}

/// How far a movable part is moved or turned at first.
Eigen::Affine3d movedBy(const JsonReader& part, const JsonReader& root) {
  // Newer files keep the value in a list of ranges.
  double initial = 0;
  if (part.has("deformRange")) {
    const auto ranges = root.at("deformRangeList").elements();
    const int which = part.at("deformRange").integer();
    if (which < 0 || which >= int(ranges.size())) part.refuse("names a range that is not there");
    initial = ranges[std::size_t(which)].at("initial").number();
  } else {
    initial = part.at("initial").number();
  }
  const std::string type = part.at("type").text();
  if (type == "x" || type == "y" || type == "z")
    return Eigen::Affine3d(Eigen::Translation3d(initial * Eigen::Vector3d::Unit(type[0] - 'x')));
  if (type != "rot2p") part.refuse("a move of type x, y, z or rot2p was expected");
  const Eigen::Vector3d from = pointIn(part.at("point1")), axis = pointIn(part.at("point2")) - from;
  if (!(axis.norm() > 0)) part.refuse("turns about an axis without length");
  return Eigen::Translation3d(from) * Eigen::AngleAxisd(initial * kRadPerDeg, axis.normalized()) *
         Eigen::Translation3d(-from);
}

Eigen::Affine3d placeOf(const JsonReader& element, const JsonReader& root) {
  Eigen::Affine3d place = Eigen::Affine3d::Identity();
  if (!element.has("deformations") || element.at("deformations").isNull()) return place;
  const auto parts = root.at("deformList").elements();
  for (const auto& index : element.at("deformations").elements()) {
    const int which = index.integer();
    if (which < 0 || which >= int(parts.size())) index.refuse("names a move that is not there");
    place = movedBy(parts[std::size_t(which)], root) * place;
  }
  return place;
}

void append(Eigen::Matrix3Xd& all, const Eigen::Matrix3Xd& more) {
  all.conservativeResize(3, all.cols() + more.cols());
  all.rightCols(more.cols()) = more;
}

/// "data": nested lists [x][y][z][3].
PotentialGrid gridIn(const JsonReader& element, const Eigen::Affine3d& place) {
  const auto data = element.at("data");
  if (data.isText())
    data.refuse(
        "the sampled field is packed in a form that only Python reads: save the coil as text (ascii mode)");
  PotentialGrid grid;
  const auto slabs = data.elements();
  std::vector<std::vector<std::vector<JsonReader>>> nodes;
  for (const auto& slab : slabs) {
    nodes.emplace_back();
    for (const auto& row : slab.elements()) nodes.back().push_back(row.elements());
  }
  if (nodes.empty() || nodes[0].empty()) data.refuse("the sampled field is empty");
  grid.size = {int(nodes.size()), int(nodes[0].size()), int(nodes[0][0].size())};
  const Eigen::Matrix3d turn = place.linear();
  grid.potential_Tm.resize(3, Eigen::Index(grid.size[0]) * grid.size[1] * grid.size[2]);
  for (int i = 0; i < grid.size[0]; ++i) {
    if (int(nodes[std::size_t(i)].size()) != grid.size[1]) data.refuse("the sampled field is no full block");
    for (int j = 0; j < grid.size[1]; ++j) {
      const auto& column = nodes[std::size_t(i)][std::size_t(j)];
      if (int(column.size()) != grid.size[2]) data.refuse("the sampled field is no full block");
      for (int k = 0; k < grid.size[2]; ++k)
        grid.potential_Tm.col(grid.index(i, j, k)) = turn * pointIn(column[std::size_t(k)]);
    }
  }
  grid.coil_from_voxel = place * Eigen::Affine3d(matrixIn(element.at("affine")));
  return grid;
}

void addElement(CoilSource& source, const JsonReader& element, const JsonReader& root) {
  const int type = element.at("type").integer();
  const Eigen::Affine3d place = placeOf(element, root);
  if (type == 3) return source.grids.push_back(gridIn(element, place));
  if (type != 1 && type != 2) element.at("type").refuse("a type of 1, 2 or 3 was expected");
  const Eigen::Matrix3Xd points = vectorsIn(element.at("points")), values = vectorsIn(element.at("values"));
  if (points.cols() != values.cols()) element.refuse("has not as many values as points");
  const Eigen::Matrix3Xd placed = (place.linear() * points).colwise() + place.translation();
  append(type == 1 ? source.dipoles.positions_mm : source.lines.positions_mm, placed);
  append(type == 1 ? source.dipoles.moments_Am2 : source.lines.lengths_mm, place.linear() * values);
}

/// Largest rate of the stimulators that the elements use, A/us; 0 if none is given.
double largestRate(const JsonReader& root) {
  double largest = 0;
  if (!root.has("stimulatorList")) return largest;
  for (const auto& stimulator : root.at("stimulatorList").elements())
    if (stimulator.has("maxdIdt") && !stimulator.at("maxdIdt").isNull())
      largest = std::max(largest, stimulator.at("maxdIdt").number() * 1e-6);
  return largest;
}

}  // namespace

CoilSource readTcd(const std::filesystem::path& path) {
  const auto root = JsonReader::readFile(path);
  CoilSource source;
  if (root.has("name") && root.at("name").isText()) source.dipoles.name = root.at("name").text();
  source.dipoles.largest_didt_A_per_us = largestRate(root);
  for (const auto& element : root.at("coilElementList").elements()) addElement(source, element, root);
  for (auto& grid : source.grids) grid.file = path.string();
  if (root.has("stimulatorList") && root.at("stimulatorList").elements().size() > 1)
    source.notes.push_back("the coil has several stimulators: all parts are taken with the same current");
  if (root.has("deformList") && !root.at("deformList").elements().empty())
    source.notes.push_back("the coil has movable parts: they are taken as the file places them at first");
  return source;
}

}  // namespace facenav::efield
