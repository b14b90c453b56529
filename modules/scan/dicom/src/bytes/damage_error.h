#pragma once
// DamageError: a file that is DICOM by its first bytes but cannot be read as such. The fault is stored apart
// from the message's file name and remedy, so that a list of series can name it.

#include <filesystem>
#include <string>

#include "facenav/core/error.h"

namespace facenav::dicom {

class DamageError : public Error {
 public:
  DamageError(const std::string& fault, const std::filesystem::path& file)
      : Error(fault, file.string(), "copy or export it again"), fault_(fault) {}
  const std::string& fault() const { return fault_; }

 private:
  std::string fault_;
};

}  // namespace facenav::dicom
