#pragma once
// The header of a written NIfTI file, for tests that change it and write it back.

#include <nifti1.h>

#include <cstring>
#include <filesystem>
#include <string>

#include "facenav/core/whole_file.h"

namespace facenav::testing {

struct Raw {
  std::filesystem::path path;
  nifti_1_header header;
  std::string bytes;

  explicit Raw(const std::filesystem::path& at) : path(at), bytes(readWholeFile(at)) {
    std::memcpy(&header, bytes.data(), sizeof header);
  }
  void save() {
    std::memcpy(bytes.data(), &header, sizeof header);
    writeWholeFile(path, bytes);
  }
};

}  // namespace facenav::testing
