#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/interop/axes.h"
#include "readers.h"
#include "text.h"

// Brainsight's text export, versions 7 to 15. Columns are found by name, since each version moves them.

namespace facenav::interop {
namespace {

struct Header {
  int version = 0;
  std::string system, created_by;
};

bool isNull(const std::string& cell) { return cell.empty() || cell == "(null)"; }

std::string withoutNull(const std::string& cell) { return isNull(cell) ? std::string() : cell; }

/// Kind of the section that a line begins, "Target Name"; empty for other lines.
std::string sectionOf(const std::vector<std::string>& cells) {
  if (cells.size() < 2 || !startsWith(cells[0], "#")) return {};
  const std::string first = trimmed(cells[0].substr(1));
  const bool is_header = first.size() >= 4 && first.compare(first.size() - 4, 4, "Name") == 0;
  return is_header ? first : std::string();
}

void readHeaderLine(const std::string& line, Header& header) {
  const std::string text = trimmed(line.substr(1));
  const auto colon = text.find(':');
  if (colon == std::string::npos) return;
  const std::string key = text.substr(0, colon), value = trimmed(text.substr(colon + 1));
  if (key == "Version") header.version = int(valueIn(value).value_or(0));
  if (key == "Coordinate system") header.system = value;
  if (key == "Created by") header.created_by = value;
}

/// A second header, of a file that was appended to another one, must name the same system.
void requireSameSystem(const std::string& line, const Header& header, const std::filesystem::path& path,
                       const std::string& where) {
  Header again = header;
  readHeaderLine(line, again);
  if (again.system != header.system)
    refuseFile(path, where, "names a second coordinate system, '" + again.system.substr(0, 40) + "'",
               "import each part as a file of its own");
}

Form formOf(const std::string& system) {
  return contains(system, ":Q:") ? Form::qform : contains(system, ":S:") ? Form::sform : Form::any;
}

/// What the coordinate system's name says; `is_image_axes` for Brainsight's own system.
Space spaceOf(const std::string& system, bool& is_image_axes) {
  is_image_axes = system == "Brainsight";
  if (is_image_axes) return Space::ras;
  if (contains(system, "MNI")) return Space::mni;
  if (contains(system, "Talairach")) return Space::talairach;
  if (contains(system, "Template") || contains(system, "Other")) return Space::other_template;
  return startsWith(system, "NIfTI:") ? Space::ras : Space::unknown;
}

/// Pose of a row with Brainsight's axes; nothing if its cells are blank.
std::optional<Eigen::Matrix4d> poseOf(const Columns& columns, const std::vector<std::string>& cells) {
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  bool is_blank = true;
  for (int row = 0; row < 3; ++row) {
    const std::string place = columns.text(cells, std::string("Loc. ") + "XYZ"[row]);
    is_blank = is_blank && isNull(place);
    pose(row, 3) = numberOrNan(place);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string cell = columns.text(cells, formatted("m%dn%d", axis, row));
      is_blank = is_blank && isNull(cell);
      pose(row, axis) = numberOrNan(cell);
    }
  }
  if (is_blank) return std::nullopt;
  return toFaceNav(pose, CoilAxes::brainsight);
}

Eigen::Vector3d placeOf(const Columns& columns, const std::vector<std::string>& cells) {
  return {columns.number(cells, "Loc. X"), columns.number(cells, "Loc. Y"), columns.number(cells, "Loc. Z")};
}

void readPulse(const Columns& columns, const std::vector<std::string>& cells, Item& item) {
  const auto text = [&](const char* name) { return withoutNull(columns.text(cells, name)); };
  item.session = text("Session Name");
  item.target = text("Assoc. Target");
  item.intensity_pct = valueIn(text("Stim. Power A"));
  if (!item.intensity_pct) item.intensity_pct = valueIn(text("Stim. Power"));
  item.mep_uv = valueIn(text("EMG Peak-to-peak 1"));
  item.time = trimmed(text("Date") + " " + text("Time"));
  item.clock_s = clockOf(text("Date"), text("Time"));
  for (const char* name : {"Dist. to Target", "Target Error", "Angular Error", "Twist Error",
                           "Creation Cause", "Crosshairs Driver", "Comment", "Offset"})
    if (!text(name).empty()) item.values[name] = text(name);
}

/// Item of a row; nothing for sections without items of ours (sessions).
std::optional<Item> itemOf(const std::string& section, const Columns& columns,
                           const std::vector<std::string>& cells) {
  Item item;
  item.name = trimmed(cells[0]);
  if (section == "Target Name")
    item.kind = Kind::target;
  else if (section == "Sample Name")
    item.kind = Kind::pulse;
  else if (section == "Electrode Name")
    item.kind = Kind::electrode;
  else if (section == "Planned Landmark Name")
    item.kind = Kind::landmark;
  else
    return std::nullopt;
  if (item.kind == Kind::landmark) {
    item.place_mm = placeOf(columns, cells);
    return item;
  }
  item.pose = poseOf(columns, cells);
  if (!item.pose) item.reason = "the file has no pose for it";
  if (item.kind == Kind::pulse) readPulse(columns, cells, item);
  return item;
}

/// Moves items from mm along the image's axes (towards L, P, S, from the centre of the right, anterior,
/// inferior corner voxel) into the world of the T1.
void fromImageAxes(OtherFile& file, const T1* t1, const std::filesystem::path& path) {
  if (!t1) refuseFile(path, "", "needs the T1 for its coordinate system 'Brainsight'");
  const auto grid = canonical(t1->grid);
  const Eigen::Vector3d spacing = grid.spacing_mm();
  const Eigen::Matrix3d turn = grid.mri_from_voxel.linear() * spacing.cwiseInverse().asDiagonal() *
                               Eigen::Vector3d(-1, -1, 1).asDiagonal();
  const Eigen::Vector3d origin =
      grid.mri_from_voxel * Eigen::Vector3d(grid.size[0] - 1.0, grid.size[1] - 1.0, 0.0);
  Eigen::Matrix4d world = Eigen::Matrix4d::Identity();
  world.topLeftCorner<3, 3>() = turn;
  world.topRightCorner<3, 1>() = origin;
  for (auto& item : file.items) {
    if (item.pose) item.pose = world * *item.pose;
    if (item.place_mm) item.place_mm = turn * *item.place_mm + origin;
  }
  file.notes.push_back(
      "its system 'Brainsight' was converted by the case's T1; no published image confirms the origin: "
      "compare one "
      "target");
}

OtherFile withHeader(const Header& header, const std::filesystem::path& path, bool& is_image_axes) {
  if (header.version == 0) refuseFile(path, "", "its line '# Version:' is missing", "export it again");
  if (header.version < 7 || header.version > 15)
    refuseFile(path, "", formatted("is Brainsight's version %d; 7 to 15 are read", header.version));
  if (header.system.empty())
    refuseFile(path, "", "its line '# Coordinate system:' is missing", "export it again");
  OtherFile file;
  file.words = formatted("Brainsight text export, version %d, %s", header.version, header.system.c_str());
  file.space = spaceOf(header.system, is_image_axes);
  file.space_words = header.system;
  file.form = formOf(header.system);
  file.is_form_doubtful = file.form == Form::any && !is_image_axes;
  if (contains(header.created_by, "FaceNav") && contains(header.created_by, "(sform)"))
    file.form = Form::sform, file.is_form_doubtful = false;
  if (contains(header.created_by, "FaceNav") && contains(header.created_by, "(qform)"))
    file.form = Form::qform, file.is_form_doubtful = false;
  return file;
}

}  // namespace

