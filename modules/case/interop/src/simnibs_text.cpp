#include <cmath>

#include "facenav/core/csv_table.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "readers.h"
#include "text.h"

// SimNIBS's table of positions (z before y, x = y x z) and its Python script.

namespace facenav::interop {
namespace {

bool isType(const std::string& word) {
  for (const char* type : {"CoilPos", "Fiducial", "Generic", "Electrode", "ReferenceElectrode"})
    if (word == type) return true;
  return false;
}

Eigen::Vector3d threeOf(const std::vector<std::string>& cells, std::size_t first) {
  Eigen::Vector3d v = Eigen::Vector3d::Constant(std::nan(""));
  for (std::size_t i = 0; i < 3; ++i)
    if (first + i < cells.size()) v[Eigen::Index(i)] = numberOrNan(cells[first + i]);
  return v;
}

Item coilOf(const std::vector<std::string>& cells) {
  Item item;
  const Eigen::Vector3d z = threeOf(cells, 4), y = threeOf(cells, 7);
  item.pose = poseOfColumns(threeOf(cells, 1), y.cross(z), y, z);
  if (cells.size() > 11)
    item.name = cells[11];
  else if (cells.size() == 11 && !valueIn(cells[10]))
    item.name = cells[10];  // a table without the distance
  if (const auto distance_mm = cells.size() > 10 ? valueIn(cells[10]) : std::nullopt;
      distance_mm && *distance_mm != 0)
    item.values["distance_mm"] = cells[10];
  return item;
}

/// Text as a literal of Python.
std::string pythonText(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + "'";
}

}  // namespace

bool isSimnibsCsv(const std::string& content) {
  for (const auto& line : linesOf(content.substr(0, 4000))) {
    const std::string first = trimmed(csvCellsOf(line)[0]);
    if (first.empty() || first == "Type") continue;
    return isType(first) && contains(line, ",");
  }
  return false;
}

OtherFile readSimnibsCsv(const Source& source) {
  OtherFile file;
  file.words = "coil positions of SimNIBS";
  file.space_words = "RAS";
  int number = 0;
  for (const auto& line : linesOf(source.content)) {
    ++number;
    const auto cells = csvCellsOf(line);
    const std::string type = trimmed(cells[0]), where = formatted("line %d", number);
    if (type.empty() || (number == 1 && type == "Type")) continue;
    if (!isType(type))
      refuseFile(source.path, where,
                 "begins with '" + type.substr(0, 40) + "', which is no type of SimNIBS's");
    if (endsInQuotes(line) || cells.size() < (type == "CoilPos" ? 10u : 4u))
      refuseFile(source.path, where, "is cut short", "copy or export it again");
    Item item;
    if (type == "CoilPos") {
      item = coilOf(cells);
    } else {
      item.kind = type == "Electrode" || type == "ReferenceElectrode" ? Kind::electrode : Kind::landmark;
      item.place_mm = threeOf(cells, 1);
      // An electrode may have a second point before its name.
      for (std::size_t i = 4; i < cells.size() && item.name.empty(); ++i)
        if (!valueIn(cells[i])) item.name = cells[i];
    }
    item.where = where;
    file.items.push_back(item);
  }
  return file;
}

Written writeSimnibsCsv(const Order& order) {
  Written written;
  const auto targets = targetsOf(order);
  for (const auto& item : order.items) {
    if (item.kind != Kind::landmark || !item.mri_place) continue;
    written.content += "Fiducial";
    for (int i = 0; i < 3; ++i) written.content += "," + plainFixed(item.mri_place->mm[i], 4);
    written.content += "," + csvField(item.name) + "\n";
  }
  for (const auto* target : targets) {
    const Eigen::Matrix4d m = target->mri_T_coil->matrix();
    written.content += "CoilPos";
    for (const int column : {3, 2, 1})
      for (int row = 0; row < 3; ++row) written.content += "," + plainFixed(m(row, column), 6);
    written.content += ",0," + csvField(target->name) + "\n";
  }
  notePulsesLeft(order, written, "SimNIBS's table");
  return written;
}

Written writeSimnibsScript(const Order& order) {
  Written written;
  std::string& text = written.content;
  text =
      "# Simulates the field of every target of a case: simnibs_python THIS_FILE (SimNIBS 4)\n"
      "# Written by " +
      order.software + "; coordinates in the " + order.t1.used +
      " of the case's T1, RAS mm.\n"
      "# Compare that T1 with m2m_<id>/T1.nii.gz: charm may have changed its header.\n"
      "from simnibs import sim_struct, run_simnibs\n\n"
      "s = sim_struct.SESSION()\n"
      "s.subpath = 'm2m_subject'  # change: the folder that charm made\n"
      "s.pathfem = 'simulation'\n"
      "tms = s.add_tmslist()\n"
      "tms.fnamecoil = 'legacy_and_other/Magstim_70mm_Fig8.ccd'  # change: the coil" +
      (order.coil.empty() ? std::string() : "; the case is planned for " + pythonText(order.coil)) + "\n";
  for (const auto* target : targetsOf(order)) {
    const Eigen::Matrix4d m = target->mri_T_coil->matrix();
    text += "\npos = tms.add_position()\npos.name = " + pythonText(target->name) +
            "\npos.didt = " + formatted("%.6g", target->didt_a_per_us.value_or(1.0) * 1e6) +
            "  # A/s\npos.matsimnibs = [";
    for (int row = 0; row < 4; ++row) {
      text += row == 0 ? "[" : ",\n                   [";
      for (int column = 0; column < 4; ++column)
        text += (column == 0 ? "" : ", ") + formatted("%.17g", m(row, column) + 0.0);
      text += "]";
    }
    text += "]\n";
  }
  text += "\nrun_simnibs(s)\n";
  notePulsesLeft(order, written, "the script");
  return written;
}

}  // namespace facenav::interop
