#include "facenav/casefile/case_place.h"

#include "case_json.h"
#include "case_path.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_folder.h"

namespace facenav::casefile {
namespace fs = std::filesystem;

void requireReplaceable(const fs::path& folder, bool replace) {
  if (!fs::exists(folder) || (fs::is_directory(folder) && fs::is_empty(folder))) return;
  if (!isCase(folder)) throw Error("exists and is no case", folder.string(), "choose another folder");
  if (!replace)
    throw Error("a case exists there already", folder.string(), "choose another folder, or replace it");
  requireNotNewer(folder / "case.json");
}

void requireWritablePlace(const fs::path& folder, bool replace) {
  const fs::path place = cleaned(folder);
  requireReplaceable(place, replace);
  const WholeFolder trial(place, FileAccess::owner_only, Existing::replace);  // removed: it is not committed
}

void requireSpaceFor(const fs::path& folder, const volume::Volume& mri) {
  constexpr double kMegabyte = 1e6, kSurfaces = 45e6, kBytesAVoxel = 1;  // compressed MRI and masks
  const fs::path place = cleaned(folder);
  std::error_code unknown;
  const auto space = fs::space(place.parent_path(), unknown);
  const double needed = kSurfaces + kBytesAVoxel * double(mri.grid.count());
  if (unknown || double(space.available) >= needed) return;
  throw Error(formatted("the disk has %.0f MB left, a case of this scan needs about %.0f MB",
                        double(space.available) / kMegabyte, needed / kMegabyte),
              place.string(), "free some space or choose another disk");
}

}  // namespace facenav::casefile
