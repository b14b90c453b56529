#include "facenav/core/data_folder.h"
#include "facenav/core/error.h"
#include "prior/brain_prior.h"

namespace facenav::segmentation {
namespace {

InstalledPrior readInstalled() {
  try {
    return {PriorNetwork(dataFolder() / "brain_prior/weights.fnbp"), {}};
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
