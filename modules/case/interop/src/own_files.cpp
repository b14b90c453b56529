#include <cmath>

#include "facenav/core/csv_table.h"
#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"
#include "facenav/geometry/json_transform.h"
#include "json_pose.h"
#include "readers.h"
#include "text.h"

// FaceNav's own table of targets and pulses, and targets.json. The table also takes pulses.csv, and a pose as
// m00..m23 in place of tx..qw.

namespace facenav::interop {
namespace {

using Json = nlohmann::ordered_json;

std::optional<Eigen::Matrix4d> poseOf(const Columns& columns, const std::vector<std::string>& cells,
                                      std::string& refusal) {
  if (columns.has("m00")) {
    std::vector<double> numbers;
    for (int i = 0; i < 12; ++i) numbers.push_back(columns.number(cells, formatted("m%d%d", i / 4, i % 4)));
    return poseOfRows(numbers);
  }
  if (columns.text(cells, "tx").empty() && columns.text(cells, "qw").empty()) return std::nullopt;
  const Eigen::Quaterniond q(columns.number(cells, "qw"), columns.number(cells, "qx"),
                             columns.number(cells, "qy"), columns.number(cells, "qz"));
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  const bool is_unit = std::abs(q.norm() - 1.0) < 1e-2;
  if (!is_unit && std::isfinite(q.norm()))
    refusal = formatted("its quaternion has the length %.3g instead of 1", q.norm());
  pose.topLeftCorner<3, 3>() = is_unit ? Eigen::Matrix3d(q.normalized().toRotationMatrix())
                                       : Eigen::Matrix3d(Eigen::Matrix3d::Constant(std::nan("")));
  pose.topRightCorner<3, 1>() << columns.number(cells, "tx"), columns.number(cells, "ty"),
      columns.number(cells, "tz");
  return pose;
}

Kind kindOf(const std::string& word, bool is_pulses) {
  if (word.empty()) return is_pulses ? Kind::pulse : Kind::target;
  for (const Kind kind : {Kind::target, Kind::pulse, Kind::landmark, Kind::electrode})
    if (toString(kind) == word) return kind;
  return Kind::target;
}

Item itemOf(const Columns& columns, const std::vector<std::string>& cells) {
  const bool is_pulses = columns.has("pulse");
  Item item;
  item.kind = kindOf(columns.text(cells, "kind"), is_pulses);
  item.name = columns.text(cells, is_pulses ? "pulse" : "name");
  if (is_pulses) item.name = "pulse " + item.name;
  if (item.kind == Kind::landmark) {
    item.place_mm = Eigen::Vector3d(columns.number(cells, "tx"), columns.number(cells, "ty"),
                                    columns.number(cells, "tz"));
    return item;
  }
  item.pose = poseOf(columns, cells, item.refusal);
  if (!item.refusal.empty()) item.pose.reset();
  if (!item.pose)
    item.reason = columns.text(cells, "reason").empty() ? "no pose" : columns.text(cells, "reason");
  item.target = columns.text(cells, "target");
  item.session = columns.text(cells, "session");
  const std::string utc = columns.text(cells, "utc");
  item.clock_s = secondsOfUtc(utc);
  if (item.clock_s) item.time = dateOf(*item.clock_s) + " " + timeOf(*item.clock_s);
  item.intensity_pct = valueIn(columns.text(cells, "intensity_pct"));
  item.mep_uv = valueIn(columns.text(cells, "mep_uv"));
  return item;
}

std::string optional(const std::optional<double>& value) {
  return value ? formatted("%.9g", *value) : std::string();
}

}  // namespace

bool isOwnCsv(const std::string& content) {
  const auto lines = linesOf(content.substr(0, 4000));
  if (lines.empty()) return false;
  const Columns columns(csvCellsOf(lines[0]));
  return (columns.has("name") || columns.has("pulse")) &&
         ((columns.has("tx") && columns.has("qw")) || columns.has("m00"));
}

OtherFile readOwnCsv(const Source& source) {
  const auto lines = linesOf(source.content);
  const auto names = csvCellsOf(lines[0]);
  const Columns columns(names);
  OtherFile file;
  file.words = "table of FaceNav";
  file.is_clock_utc = true;
  file.space_words = "RAS";
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (trimmed(lines[i]).empty()) continue;
    const std::string where = formatted("line %d", int(i) + 1);
    const auto cells = csvCellsOf(lines[i]);
    if (endsInQuotes(lines[i])) refuseFile(source.path, where, "is cut short", "copy or export it again");
    if (cells.size() != names.size())
      refuseFile(source.path, where,
                 formatted("has %d fields, the header %d", int(cells.size()), int(names.size())));
    file.items.push_back(itemOf(columns, cells));
    file.items.back().where = where;
  }
  return file;
}