bool isBrainsight(const std::string& content) {
  if (!startsWith(content, "#")) return false;
  const std::string start = content.substr(0, 4000);
  return contains(start, "# Coordinate system:") || contains(start, "# Target Name\t") ||
         contains(start, "# Sample Name\t") || contains(start, "# Electrode Name\t");
}

OtherFile readBrainsight(const Source& source) {
  Header header;
  std::string section;
  Columns columns({});
  std::size_t header_cells = 0;
  std::vector<Item> items;
  int number = 0;
  const auto lines = linesOf(source.content);
  const bool is_open = source.content.back() != '\n';  // the end of the last line is missing
  for (const auto& line : lines) {
    ++number;
    const std::string where = formatted("line %d", number);
    const auto cells = cellsOf(line, '\t');
    if (const std::string begun = sectionOf(cells); !begun.empty()) {
      section = begun;
      columns = Columns(cells);
      header_cells = cells.size();
      const bool has_poses =
          section == "Target Name" || section == "Sample Name" || section == "Electrode Name";
      if (has_poses && (!columns.has("Loc. X") || !columns.has("m0n0") || !columns.has("m2n2")))
        refuseFile(source.path, where, "its columns Loc. X to m2n2 are missing", "export it again");
      continue;
    }
    if (section.empty()) {
      if (startsWith(line, "#")) readHeaderLine(line, header);
      continue;
    }
    if (trimmed(line).empty()) continue;
    if (cells.size() < 2 && startsWith(line, "#")) {
      requireSameSystem(line, header, source.path, where);
      continue;
    }
    for (std::size_t i = header_cells; i < cells.size(); ++i)
      if (!trimmed(cells[i]).empty())
        refuseFile(
            source.path, where,
            formatted("has %d cells, its section has %d columns", int(cells.size()), int(header_cells)));
    if (auto item = itemOf(section, columns, cells)) {
      const bool is_last = is_open && number == int(lines.size());
      if (cells.size() < (is_last ? header_cells : 4))
        refuseFile(source.path, where, "is cut short", "copy or export the file again");
      item->where = where;
      items.push_back(std::move(*item));
    }
  }
  bool is_image_axes = false;
  OtherFile file = withHeader(header, source.path, is_image_axes);
  file.items = std::move(items);
  if (is_image_axes) fromImageAxes(file, source.t1, source.path);
  return file;
}

}  // namespace facenav::interop
