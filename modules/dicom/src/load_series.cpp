#include <algorithm>
#include <numeric>

#include "facenav/core/error.h"
#include "facenav/dicom/series.h"
#include "isolated_codec.h"
#include "pixel_decoder.h"
#include "series_scan.h"
#include "slice_stack.h"

namespace facenav::dicom {
namespace {

[[noreturn]] void raise(const StackFault& fault) {
  throw Error(fault.what, fault.file.string(), fault.remedy);
}

std::vector<SliceHeader> readHeaders(const SeriesInfo& series, TaskMonitor& monitor) {
  std::vector<SliceHeader> headers;
  for (std::size_t f = 0; f < series.files.size(); ++f) {
    if (f % 16 == 0) monitor.report("reading DICOM headers", double(f) / double(series.files.size()));
    auto header = readHeaderOf(series.files[f]);
    if (!header) throw Error("is not DICOM", series.files[f].string(), "list the series again");
    const std::string problem = voxelProblem(*header);
    if (!problem.empty()) throw Error(problem, series.files[f].string(), "choose another series");
    if (header->series_uid != series.series_uid)
      throw Error("belongs to another series", series.files[f].string(), "list the series again");
    headers.push_back(std::move(*header));
  }
  return headers;
}

std::vector<ImageRef> imagesOf(const SeriesInfo& series, const std::vector<SliceHeader>& headers) {
  std::vector<ImageRef> images;
  for (std::size_t h = 0; h < headers.size(); ++h) {
    std::vector<int> frames(headers[h].images.size());
    std::iota(frames.begin(), frames.end(), 0);
    if (h < series.frames.size()) frames = series.frames[h];
    for (const int frame : frames) {
      if (frame < 0 || std::size_t(frame) >= headers[h].images.size())
        throw Error("does not hold the frame asked for", headers[h].file.string(), "list the series again");
      images.push_back({int(h), frame});
    }
  }
  return images;
}

/// Decodes each file's images once, whatever their order in the stack.
class Loader {
 public:
  Loader(std::vector<SliceHeader>& headers, const SliceStack& stack, TaskMonitor& monitor)
      : headers_(headers),
        stack_(stack),
        monitor_(monitor),
        slices_of_(headers.size()),
        twins_of_(headers.size()) {
    for (std::size_t k = 0; k < stack.order.size(); ++k)
      slices_of_[std::size_t(stack.order[k].header)].push_back(int(k));
    for (const auto& [kept, twin] : stack.coincident) {
      const auto at = std::find_if(stack.order.begin(), stack.order.end(), [kept = kept](ImageRef image) {
        return image.header == kept.header && image.frame == kept.frame;
      });
      twins_of_[std::size_t(twin.header)].push_back({twin.frame, int(at - stack.order.begin())});
    }
  }

  volume::Volume load() {
    volume::Volume volume;
    volume.grid = stack_.grid;
    volume.modality = headers_[0].modality;
    volume.orientation_source = "DICOM";
    volume.voxels.resize(volume.grid.count());
    for (std::size_t h = 0; h < headers_.size();) {
      monitor_.report("reading DICOM images", double(h) / double(headers_.size()));
      const std::size_t end = batchEnd(h);
      if (end > h + 1 && loadBatch(h, end, volume)) {
        h = end;
        continue;
      }
      for (const std::size_t last = std::max(end, h + 1); h < last; ++h)  // one by one: the culprit is named
        loadFile(h, Isolation::each_image, [&](int k) { return sliceOf(volume, k); });
    }
    for (std::size_t h = 0; h < headers_.size(); ++h) checkTwins(h, volume);
    monitor_.report("reading DICOM images", 1.0);
    return volume;
  }

 private:
  std::size_t imageSize() const {
    return std::size_t(stack_.grid.size[0]) * std::size_t(stack_.grid.size[1]);
  }

  float* sliceOf(volume::Volume& volume, int k) const {
    return volume.voxels.data() + imageSize() * std::size_t(k);
  }

  /// Decodes the images of file `h`; `place(k)` is where slice k goes.
  template <class Place>
  void loadFile(std::size_t h, Isolation isolation, Place place) {
    if (slices_of_[h].empty()) return;
    FilePrefix file(headers_[h].file);
    headers_[h].layout = walkHeader(file);
    const VoxelFormat& voxels = headers_[h].voxels;
    FACENAV_EXPECT(std::size_t(voxels.rows) * voxels.columns == imageSize(),
                   "an image of another size than its stack");
    const PixelDecoder decoder(file, headers_[h], isolation);
    for (const int k : slices_of_[h]) decoder.decode(stack_.order[std::size_t(k)].frame, place(k));
  }

  /// One past the files, from `h` on, that one child process decompresses: starting one costs a millisecond
  /// or more.
  std::size_t batchEnd(std::size_t h) const {
    constexpr std::size_t kMostImages = 16;
    std::size_t images = 0;
    while (h < headers_.size() && usesForeignCodec(headers_[h]) &&
           (images += slices_of_[h].size()) <= kMostImages)
      ++h;
    return h;
  }

  /// False where a codec failed on any of the files [begin, end).
  bool loadBatch(std::size_t begin, std::size_t end, volume::Volume& volume) {
    std::vector<int> slices;
    for (std::size_t h = begin; h < end; ++h)
      slices.insert(slices.end(), slices_of_[h].begin(), slices_of_[h].end());
    if (slices.empty()) return true;
    const std::size_t image_bytes = imageSize() * sizeof(float);
    const SharedMemory images(slices.size() * image_bytes);
    const auto place = [&](int k) {
      const auto at = std::find(slices.begin(), slices.end(), k) - slices.begin();
      return reinterpret_cast<float*>(images.begin() + std::size_t(at) * image_bytes);
    };
    if (!runInChild([&] {
          for (std::size_t h = begin; h < end; ++h) loadFile(h, Isolation::none, place);
        }))
      return false;
    for (const int k : slices) std::copy_n(place(k), imageSize(), sliceOf(volume, k));
    return true;
  }

  /// Images at the place of a slice must equal it.
  void checkTwins(std::size_t h, const volume::Volume& volume) {
    if (twins_of_[h].empty()) return;
    FilePrefix file(headers_[h].file);
    headers_[h].layout = walkHeader(file);
    const PixelDecoder decoder(file, headers_[h]);
    for (const auto& [frame, k] : twins_of_[h]) {
      const std::vector<float> image = decoder.image(frame);
      if (!std::equal(image.begin(), image.end(),
                      volume.voxels.begin() + std::ptrdiff_t(imageSize() * std::size_t(k))))
        throw Error("another image lies at the same place", headers_[h].file.string(), "separate the series");
    }
  }

  std::vector<SliceHeader>& headers_;
  const SliceStack& stack_;
  TaskMonitor& monitor_;
  std::vector<std::vector<int>> slices_of_;                 // per file its slices in the stack
  std::vector<std::vector<std::pair<int, int>>> twins_of_;  // per file frames and the slice they repeat
};

}  // namespace

volume::Volume loadSeries(const SeriesInfo& series, TaskMonitor& monitor) {
  constexpr std::size_t kMostVoxels = 1'000'000'000;
  if (series.files.empty())
    throw Error("the series holds no files", series.description, "choose another series");
  std::vector<SliceHeader> headers = readHeaders(series, monitor);
  const SliceStack stack = stackSlices(headers, imagesOf(series, headers));
  if (stack.fault) raise(*stack.fault);
  if (stack.grid.count() > kMostVoxels)
    throw Error("the series is too large to read", series.files[0].string(), "choose another series");
  return Loader(headers, stack, monitor).load();
}

}  // namespace facenav::dicom
