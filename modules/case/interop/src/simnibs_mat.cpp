#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "mat5.h"
#include "readers.h"
#include "text.h"

// SimNIBS's session as .mat: the fields of sim_struct.SESSION, TMSLIST and POSITION. SimNIBS stores the
// session's fields as variables; MATLAB's users often store one structure.

namespace facenav::interop {
namespace {

using Fields = std::map<std::string, MatValue>;

const MatValue* find(const Fields& fields, const std::string& name) {
  const auto found = fields.find(name);
  return found == fields.end() ? nullptr : &found->second;
}

/// Structures of a value: its own elements, or those of the structures in a cell.
std::vector<const Fields*> structuresOf(const MatValue* value) {
  std::vector<const Fields*> found;
  if (!value) return found;
  for (const auto& element : value->elements) found.push_back(&element);
  for (const auto& cell : value->cells)
    for (const auto& element : cell.elements) found.push_back(&element);
  return found;
}

std::string textIn(const Fields& fields, const std::string& name) {
  const auto* value = find(fields, name);
  if (value && value->type == MatValue::Type::cell && !value->cells.empty()) return value->cells[0].text;
  return value ? value->text : std::string();
}

std::optional<Eigen::Matrix4d> matrixIn(const Fields& position) {
  const auto* value = find(position, "matsimnibs");
  if (!value || value->numbers.empty()) return std::nullopt;
  if (value->numbers.size() != 16) return Eigen::Matrix4d(Eigen::Matrix4d::Constant(std::nan("")));
  return Eigen::Matrix4d(Eigen::Map<const Eigen::Matrix4d>(value->numbers.data()));
}

void addPositions(const Fields& list, int number, OtherFile& file) {
  int position_number = 0;
  for (const auto* position : structuresOf(find(list, "pos"))) {
    Item item;
    item.where = formatted("poslist %d, pos %d", number, ++position_number);
    item.name = textIn(*position, "name");
    item.pose = matrixIn(*position);
    if (!item.pose) item.reason = "it has no matsimnibs: simulate it once, SimNIBS then writes it";
    if (const auto* didt = find(*position, "didt"); didt && !didt->numbers.empty())
      item.didt_a_per_us = didt->numbers[0] / 1e6;
    file.items.push_back(item);
  }
}

}  // namespace

bool isSimnibsMat(const std::string& content) { return startsWith(content, "MATLAB 5.0 MAT-file"); }

OtherFile readSimnibsMat(const Source& source) {
  Fields session;
  for (auto& [name, value] : readMat5(source.content, source.path)) {
    if (value.type == MatValue::Type::structure && value.elements.size() == 1 &&
        value.elements[0].count("poslist"))
      session = value.elements[0];
    else
      session.emplace(name, value);
  }
  if (!session.count("poslist"))
    refuseFile(source.path, "", "holds no session of SimNIBS: 'poslist' is missing");
  OtherFile file;
  file.words = "SimNIBS session";
  file.space_words = "RAS";
  int number = 0;
  for (const auto* list : structuresOf(&session["poslist"])) {
    ++number;
    const std::string type = textIn(*list, "type");
    if (type.empty() || type == "TMSLIST")
      addPositions(*list, number, file);
    else
      file.notes.push_back("a list of type " + type.substr(0, 40) + " is left out");
  }
  return file;
}

Written writeSimnibsMat(const Order& order) {
  const std::vector<std::string> position_fields{"type",   "name",     "matsimnibs", "didt",
                                                 "centre", "pos_ydir", "distance"};
  std::vector<Fields> positions;
  for (const auto* target : targetsOf(order)) {
    const Eigen::Matrix4d m = target->mri_T_coil->matrix();
    positions.push_back({{"type", MatValue::of("POSITION")},
                         {"name", MatValue::of(target->name)},
                         {"matsimnibs", MatValue::of(std::vector<double>(m.data(), m.data() + 16), 4, 4)},
                         {"didt", MatValue::of({target->didt_a_per_us.value_or(1.0) * 1e6}, 1, 1)},
                         {"centre", MatValue::of({}, 0, 0)},
                         {"pos_ydir", MatValue::of({}, 0, 0)},
                         {"distance", MatValue::of({4.0}, 1, 1)}});
  }
  const std::vector<std::string> list_fields{"type", "name", "fnamecoil", "pos"};
  const Fields list{{"type", MatValue::of("TMSLIST")},
                    {"name", MatValue::of(order.coil)},
                    {"fnamecoil", MatValue::of("")},
                    {"pos", MatValue::structureOf(std::move(positions), position_fields)}};
  Written written;
  written.content = mat5Of({{"type", MatValue::of("SESSION")},
                            {"subpath", MatValue::of("")},
                            {"fnamehead", MatValue::of("")},
                            {"pathfem", MatValue::of("simulation")},
                            {"poslist", MatValue::cellOf({MatValue::structureOf({list}, list_fields)})}});
  written.notes.push_back(
      "set subpath and fnamecoil in SimNIBS: the case knows neither m2m folder nor coil file");
  notePulsesLeft(order, written, "SimNIBS's session");
  return written;
}

}  // namespace facenav::interop
