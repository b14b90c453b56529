#include <cmath>
#include <sstream>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/interop/axes.h"
#include "readers.h"
#include "text.h"

// ITK's text of a transform, as 3D Slicer stores it: LPS, and from the parent, so it holds the inverse of the
// transform that Slicer shows.

namespace facenav::interop {
namespace {

std::vector<double> numbersOf(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream stream(line.substr(line.find(':') + 1));
  for (std::string word; stream >> word;) numbers.push_back(numberOrNan(word));
  return numbers;
}

/// Pose of the coil in RAS from parameters and centre of an affine transform.
Eigen::Matrix4d poseOf(const std::vector<double>& parameters, const std::vector<double>& centre) {
  Eigen::Matrix4d stored = Eigen::Matrix4d::Identity();
  for (int row = 0; row < 3; ++row) {
    stored(row, 3) = parameters[std::size_t(9 + row)];
    for (int column = 0; column < 3; ++column)
      stored(row, column) = parameters[std::size_t(3 * row + column)];
  }
  if (centre.size() >= 3) {
    const Eigen::Vector3d c(centre[0], centre[1], centre[2]);
    stored.topRightCorner<3, 1>() += c - stored.topLeftCorner<3, 3>() * c;
  }
  const double determinant = stored.topLeftCorner<3, 3>().determinant();
  if (!stored.allFinite() || std::abs(determinant) < 1e-6) return Eigen::Matrix4d::Constant(std::nan(""));
  return lpsFromRas() * stored.inverse() * lpsFromRas();
}

}  // namespace

bool isItkTransform(const std::string& content) { return startsWith(content, "#Insight Transform File"); }

OtherFile readItkTransform(const Source& source) {
  OtherFile file;
  file.words = "ITK transform, LPS, from the parent";
  file.space_words = "LPS";
  std::string type;
  std::vector<double> parameters;
  int number = 0;
  for (const auto& line : linesOf(source.content)) {
    ++number;
    const std::string where = formatted("line %d", number);
    if (startsWith(line, "Transform:")) {
      type = trimmed(line.substr(10));
      parameters.clear();
      if (!startsWith(type, "AffineTransform_") && !startsWith(type, "MatrixOffsetTransformBase_"))
        refuseFile(source.path, where, "is a transform of type '" + type.substr(0, 60) + "'",
                   "save an affine one");
    } else if (startsWith(line, "Parameters:")) {
      parameters = numbersOf(line);
      if (parameters.size() != 12)
        refuseFile(source.path, where, formatted("has %d numbers, 12 were expected", int(parameters.size())),
                   "copy or save it again");
    } else if (startsWith(line, "FixedParameters:")) {
      if (parameters.empty()) refuseFile(source.path, where, "its line 'Parameters:' is missing");
      Item item;
      item.where = where;
      item.name = source.path.stem().string();
      item.pose = poseOf(parameters, numbersOf(line));
      file.items.push_back(item);
      parameters.clear();
    }
  }
  if (!parameters.empty())
    refuseFile(source.path, "", "is cut short: its line 'FixedParameters:' is missing");
  if (file.items.size() > 1)
    for (std::size_t i = 0; i < file.items.size(); ++i) file.items[i].name += formatted(" %d", int(i) + 1);
  file.notes.push_back("a transform holds no name: the file's is taken");
  return file;
}

Written writeItkTransform(const Order& order) {
  const auto targets = targetsOf(order);
  if (targets.size() != 1)
    throw Error(formatted("holds one target, the case has %d", int(targets.size())), "tfm",
                "choose one with --target NAME");
  const Eigen::Matrix4d stored = (lpsFromRas() * targets[0]->mri_T_coil->matrix() * lpsFromRas()).inverse();
  Written written;
  std::string& text = written.content;
  text = "#Insight Transform File V1.0\n#Transform 0\nTransform: AffineTransform_double_3_3\nParameters:";
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) text += formatted(" %.17g", stored(row, column) + 0.0);
  for (int row = 0; row < 3; ++row) text += formatted(" %.17g", stored(row, 3) + 0.0);
  text += "\nFixedParameters: 0 0 0\n";
  written.notes.push_back("a transform holds no name: the file's name stands for '" + targets[0]->name + "'");
  notePulsesLeft(order, written, "a transform");
  return written;
}

}  // namespace facenav::interop
