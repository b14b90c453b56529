#include <algorithm>
#include <deque>
#include <memory>

#include "bright_and_dark.h"
#include "bytes/for_files.h"
#include "facenav/core/error.h"
#include "facenav/dicom/series.h"
#include "facenav/volume/voxel_storage.h"
#include "pixels/isolated_codec.h"
#include "pixels/pixel_decoder.h"
#include "series_stack.h"

namespace facenav::dicom {
namespace {

/// Decodes each file's images once, in any order of the stack.
class Loader {
 public:
  Loader(std::vector<SliceHeader>& headers, const SliceStack& stack, TaskMonitor& monitor)
      : headers_(headers),
        stack_(stack),
        monitor_(monitor),
        scratch_(workersFor(headers.size())),
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
    volume.voxels = volume::voxelStorage(volume.grid.count());
    forFiles(headers_.size(), monitor_, kStep, [&](std::size_t h, std::size_t worker) {
      if (!usesForeignCodec(headers_[h]))
        decode(h, slices_of_[h], Isolation::none, scratch_[worker],
               [&](int k) { return sliceOf(volume, k); });
    });
    decompress(volume);
    for (std::size_t h = 0; h < headers_.size(); ++h) checkTwins(h, volume);
    monitor_.report(kStep, 1.0);
    return volume;
  }

 private:
  static constexpr const char* kStep = "reading DICOM images";

  std::size_t imageSize() const {
    return std::size_t(stack_.grid.size[0]) * std::size_t(stack_.grid.size[1]);
  }

  float* sliceOf(volume::Volume& volume, int k) const {
    return volume.voxels.data() + imageSize() * std::size_t(k);
  }

  std::size_t fileOf(int k) const { return std::size_t(stack_.order[std::size_t(k)].header); }

  /// Decodes slices of file `h`; `place(k)` is the destination of slice k.
  template <class Place>
  void decode(std::size_t h, const std::vector<int>& slices, Isolation isolation, std::string& scratch,
              Place place) {
    if (slices.empty()) return;
    FilePrefix file(headers_[h].file);
    if (headers_[h].layout.is_deflated) headers_[h].layout = walkHeader(file);
    const VoxelFormat& voxels = headers_[h].voxels;
    FACENAV_EXPECT(std::size_t(voxels.rows) * voxels.columns == imageSize(),
                   "an image of another size than its stack");
    const PixelDecoder decoder(file, headers_[h], isolation);
    for (const int k : slices) decoder.decode(stack_.order[std::size_t(k)].frame, place(k), scratch);
  }

  /// Slices that one child process decompresses: starting a child costs a millisecond or more.
  struct Batch {
    Batch(Loader& loader, std::vector<int> wanted)
        : slices(std::move(wanted)),
          image_bytes(loader.imageSize() * sizeof(float)),
          images(slices.size() * image_bytes),
          child(runCodec([this, &loader] {
            for (auto begin = slices.begin(); begin != slices.end();) {
              const std::size_t file = loader.fileOf(*begin);
              const auto end =
                  std::find_if(begin, slices.end(), [&](int k) { return loader.fileOf(k) != file; });
              loader.decode(file, {begin, end}, Isolation::none, loader.scratch_[0],
                            [this](int k) { return place(k); });
              begin = end;
            }
          })) {}
    float* place(int k) const {
      const auto at = std::find(slices.begin(), slices.end(), k) - slices.begin();
      return reinterpret_cast<float*>(images.begin() + std::size_t(at) * image_bytes);
    }
    std::vector<int> slices;
    std::size_t image_bytes;
    SharedMemory images;
    ChildProcess child;  // declared last: starts when the other members exist
  };

  /// Decompresses the compressed files' slices, with as many batches at a time as there are cores.
  void decompress(volume::Volume& volume) {
    constexpr std::size_t kImages = 16;
    std::vector<int> slices;
    for (std::size_t h = 0; h < headers_.size(); ++h)
      if (usesForeignCodec(headers_[h]))
        slices.insert(slices.end(), slices_of_[h].begin(), slices_of_[h].end());
    const std::size_t cores = coreCount();
    std::deque<std::unique_ptr<Batch>> running;
    for (std::size_t next = 0; next < slices.size() || !running.empty();) {
      monitor_.report(kStep, double(next) / double(slices.size()));
      if (next < slices.size() && running.size() < cores) {
        const std::size_t end = std::min(slices.size(), next + kImages);
        running.push_back(std::make_unique<Batch>(
            *this,
            std::vector<int>(slices.begin() + std::ptrdiff_t(next), slices.begin() + std::ptrdiff_t(end))));
        next = end;
      } else {
        finish(*running.front(), volume);
        running.pop_front();
      }
    }
  }

  void finish(Batch& batch, volume::Volume& volume) {
    if (batch.child.wait().isDone()) {
      for (const int k : batch.slices) std::copy_n(batch.place(k), imageSize(), sliceOf(volume, k));
      return;
    }
    for (const int k : batch.slices)  // one at a time, to name the faulty file
      decode(fileOf(k), {k}, Isolation::each_image, scratch_[0], [&](int) { return sliceOf(volume, k); });
  }

  /// Further images at the place of a slice must equal it.
  void checkTwins(std::size_t h, const volume::Volume& volume) {
    if (twins_of_[h].empty()) return;
    FilePrefix file(headers_[h].file);
    if (headers_[h].layout.is_deflated) headers_[h].layout = walkHeader(file);
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
  std::vector<std::string> scratch_;                        // one per thread
  std::vector<std::vector<int>> slices_of_;                 // per file: its slices in the stack
  std::vector<std::vector<std::pair<int, int>>> twins_of_;  // per file: frames and the slice that they repeat
};

}  // namespace

volume::Volume loadSeries(const SeriesInfo& series, TaskMonitor& monitor) {
  constexpr std::size_t kMostVoxels = 1'000'000'000;
  auto [headers, stack] = readStack(series, monitor);
  if (stack.grid.count() > kMostVoxels)
    throw Error("the series is too large to read", series.files[0].string(), "choose another series");
  volume::Volume volume = Loader(headers, stack, monitor).load();
  const auto inverted = std::count_if(headers.begin(), headers.end(), isStoredInverted);
  if (inverted > 0 && std::size_t(inverted) < headers.size())
    throw Error("bright and dark are exchanged in some of its images (MONOCHROME1)", series.files[0].string(),
                "choose another series");
  if (inverted > 0) darkenAir(volume);
  return volume;
}

}  // namespace facenav::dicom
