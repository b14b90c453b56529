#pragma once
// Made files of other programs, the poses that they hold, and heads to judge them by.

#include <fstream>
#include <map>
#include <sstream>

#include "facenav/core/whole_file.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/interop/check.h"
#include "facenav/interop/formats.h"
#include "support/test_data.h"

namespace facenav::interop::testing {

using Poses = std::map<std::string, RigidTransform<Mri, Coil>>;

/// Files that were made for this project: four poses in each format, written by other code than ours.
inline std::filesystem::path made(const std::string& name) {
  return std::filesystem::path(FACENAV_SOURCE_DIR) / "testing/unit/case/interop/made" / name;
}

/// truth_poses.csv: name and three rows of the pose.
inline Poses truth() {
  Poses poses;
  std::ifstream stream(made("truth_poses.csv"));
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    const auto quote = line.find('"', 1);
    std::istringstream numbers(line.substr(quote + 2));
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    std::string cell;
    for (int i = 0; i < 12 && std::getline(numbers, cell, ','); ++i) pose(i / 4, i % 4) = std::stod(cell);
    poses.emplace(line.substr(1, quote - 1), RigidTransform<Mri, Coil>::fromMatrix(pose));
  }
  return poses;
}

/// The head of the made files: its T1 lies oblique and is stored in the order left, posterior, inferior.
inline CaseHead madeHead() {
  CaseHead head;
  head.t1 = readT1(made("t1_lpi.nii.gz"));
  head.centre_mm = head.t1.grid.centre().mm;
  return head;
}

/// Makes a pulse with intensity and MEP; its pose is added by the test.
inline Item madePulse(const std::string& session, const std::string& target, double clock_s = 1795788309.25) {
  Item pulse;
  pulse.kind = Kind::pulse;
  pulse.session = session;
  pulse.target = target;
  pulse.clock_s = clock_s;
  pulse.intensity_pct = 61.5;
  pulse.mep_uv = 412.25;
  return pulse;
}

/// Makes the landmark nasion.
inline Item nasionAt(const Point<Mri>& place) {
  Item nasion;
  nasion.kind = Kind::landmark;
  nasion.name = "nasion";
  nasion.mri_place = place;
  return nasion;
}

inline OtherFile readChecked(const std::filesystem::path& path, const CaseHead& head,
                             const Answers& answers = {}, const std::optional<T1>& file_t1 = {}) {
  auto file = readOther(path, &head.t1);
  check(file, head, answers, file_t1);
  return file;
}

inline OtherFile readCheckedText(const std::string& content, const CaseHead& head,
                                 const Answers& answers = {}, const std::string& name = "file") {
  auto file = readOtherText({content, name, &head.t1});
  check(file, head, answers);
  return file;
}

/// Largest differences from poses of the same names.
struct Apart {
  double mm = 0, deg = 0;
  int compared = 0;
};
inline Apart apart(const OtherFile& file, const Poses& poses) {
  Apart apart;
  for (const auto& item : file.items) {
    const auto found = poses.find(item.name);
    if (item.kind != Kind::target || found == poses.end() || !item.mri_T_coil) continue;
    const auto error = poseError(*item.mri_T_coil, found->second);
    apart.mm = std::max(apart.mm, error.translation_mm);
    apart.deg = std::max(apart.deg, error.rotation_rad * kDegPerRad);
    ++apart.compared;
  }
  return apart;
}

inline const Item& itemNamed(const OtherFile& file, const std::string& name) {
  for (const auto& item : file.items)
    if (item.name == name) return item;
  throw Error("no item " + name);
}

}  // namespace facenav::interop::testing
