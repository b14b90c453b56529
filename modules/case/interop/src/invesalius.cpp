#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/interop/axes.h"
#include "facenav/interop/invesalius_space.h"
#include "readers.h"
#include "text.h"

// InVesalius's .mkss, versions 0 to 5; its space is that of invesalius_space.h.

namespace facenav::interop {
namespace {

constexpr const char* kMagic = "##INVESALIUS3_MARKER_FILE_";
constexpr const char* kNames[] = {"marker_id",
                                  "x",
                                  "y",
                                  "z",
                                  "alpha",
                                  "beta",
                                  "gamma",
                                  "r",
                                  "g",
                                  "b",
                                  "size",
                                  "label",
                                  "x_seed",
                                  "y_seed",
                                  "z_seed",
                                  "is_target",
                                  "is_point_of_interest",
                                  "session_id",
                                  "x_cortex",
                                  "y_cortex",
                                  "z_cortex",
                                  "alpha_cortex",
                                  "beta_cortex",
                                  "gamma_cortex",
                                  "marker_type",
                                  "z_rotation",
                                  "z_offset",
                                  "mep_value",
                                  "brain_target_list",
                                  "timestamp",
                                  "x_world",
                                  "y_world",
                                  "z_world",
                                  "alpha_world",
                                  "beta_world",
                                  "gamma_world"};

constexpr const char* kNeeded[] = {"x", "y", "z", "alpha", "beta", "gamma", "label"};

/// A cell without its quotes.
std::string plain(std::string cell) {
  cell = trimmed(cell);
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
  std::string text;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    text += cell[i];
    if (cell[i] == '"' && cell[i + 1] == '"') ++i;
  }
  return text;
}

bool isNone(const std::string& cell) { return cell.empty() || cell == "None" || cell == "N/A"; }

Kind kindOf(const std::string& type, const std::string& label, bool is_turned) {
  if (type == "3") return Kind::target;
  if (type == "4") return Kind::pulse;
  if (!type.empty() && !isNone(type)) return Kind::landmark;  // fiducial, landmark, brain target
  if (label == "LEI" || label == "REI" || label == "NAI") return Kind::landmark;
  return is_turned ? Kind::target : Kind::landmark;  // older files have no type
}

Item itemOf(const Columns& columns, const std::vector<std::string>& cells, const InvesaliusSpace& image) {
  const auto text = [&](const char* name) { return plain(columns.text(cells, name)); };
  const auto three = [&](const char* a, const char* b, const char* c) {
    return Eigen::Vector3d(numberOrNan(text(a)), numberOrNan(text(b)), numberOrNan(text(c)));
  };
  Item item;
  item.name = text("label");
  const Eigen::Vector3d place = image.toWorld(three("x", "y", "z"));
  const bool is_turned = !isNone(text("alpha"));
  item.kind = kindOf(text("marker_type"), item.name, is_turned);
  if (item.kind == Kind::landmark) {
    item.place_mm = place;
    return item;
  }
  if (!is_turned) {
    item.reason = "the marker has no orientation";
    return item;
  }
  const Eigen::Matrix3d theirs = image.turn() * turnOfFixedAngles(three("alpha", "beta", "gamma"));
  item.pose =
      toFaceNav(poseOfColumns(place, theirs.col(0), theirs.col(1), theirs.col(2)), CoilAxes::invesalius);
  item.mep_uv = valueIn(text("mep_value"));
  setTime(text("timestamp"), item);
  return item;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
  }
  return result + "\"";
}

std::string numbers(const Eigen::Vector3d& v) {
  std::string text;
  for (int i = 0; i < 3; ++i) text += formatted("\t%.15g", v[i] + 0.0);
  return text;
}

std::string rowOf(const Item& item, int id, const InvesaliusSpace& image, const std::string& time) {
  const bool is_target = item.kind == Kind::target;
  const Eigen::Vector3d place = is_target ? item.mri_T_coil->translation_mm() : item.mri_place->mm;
  std::string row = std::to_string(id) + numbers(image.fromWorld(place)), world = numbers(place);
  if (is_target) {
    const Eigen::Matrix3d theirs =
        fromFaceNav(item.mri_T_coil->matrix(), CoilAxes::invesalius).topLeftCorner<3, 3>();
    row += numbers(fixedAngles_deg(image.turn().transpose() * theirs));
    world += numbers(fixedAngles_deg(theirs));
  } else {
    row += "\tNone\tNone\tNone";
    world += "\tN/A\tN/A\tN/A";
  }
  row += is_target ? "\t1.0\t1.0\t0.0\t10\t" : "\t0.0\t1.0\t0.0\t2\t";
  row += quoted(item.name) + "\t0\t0\t0\tFalse\tFalse\t1\tNone\tNone\tNone\tNone\tNone\tNone\t";
  return row + (is_target ? "3" : "1") + "\t0.0\t0.0\tNone\t[]\t\"" + time + "\"" + world + "\n";
}

}  // namespace

bool isInvesalius(const std::string& content) { return startsWith(content, kMagic); }

OtherFile readInvesalius(const Source& source) {
  const auto lines = linesOf(source.content);
  const auto version = valueIn(lines[0].substr(std::string(kMagic).size()));
  if (!version || *version < 0 || *version > 5)
    refuseFile(source.path, "line 1", "is of a version of InVesalius's markers that is not read",
               "0 to 5 are");
  if (!source.t1) refuseFile(source.path, "", "needs the T1: its places are those of the image");
  if (lines.size() < 2) refuseFile(source.path, "", "is cut short", "copy or export it again");
  std::vector<std::string> names;
  for (const auto& cell : cellsOf(lines[1], '\t')) names.push_back(plain(cell));
  const Columns columns(names);
  for (const char* needed : kNeeded)
    if (!columns.has(needed))
      refuseFile(source.path, "line 2", "its column '" + std::string(needed) + "' is missing");
  const InvesaliusSpace image(source.t1->grid);
  OtherFile file;
  file.words = formatted("InVesalius markers, version %.0f", *version);
  file.space_words = "RAS";
  file.notes.push_back("its places are those of the image: taken as the case's T1");
  for (std::size_t i = 2; i < lines.size(); ++i) {
    if (trimmed(lines[i]).empty()) continue;
    const auto cells = cellsOf(lines[i], '\t');
    const std::string where = formatted("line %d", int(i) + 1);
    for (const char* needed : kNeeded)
      if (columns.index().at(needed) >= cells.size())
        refuseFile(source.path, where, "is cut short", "copy or export it again");
    file.items.push_back(itemOf(columns, cells, image));
    file.items.back().where = where;
  }
  return file;
}

Written writeInvesalius(const Order& order) {
  const InvesaliusSpace image(order.t1.grid);
  const auto targets = targetsOf(order);
  Written written;
  written.content = kMagic + std::string("5\n");
  for (const char* name : kNames)
    written.content += (name == kNames[0] ? "\"" : "\t\"") + std::string(name) + "\"";
  written.content += "\n";
  int id = 0;
  bool is_ascii = true;
  const std::string time = order.utc.substr(0, 19);
  for (const auto& item : order.items) {
    const bool is_wanted =
        (item.kind == Kind::target && item.mri_T_coil) || (item.kind == Kind::landmark && item.mri_place);
    if (!is_wanted) continue;
    written.content += rowOf(item, id++, image, time);
    for (const char c : item.name) is_ascii &= (static_cast<unsigned char>(c) < 0x80);
  }
  if (!is_ascii) written.notes.push_back("names are UTF-8; InVesalius on Windows may show other letters");
  notePulsesLeft(order, written, "InVesalius's file");
  return written;
}

}  // namespace facenav::interop
