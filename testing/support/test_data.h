#pragma once
// Paths of real data for the tests, and skipping of tests whose data is absent (the skip is reported). No
// data is committed: facenav.sh installs the packages; the shared folder is read in place.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace facenav::testing {

namespace detail {
inline std::filesystem::path fromEnvironment(const char* variable, const std::filesystem::path& otherwise) {
  const char* value = std::getenv(variable);
  return value && *value ? std::filesystem::path(value) : otherwise;
}
}  // namespace detail

/// Real data beside the project (FACENAV_SHARED_DATA, default ../shared/data).
inline std::filesystem::path sharedData() {
  return detail::fromEnvironment("FACENAV_SHARED_DATA",
                                 std::filesystem::path(FACENAV_SOURCE_DIR) / "../shared/data");
}
/// Files that facenav.sh fetched and converted once (FACENAV_CACHE, default build/cache).
inline std::filesystem::path cache() {
  return detail::fromEnvironment("FACENAV_CACHE", std::filesystem::path(FACENAV_SOURCE_DIR) / "build/cache");
}
/// The adult T1 with a whole face (NIfTI), 160 x 224 x 256, 1 mm.
inline std::filesystem::path virtualPatientMri() { return cache() / "virtual_patient/mri.nii.gz"; }
/// Colin27 T1, 1 mm, MNI space (Debian mricron-data); face ends at mid-nose.
inline std::filesystem::path colin27() { return "/usr/share/mricron/templates/ch2.nii.gz"; }
inline std::filesystem::path colin27Brain() { return "/usr/share/mricron/templates/ch2bet.nii.gz"; }
/// One T1 head as DICOM, 384 slices, oblique coronal, face removed below the brow.
inline std::filesystem::path t1Dicom() { return sharedData() / "t1_dicom"; }
/// OpenCV's chessboard stereo pairs left01..14.jpg / right01..14.jpg and aloe (Debian opencv-doc).
inline std::filesystem::path openCvSamples() {
  for (const char* folder :
       {"/usr/share/doc/opencv-doc/examples/data", "/usr/share/doc/opencv-doc/examples/cpp"})
    if (std::filesystem::exists(std::filesystem::path(folder) / "left01.jpg")) return folder;
  return "/usr/share/doc/opencv-doc/examples/data";
}

/// A folder for this test alone, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "facenav_test_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace facenav::testing

/// First line of a test that needs real data: if it is absent, the test is skipped and reported as skipped.
#define FACENAV_NEEDS(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "real data not here: " << (path)
