#include "facenav/cameras/projector_model.h"

#include "rig_reader.h"

namespace facenav::cameras {
namespace {

cv::Mat matOf(const Eigen::Matrix3d& m) {
  cv::Mat mat(3, 3, CV_64F);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) mat.at<double>(r, c) = m(r, c);
  return mat;
}

}  // namespace

ProjectorModel readProjector(const std::filesystem::path& path) {
  const RigReader reader(path, "it holds image_width, image_height, K, D, R and T (mm) of the projector");
  ProjectorModel projector;
  projector.width_px = reader.size("image_width");
  projector.height_px = reader.size("image_height");
  projector.lens = readCamera(reader, "");
  projector.projector_T_camera = reader.transform<Projector, Camera>();
  const double away_mm = projector.projector_T_camera.translation_mm().norm();
  if (away_mm > 0 && away_mm < 5.0)
    reader.fail("key 'T' is only " + std::to_string(away_mm) +
                " long: it looks like metres, millimetres are needed");
  return projector;
}

void writeProjector(const ProjectorModel& projector, const std::filesystem::path& path) {
  cv::FileStorage storage(".yml",
                          cv::FileStorage::WRITE | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
  const Eigen::Vector3d t = projector.projector_T_camera.translation_mm();
  storage << "image_width" << projector.width_px << "image_height" << projector.height_px;
  storage << "K" << cv::Mat(projector.lens.k) << "D"
          << (projector.lens.distortion.empty() ? cv::Mat::zeros(1, 5, CV_64F)
                                                : cv::Mat(projector.lens.distortion.reshape(1, 1)));
  storage << "R" << matOf(projector.projector_T_camera.rotation()) << "T"
          << (cv::Mat_<double>(3, 1) << t.x(), t.y(), t.z());
  writeWholeFile(path, storage.releaseAndGetString(), FileAccess::by_umask);
}

}  // namespace facenav::cameras
