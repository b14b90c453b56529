#include "facenav/core/number_text.h"
#include "facenav/interop/axes.h"
#include "json_pose.h"
#include "readers.h"
#include "text.h"

// 3D Slicer's markups as JSON. A control point with an orientation is a pose of the coil; one without is a
// place. The older .fcsv holds places.

namespace facenav::interop {
namespace {

using Json = nlohmann::ordered_json;

Space spaceOf(const JsonReader& markup) {
  if (!isGiven(markup, "coordinateSystem")) return Space::lps;
  const std::string words = markup.at("coordinateSystem").text();
  if (words == "LPS" || words == "0") return Space::lps;
  if (words == "RAS" || words == "1") return Space::ras;
  markup.at("coordinateSystem").refuse("is '" + words.substr(0, 40) + "', LPS or RAS was expected");
}

/// Units are a text or a coded entry, whose first word is the unit.
void requireMillimetres(const JsonReader& markup) {
  if (!isGiven(markup, "coordinateUnits")) return;
  const auto units = markup.at("coordinateUnits");
  std::string words;
  if (units.isText())
    words = units.text();
  else if (units.has("codeValue"))
    words = units.at("codeValue").text();
  else if (const auto parts = units.elements(); !parts.empty())
    words = parts[0].text();
  if (words != "mm" && !startsWith(words, "(mm,"))
    units.refuse("is '" + words.substr(0, 40) + "', mm was expected");
}

/// Items are kept in RAS, since several markups with spaces of their own may stand in a file.
Item itemOf(const JsonReader& point, Space space) {
  Item item;
  item.name = textOr(point, "label");
  if (item.name.empty()) item.name = textOr(point, "id");
  const std::string status = textOr(point, "positionStatus", "defined");
  if (status != "defined" || !isGiven(point, "position")) {
    item.kind = Kind::landmark;
    item.reason = "its position is " + (status == "defined" ? "missing" : status);
    return item;
  }
  const auto position = point.at("position").numbers(3);
  const Eigen::Matrix4d change =
      space == Space::lps ? lpsFromRas() : Eigen::Matrix4d(Eigen::Matrix4d::Identity());
  std::vector<double> orientation{1, 0, 0, 0, 1, 0, 0, 0, 1};
  if (isGiven(point, "orientation")) orientation = point.at("orientation").numbers(9);
  const Eigen::Matrix4d written = poseOfPlace(position, orientation), pose = change * written;
  // Some writers leave the identity, others Slicer's own (the identity in RAS), where there is none.
  if (isUnturned(pose) || isUnturned(written)) {
    item.kind = Kind::landmark;
    item.place_mm = pose.topRightCorner<3, 1>();
  } else {
    item.pose = pose;
  }
  return item;
}

}  // namespace

bool isSlicerMarkups(const std::string& content) { return isJsonWith(content, {"markups"}); }

OtherFile readSlicerMarkups(const Source& source) {
  const auto json = jsonOf(source, "markups");
  OtherFile file;
  file.words = "3D Slicer markups";
  int list_number = 0;
  for (const auto& markup : json.at("markups").elements()) {
    ++list_number;
    const Space space = spaceOf(markup);
    requireMillimetres(markup);
    file.space_words = toString(space);
    if (!isGiven(markup, "controlPoints")) continue;
    int number = 0;
    for (const auto& point : markup.at("controlPoints").elements()) {
      file.items.push_back(itemOf(point, space));
      file.items.back().where = formatted("list %d, point %d", list_number, ++number);
    }
  }
  return file;
}

Written writeSlicerMarkups(const Order& order) {
  Json points = Json::array();
  for (const auto* target : targetsOf(order)) {
    const Eigen::Matrix4d pose = lpsFromRas() * target->mri_T_coil->matrix();
    Json orientation = Json::array();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) orientation.push_back(pose(row, column) + 0.0);
    points.push_back({{"id", std::to_string(points.size() + 1)},
                      {"label", target->name},
                      {"description", "coil pose"},
                      {"associatedNodeID", ""},
                      {"position", {pose(0, 3) + 0.0, pose(1, 3) + 0.0, pose(2, 3) + 0.0}},
                      {"orientation", orientation},
                      {"selected", true},
                      {"locked", false},
                      {"visibility", true},
                      {"positionStatus", "defined"}});
  }
  const Json markup{{"type", "Fiducial"},
                    {"coordinateSystem", "LPS"},
                    {"coordinateUnits", "mm"},
                    {"locked", false},
                    {"fixedNumberOfControlPoints", false},
                    {"labelFormat", "%N-%d"},
                    {"lastUsedControlPointNumber", points.size()},
                    {"controlPoints", points}};
  Written written;
  written.content =
      jsonText({{"@schema",
                 "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
                 "Resources/Schema/markups-schema-v1.0.3.json#"},
                {"markups", Json::array({markup})}});
  notePulsesLeft(order, written, "Slicer's file");
  return written;
}

bool isFcsv(const std::string& content) { return startsWith(content, "# Markups fiducial file"); }

OtherFile readFcsv(const Source& source) {
  OtherFile file;
  file.words = "3D Slicer markups (.fcsv)";
  file.space = Space::unknown;
  Columns columns({"id", "x", "y", "z", "ow", "ox", "oy", "oz", "vis", "sel", "lock", "label", "desc"});
  int number = 0;
  for (const auto& line : linesOf(source.content)) {
    ++number;
    if (startsWith(line, "#")) {
      const auto equals = line.find('=');
      if (equals == std::string::npos) continue;
      const std::string value = trimmed(line.substr(equals + 1));
      if (contains(line, "CoordinateSystem")) file.space_words = value;
      if (contains(line, "# columns")) columns = Columns(cellsOf(value, ','));
      continue;
    }
    if (trimmed(line).empty()) continue;
    const auto cells = csvCellsOf(line);
    if (cells.size() < 4)
      refuseFile(source.path, formatted("line %d", number), "is cut short", "copy or export it again");
    Item item;
    item.kind = Kind::landmark;
    item.where = formatted("line %d", number);
    item.name = columns.text(cells, "label");
    item.place_mm =
        Eigen::Vector3d(columns.number(cells, "x"), columns.number(cells, "y"), columns.number(cells, "z"));
    file.items.push_back(item);
  }
  if (file.space_words == "RAS" || file.space_words == "0") file.space = Space::ras;
  if (file.space_words == "LPS" || file.space_words == "1") file.space = Space::lps;
  file.notes.push_back("an .fcsv holds places without the coil's orientation");
  return file;
}

}  // namespace facenav::interop