Written writeOwnCsv(const Order& order) {
  Written written;
  written.content = "kind,name,tx,ty,tz,qw,qx,qy,qz,utc,session,target,intensity_pct,mep_uv,reason\n";
  for (const auto& item : order.items) {
    std::string& text = written.content;
    text += toString(item.kind) + "," + csvField(item.name);
    if (item.mri_T_coil) {
      const auto p = item.mri_T_coil->translation_mm();
      const auto q = item.mri_T_coil->quaternion();
      for (const double value : {p.x(), p.y(), p.z()}) text += "," + plainFixed(value, 6);
      for (const double value : {q.w(), q.x(), q.y(), q.z()}) text += "," + plainFixed(value, 9);
    } else if (item.mri_place) {
      for (int i = 0; i < 3; ++i) text += "," + plainFixed(item.mri_place->mm[i], 6);
      text += ",,,,";
    } else {
      text += ",,,,,,,";
    }
    text += "," + (item.clock_s ? dateOf(*item.clock_s) + "T" + timeOf(*item.clock_s) + "Z" : std::string());
    text += "," + csvField(item.session) + "," + csvField(item.target) + "," + optional(item.intensity_pct) +
            "," + optional(item.mep_uv) + "," + csvField(item.reason) + "\n";
  }
  return written;
}

bool isOwnJson(const std::string& content) { return isJsonWith(content, {"targets", "mri_T_target"}); }

OtherFile readOwnJson(const Source& source) {
  OtherFile file;
  file.words = "targets.json of FaceNav";
  file.space_words = "RAS";
  int number = 0;
  for (const auto& target : jsonOf(source, "targets").at("targets").elements()) {
    Item item;
    item.where = formatted("targets[%d]", number++);
    item.name = target.at("name").text();
    item.pose = poseOfRows(target.at("mri_T_target").numbers(16));
    if (isGiven(target, "cortex_point_mm"))
      item.cortex_point_mm = readPoint<Mri>(target.at("cortex_point_mm")).mm;
    if (isGiven(target, "scalp_point_mm"))
      item.scalp_point_mm = readPoint<Mri>(target.at("scalp_point_mm")).mm;
    file.items.push_back(item);
  }
  return file;
}

Written writeOwnJson(const Order& order) {
  Json targets = Json::array();
  for (const auto* target : targetsOf(order)) {
    const auto three = [&](const std::optional<Eigen::Vector3d>& p) {
      const Eigen::Vector3d v = p.value_or(target->mri_T_coil->translation_mm());
      return Json{v.x(), v.y(), v.z()};
    };
    targets.push_back({{"name", target->name},
                       {"mri_T_target", rowMajor(*target->mri_T_coil)},
                       {"cortex_point_mm", three(target->cortex_point_mm)},
                       {"scalp_point_mm", three(target->scalp_point_mm)},
                       {"note", ""}});
  }
  Written written;
  written.content = jsonText({{"targets", targets}});
  notePulsesLeft(order, written, "targets.json");
  return written;
}

}  // namespace facenav::interop
