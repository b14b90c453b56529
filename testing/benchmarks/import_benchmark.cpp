// The import compared with GDCM's own reading of the same files: one pass over all headers (gdcm::Reader up
// to the pixels) and one over all voxels (gdcm::ImageReader with decompression). Wall clock and processor
// time, warm file cache, child processes included (codecs run in them). Folders are given as arguments.
// Default: the shared real T1, the odd files, 256 slices of 256 x 256, and 5000 files of all kinds without
// extensions in nested folders.

#include <gdcmImageReader.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <optional>
#include <random>

#include "facenav/core/error.h"
#include "facenav/dicom/import_volume.h"
#include "support/test_data.h"

namespace {

using namespace facenav;
namespace fs = std::filesystem;

std::vector<fs::path> filesOf(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

double processorWithChildren_ms() {
  double sum_ms = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(who, &usage);
    for (const timeval& t : {usage.ru_utime, usage.ru_stime})
      sum_ms += 1e3 * double(t.tv_sec) + 1e-3 * double(t.tv_usec);
  }
  return sum_ms;
}

struct Cost {
  double wall_ms = 0, processor_ms = 0;
  Cost operator+(const Cost& other) const {
    return {wall_ms + other.wall_ms, processor_ms + other.processor_ms};
  }
};

/// Smallest time of each over `runs` runs.
template <class Work>
Cost costOf(Work work, int runs = 5) {
  Cost best{1e12, 1e12};
  for (int i = 0; i < runs; ++i) {
    const double start_ms = processorWithChildren_ms();
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - begin;
    best.wall_ms = std::min(best.wall_ms, wall.count());
    best.processor_ms = std::min(best.processor_ms, processorWithChildren_ms() - start_ms);
  }
  return best;
}

void printRow(const fs::path& folder, std::size_t files, const char* step, const Cost& ours,
              const Cost& gdcm) {
  std::printf("| %s | %zu | %s | %.0f | %.0f | %.2f | %.0f | %.0f | %.2f |\n", folder.filename().c_str(),
              files, step, ours.wall_ms, gdcm.wall_ms, ours.wall_ms / gdcm.wall_ms, ours.processor_ms,
              gdcm.processor_ms, ours.processor_ms / gdcm.processor_ms);
}

void gdcmHeaders(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    reader.ReadUpToTag(gdcm::Tag(0x7FE0, 0x0010));
  }
}

void gdcmVoxels(const std::vector<fs::path>& files) {
  std::vector<char> volume;  // one buffer for all, as a reader of a volume needs it
  for (const fs::path& file : files) {
    gdcm::ImageReader reader;
    reader.SetFileName(file.c_str());
    if (!reader.Read()) continue;
    const std::size_t have = volume.size(), length = reader.GetImage().GetBufferLength();
    if (have == 0) volume.reserve(length * files.size());
    volume.resize(have + length);
    reader.GetImage().GetBuffer(volume.data() + have);
  }
}

void timeFolder(const fs::path& folder) {
  const auto files = filesOf(folder);
  TaskMonitor monitor;
  std::vector<dicom::SeriesInfo> series;
  const Cost list = costOf([&] { series = dicom::listSeries(folder, monitor); });
  printRow(folder, files.size(), "list", list, costOf([&] { gdcmHeaders(files); }));
  std::vector<fs::path> used;
  Cost load;
  for (const auto& info : series) {
    if (!info.is_loadable) continue;
    load = load + costOf([&] { dicom::loadSeries(info, monitor); }, 3);
    used.insert(used.end(), info.files.begin(), info.files.end());
  }
  if (!used.empty()) printRow(folder, used.size(), "load", load, costOf([&] { gdcmVoxels(used); }, 3));
}

/// Makes a volume of `size`^2 x `slices` that compresses poorly.
volume::Volume madeVolume(int size, int slices, unsigned seed) {
  volume::Volume volume;
  volume.grid.size = {size, size, slices};
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> value(0, 4095);
  volume.voxels.resize(volume.grid.count());
  for (float& voxel : volume.voxels) voxel = float(value(random));
  return volume;
}

/// Makes 45 series of 100 slices, a tenth of the slices twice, with other files between them; 40 files a
/// folder, two levels.
void makeMixed(const fs::path& folder) {
  constexpr int kSeries = 45, kSlices = 100, kPapers = 50, kPerFolder = 40;
  const fs::path once = folder.string() + ".once";
  std::vector<fs::path> sources;
  for (int s = 0; s < kSeries; ++s) {
    const fs::path one = once / std::to_string(s);
    dicom::SeriesTags tags;
    tags.patient_id = std::to_string(s % 5);
    tags.description = "series " + std::to_string(s);
    dicom::writeSeries(madeVolume(96, kSlices, unsigned(s)), one, tags);
    for (const auto& file : filesOf(one)) sources.push_back(file);
  }
  const std::size_t images = sources.size();
  for (std::size_t i = 0; i < images; i += 10) sources.push_back(sources[i]);
  std::shuffle(sources.begin(), sources.end(), std::mt19937(1));
  for (std::size_t i = 0; i < sources.size() + kPapers; ++i) {
    const fs::path place = folder / std::to_string(i / (kPerFolder * 10)) / std::to_string(i / kPerFolder);
    fs::create_directories(place);
    if (i < sources.size())
      fs::copy_file(sources[i], place / std::to_string(i));
    else
      std::ofstream(place / std::to_string(i)) << std::string(100'000, 'x');
  }
  fs::remove_all(once);
}

struct MadeFolders {
  fs::path root = fs::temp_directory_path() / ("facenav_import_" + std::to_string(::getpid()));
  fs::path slices = root / "256 slices", mixed = root / "5000 mixed";
  MadeFolders() {
    dicom::writeSeries(madeVolume(256, 256, 7), slices, {});
    makeMixed(mixed);
  }
  ~MadeFolders() { fs::remove_all(root); }
};

}  // namespace

int main(int argc, char** argv) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  std::vector<fs::path> folders(argv + 1, argv + argc);
  std::optional<MadeFolders> made;
  if (folders.empty()) {
    made.emplace();
    folders = {facenav::testing::t1Dicom(), made->slices, made->mixed,
               facenav::testing::sharedData() / "dicom_variety"};
  }
  std::printf("\n## DICOM import: FaceNav beside GDCM's reading of the same files\n\n");
  std::printf(
      "| folder | files | step | FaceNav wall ms | GDCM | ratio | FaceNav processor ms | GDCM | ratio |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const fs::path& folder : folders) {
    if (!fs::exists(folder)) {
      std::printf("| %s | - | left out: not here | | | | | | |\n", folder.c_str());
      continue;
    }
    try {
      timeFolder(folder);
    } catch (const Error& error) {
      std::printf("| %s | - | %s | | | | | | |\n", folder.c_str(), error.what());
    }
  }
  return 0;
}
