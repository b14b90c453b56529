#include "facenav/casefile/poses_csv.h"

#include <cmath>

#include "facenav/core/csv_table.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace {

struct Columns {
  std::size_t frame, t_s, object, status, tx, ty, tz, qw, qx, qy, qz, quality, reason;
  std::optional<std::size_t> of_frame, detail;  // optional: other tools' files lack them
  explicit Columns(const CsvTable& table)
      : frame(table.column("frame")),
        t_s(table.column("t_s")),
        object(table.column("object")),
        status(table.column("status")),
        tx(table.column("tx")),
        ty(table.column("ty")),
        tz(table.column("tz")),
        qw(table.column("qw")),
        qx(table.column("qx")),
        qy(table.column("qy")),
        qz(table.column("qz")),
        quality(table.column("quality")),
        reason(table.column("reason")),
        of_frame(table.findColumn("of_frame")),
        detail(table.findColumn("detail")) {}
};

PoseObject readObject(const CsvTable& table, std::size_t row, const Columns& columns) {
  const std::string& word = table.text(row, columns.object);
  if (word == "head") return PoseObject::head;
  if (word == "coil") return PoseObject::coil;
  table.refuse(row, "object must be head or coil, not '" + word + "'");
}

Eigen::Isometry3d readPose(const CsvTable& table, std::size_t row, const Columns& columns) {
  const Eigen::Quaterniond q(table.number(row, columns.qw), table.number(row, columns.qx),
                             table.number(row, columns.qy), table.number(row, columns.qz));
  if (std::abs(q.norm() - 1.0) > 1e-3) table.refuse(row, "the quaternion is not of unit length");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = q.normalized().toRotationMatrix();
  pose.translation() << table.number(row, columns.tx), table.number(row, columns.ty),
      table.number(row, columns.tz);
  return pose;
}

PoseRow readRow(const CsvTable& table, std::size_t row, const Columns& columns) {
  PoseRow pose;
  pose.frame = table.integer(row, columns.frame);
  pose.t_s = table.number(row, columns.t_s);
  pose.object = readObject(table, row, columns);
  if (columns.of_frame) pose.of_frame = table.text(row, *columns.of_frame);
  if (columns.detail) pose.detail = table.text(row, *columns.detail);
  const std::string& status = table.text(row, columns.status);
  if (status == "tracked") {
    pose.pose = readPose(table, row, columns);
    pose.quality = table.number(row, columns.quality);
    if (pose.quality < 0 || pose.quality > 1) table.refuse(row, "quality must lie in 0..1");
  } else if (status == "lost") {
    try {
      pose.reason = lostReasonFromString(table.text(row, columns.reason));
    } catch (const Error& fault) {
      table.refuse(row, fault.what());
    }
  } else {
    table.refuse(row, "status must be tracked or lost, not '" + status + "'");
  }
  return pose;
}

}  // namespace

std::string posesCsvHeader() {
  return "frame,t_s,object,status,tx,ty,tz,qw,qx,qy,qz,quality,reason,of_frame,detail\n";
}

std::string toCsvLine(const PoseRow& row) {
  std::string line = std::to_string(row.frame) + "," + fixed(row.t_s, 6) + "," +
                     (row.object == PoseObject::head ? "head," : "coil,");
  if (!row.pose)
    return line + "lost,,,,,,,,0," + toString(row.reason.value_or(LostReason::stale)) + "," + row.of_frame +
           "," + row.detail + "\n";
  Eigen::Quaterniond q(row.pose->linear());
  q.normalize();
  if (q.w() < 0) q.coeffs() *= -1;
  line += "tracked";
  for (int i = 0; i < 3; ++i) line += "," + fixed(row.pose->translation()[i], 6);
  for (const double value : {q.w(), q.x(), q.y(), q.z()}) line += "," + fixed(value, 9);
  return line + "," + fixed(row.quality, 4) + ",," + row.of_frame + ",\n";
}

std::string secondCoilHeader(const std::string& header) { return ofSecondCoil(header, "coil"); }

std::string ofSecondCoil(const std::string& line, const std::string& coil) {
  return line.substr(0, line.size() - 1) + "," + csvField(coil) + "\n";
}

std::filesystem::path secondCoilPath(const std::filesystem::path& path) {
  return path.parent_path() / (path.stem().string() + "_coil2" + path.extension().string());
}

void writePoses(const std::vector<PoseRow>& rows, const std::filesystem::path& path,
                const std::string& second_coil) {
  std::string content = secondCoilHeader(posesCsvHeader());
  for (const PoseRow& row : rows) content += ofSecondCoil(toCsvLine(row), second_coil);
  writeWholeFile(path, content);
}

void writePoses(const std::vector<PoseRow>& rows, const std::filesystem::path& path) {
  std::string content = posesCsvHeader();
  for (const PoseRow& row : rows) content += toCsvLine(row);
  writeWholeFile(path, content);
}

std::vector<PoseRow> readPoses(const std::filesystem::path& path) {
  const CsvTable table(path);
  const Columns columns(table);
  std::vector<PoseRow> rows;
  rows.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) rows.push_back(readRow(table, row, columns));
  return rows;
}

}  // namespace facenav::casefile
