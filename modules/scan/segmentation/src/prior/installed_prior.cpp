#include <cstdlib>

#include "facenav/core/error.h"
#include "prior/brain_prior.h"

namespace facenav::segmentation {
namespace {

std::filesystem::path weightsPath() {
  const char* folder = std::getenv("FACENAV_DATA");
  return std::filesystem::path(folder && *folder ? folder : FACENAV_DATA_DIR) / "brain_prior/weights.fnbp";
}

InstalledPrior readInstalled() {
  try {
    return {PriorNetwork(weightsPath()), {}};
  } catch (const Error& error) {
    return {std::nullopt, error.what()};
  }
}

}  // namespace

const InstalledPrior& installedPrior() {
  static const InstalledPrior installed = readInstalled();
  return installed;
}

}  // namespace facenav::segmentation
