#include "numbered_images.h"

#include <algorithm>
#include <string>

#include "facenav/core/error.h"
#include "grey_image.h"
#include "name_number.h"

namespace facenav::capture {
namespace fs = std::filesystem;

std::vector<NumberedImage> listImages(const fs::path& folder) {
  std::vector<NumberedImage> images;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if (!entry.is_regular_file() || !isImageFile(path) || path.filename().string().front() == '.') continue;
    const auto number = numberInName(path);
    if (!number)
      throw Error("image name holds no frame number", path.string(), "name images 000000.png, 000001.png ..");
    images.push_back({*number, path});
  }
  std::sort(images.begin(), images.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  for (std::size_t i = 1; i < images.size(); ++i)
    if (images[i].number == images[i - 1].number)
      throw Error("two images have the number " + std::to_string(images[i].number) + " (" +
                      images[i - 1].path.filename().string() + ", " + images[i].path.filename().string() +
                      ")",
                  folder.string(), "remove one of them");
  return images;
}

}  // namespace facenav::capture
