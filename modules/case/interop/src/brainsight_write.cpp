#include "facenav/core/number_text.h"
#include "facenav/interop/axes.h"
#include "facenav/interop/brainsight_errors.h"
#include "readers.h"
#include "text.h"

// Brainsight's text export, version 12 in NIfTI:Aligned: what every reader takes.

namespace facenav::interop {
namespace {

constexpr const char* kPoseColumns =
    "Loc. X\tLoc. Y\tLoc. Z\tm0n0\tm0n1\tm0n2\tm1n0\tm1n1\tm1n2\tm2n0\tm2n1\tm2n2";
constexpr const char* kNull = "\t(null)";

std::string cells(const Eigen::Vector3d& v) {
  std::string text;
  for (int i = 0; i < 3; ++i) text += "\t" + plainFixed(v[i], 4);
  return text;
}

std::string poseCells(const RigidTransform<Mri, Coil>& pose) {
  const Eigen::Matrix4d theirs = fromFaceNav(pose.matrix(), CoilAxes::brainsight);
  std::string text = cells(theirs.block<3, 1>(0, 3));
  for (int axis = 0; axis < 3; ++axis) text += cells(theirs.block<3, 1>(0, axis));
  return text;
}

/// A name as a cell: tabs and line breaks would end it.
std::string cell(std::string text) {
  for (char& c : text)
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  return text.empty() ? "(null)" : text;
}

std::string optional(const std::optional<double>& value, int decimals) {
  return value ? "\t" + plainFixed(*value, decimals) : std::string(kNull);
}

std::string errorCells(const Item& pulse, const std::vector<const Item*>& targets) {
  for (const auto* target : targets) {
    if (target->name != pulse.target) continue;
    const auto e = brainsightErrors(*pulse.mri_T_coil, *target->mri_T_coil);
    std::string text;
    for (const double value : {e.distance_mm, e.target_mm, e.angular_deg, e.twist_deg})
      text += "\t" + plainFixed(value, 4);
    return text;
  }
  return std::string(kNull) + kNull + kNull + kNull;
}

std::string pulseRow(const Item& pulse, int index, const std::vector<const Item*>& targets) {
  std::string row = cell(pulse.name) + "\t" + cell(pulse.session) + "\t" + std::to_string(index) + "\t" +
                    cell(pulse.target) + poseCells(*pulse.mri_T_coil) + errorCells(pulse, targets);
  row += optional(pulse.intensity_pct, 1) + kNull + kNull;
  row += pulse.clock_s ? "\t" + dateOf(*pulse.clock_s) + "\t" + timeOf(*pulse.clock_s)
                       : std::string(kNull) + kNull;
  const auto comment = pulse.values.find("Comment");
  row += "\tTTL1\tCoil 1\t0.0000\t" + cell(comment == pulse.values.end() ? "" : comment->second);
  // EMG Start, End, Res.; channels; window start, end; peak-to-peak and data of channel 1.
  row += std::string(kNull) + kNull + kNull + (pulse.mep_uv ? "\t1" : kNull) + kNull + kNull;
  row += optional(pulse.mep_uv, 4) + kNull;
  return row + "\n";
}

std::string pulseSection(const Order& order, const std::vector<const Item*>& targets, Written& written) {
  int index = 0, without_pose = 0;
  std::string rows;
  for (const auto& item : order.items) {
    if (item.kind != Kind::pulse) continue;
    ++index;
    if (item.mri_T_coil)
      rows += pulseRow(item, index, targets);
    else
      ++without_pose;
  }
  if (without_pose > 0)
    written.notes.push_back(formatted(
        "%d pulses without a pose are left out: readers of Brainsight's text stop at them", without_pose));
  if (rows.empty()) return {};
  return std::string("# Sample Name\tSession Name\tIndex\tAssoc. Target\t") + kPoseColumns +
         "\tDist. to Target\tTarget Error\tAngular Error\tTwist Error\tStim. Power A\tStim. Pulse Interval\t"
         "Stim. Power B\tDate\tTime\tCreation Cause\tCrosshairs Driver\tOffset\tComment\tEMG Start\tEMG End\t"
         "EMG Res.\tEMG Channels\tEMG Window Start\tEMG Window End\tEMG Peak-to-peak 1\tEMG Data 1\n" +
         rows;
}

std::string landmarkSection(const Order& order) {
  std::string rows;
  for (const auto& item : order.items)
    if (item.kind == Kind::landmark && item.mri_place)
      rows += cell(item.name) + cells(item.mri_place->mm) + "\n";
  return rows.empty() ? rows : "# Planned Landmark Name\tLoc. X\tLoc. Y\tLoc. Z\n" + rows;
}

}  // namespace

Written writeBrainsight(const Order& order) {
  const auto targets = targetsOf(order);
  Written written;
  std::string& text = written.content;
  text =
      "# Version: 12\n# Coordinate system: NIfTI:Aligned\n# Created by: " + order.software + " (" +
      order.t1.used +
      ")\n# Units: millimetres, degrees, milliseconds, and microvolts\n# Encoding: UTF-8\n"
      "# Notes: Each column is delimited by a tab. Each value within a column is delimited by a semicolon.\n";
  text += std::string("# Target Name\t") + kPoseColumns + "\n";
  for (const auto* target : targets) text += cell(target->name) + poseCells(*target->mri_T_coil) + "\n";
  text += pulseSection(order, targets, written);
  text += landmarkSection(order);
  if (const double apart_mm = order.t1.formsApart_mm(); apart_mm > 0.1)
    written.notes.push_back(
        formatted("sform and qform of the T1 lie up to %.1f mm apart; the file is in the %s", apart_mm,
                  order.t1.used.c_str()));
  return written;
}

}  // namespace facenav::interop
