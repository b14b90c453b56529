#pragma once
// Reads our files with another program: nibabel (Debian python3-nibabel).

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "support/test_data.h"

namespace facenav::testing {

/// Points that the script `python` prints, one per line. nibabel is imported and the file is loaded as
/// `image`, by `load`. A failed assertion in the script fails the test.
inline std::vector<Eigen::Vector3d> pointsByNibabel(const std::filesystem::path& file,
                                                    const std::string& python,
                                                    const std::string& load = "nibabel.load(sys.argv[1])") {
  const TemporaryFolder folder;
  const auto script = folder.path() / "read.py";
  std::ofstream(script) << "import nibabel, sys\nimage = " << load << "\n" << python;
  std::vector<Eigen::Vector3d> points;
  FILE* pipe = popen(("/usr/bin/python3 '" + script.string() + "' '" + file.string() + "'").c_str(), "r");
  if (!pipe) {
    ADD_FAILURE() << "python3 does not start";
    return points;
  }
  Eigen::Vector3d p;
  while (std::fscanf(pipe, "%lf %lf %lf", &p[0], &p[1], &p[2]) == 3) points.push_back(p);
  EXPECT_EQ(pclose(pipe), 0);
  return points;
}

}  // namespace facenav::testing
