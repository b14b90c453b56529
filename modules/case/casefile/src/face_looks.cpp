#include "facenav/casefile/face_looks.h"

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "facenav/cameras/rig_file.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/whole_folder.h"
#include "facenav/geometry/json_transform.h"
#include "utc_now.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

constexpr int kVersion = 1;

fs::path folderIn(const fs::path& case_folder) { return case_folder / "face_looks"; }

void writePicture(const cv::Mat& picture, const fs::path& path) {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", picture, bytes)) throw Error("a picture could not be written", path.string());
  writeWholeFile(path, std::string(bytes.begin(), bytes.end()), FileAccess::owner_only);
}

cv::Mat readPicture(const fs::path& path, const cameras::StereoRig& rig) {
  const cv::Mat picture = cv::imread(path.string(), cv::IMREAD_GRAYSCALE);
  if (picture.cols != rig.width_px || picture.rows != rig.height_px)
    throw Error("this picture of the face is missing, or not of its rig's size", path.string(),
                "delete the folder face_looks; the next session makes new key frames");
  return picture;
}

nlohmann::ordered_json written(const StoredKeyFrame& look, const fs::path& folder, std::size_t number) {
  const std::string name = std::to_string(number);
  writePicture(look.frame.left, folder / (name + "_left.png"));
  writePicture(look.frame.right, folder / (name + "_right.png"));
  cameras::writeRig(look.rig, folder / (name + "_stereo.yml"), {});
  nlohmann::ordered_json json;
  json["name"] = name;
  json["captured_utc"] = look.captured_utc;
  json["camera_T_mri"] = rowMajor(look.camera_T_mri);
  json["covariance"] = std::vector<double>(look.covariance.data(), look.covariance.data() + 36);
  return json;
}

StoredKeyFrame readLook(const JsonReader& json, const fs::path& folder) {
  StoredKeyFrame look;
  const fs::path name = fs::path(json.at("name").text()).filename();
  look.rig = cameras::readRig(folder / (name.string() + "_stereo.yml"));
  look.frame.left = readPicture(folder / (name.string() + "_left.png"), look.rig);
  look.frame.right = readPicture(folder / (name.string() + "_right.png"), look.rig);
  look.captured_utc = json.at("captured_utc").text();
  look.camera_T_mri = readTransform<Camera, Mri>(json.at("camera_T_mri"));
  const auto values = json.at("covariance").numbers(36);
  look.covariance = Eigen::Map<const Matrix6d>(values.data());
  return look;
}

}  // namespace

std::vector<StoredKeyFrame> readKeyFrames(const fs::path& case_folder) {
  const fs::path folder = folderIn(case_folder);
  if (!fs::exists(folder)) return {};
  const JsonReader json = JsonReader::readFile(folder / "looks.json");
  if (json.at("version").integer() != kVersion) json.at("version").refuse("version 1 was expected");
  std::vector<StoredKeyFrame> key_frames;
  for (const auto& look : json.at("looks").elements()) key_frames.push_back(readLook(look, folder));
  return key_frames;
}

void addKeyFrames(const fs::path& case_folder, std::vector<StoredKeyFrame> key_frames) {
  if (key_frames.empty()) return;
  for (auto& look : key_frames)
    if (look.captured_utc.empty()) look.captured_utc = utcNow();
  std::vector<StoredKeyFrame> all = readKeyFrames(case_folder);
  all.insert(all.end(), key_frames.begin(), key_frames.end());
  if (all.size() > kMostLooks) all.erase(all.begin(), all.end() - std::ptrdiff_t(kMostLooks));
  WholeFolder fresh(folderIn(case_folder), FileAccess::owner_only, Existing::replace);
  nlohmann::ordered_json json;
  json["version"] = kVersion;
  json["looks"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < all.size(); ++i)
    json["looks"].push_back(written(all[i], fresh.temporaryPath(), i));
  writeWholeFile(fresh.temporaryPath() / "looks.json", json.dump(1) + "\n", FileAccess::owner_only);
  fresh.commit();
}

}  // namespace facenav::casefile
