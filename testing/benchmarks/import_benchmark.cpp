// The import beside GDCM's own reading of the same files: one pass over all headers (gdcm::Reader up to the
// pixels) and one over all voxels (gdcm::ImageReader and its decompression). Processor time, warm file cache,
// children included (codecs run in child processes). Folders as arguments, or the shared real T1.

#include <gdcmImageReader.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>
#include <sys/resource.h>

#include <cstdio>

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

template <class Work>
double fastest_ms(Work work, int runs = 5) {
  double best_ms = 1e12;
  for (int i = 0; i < runs; ++i) {
    const double start_ms = processorWithChildren_ms();
    work();
    best_ms = std::min(best_ms, processorWithChildren_ms() - start_ms);
  }
  return best_ms;
}

void gdcmHeaders(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    reader.ReadUpToTag(gdcm::Tag(0x7FE0, 0x0010));
  }
}

void gdcmVoxels(const std::vector<fs::path>& files) {
  std::vector<char> volume;  // one buffer for all, as whoever wants a volume needs
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
  const double list_ms = fastest_ms([&] { series = dicom::listSeries(folder, monitor); });
  const double gdcm_list_ms = fastest_ms([&] { gdcmHeaders(files); });
  std::printf("| %s | %zu | list | %.0f | %.0f | %.2f |\n", folder.filename().c_str(), files.size(), list_ms,
              gdcm_list_ms, list_ms / gdcm_list_ms);
  std::vector<fs::path> used;
  double load_ms = 0;
  for (const auto& info : series) {
    if (!info.is_loadable) continue;
    load_ms += fastest_ms([&] { dicom::loadSeries(info, monitor); }, 3);
    used.insert(used.end(), info.files.begin(), info.files.end());
  }
  if (used.empty()) return;
  const double gdcm_load_ms = fastest_ms([&] { gdcmVoxels(used); }, 3);
  std::printf("| %s | %zu | load | %.0f | %.0f | %.2f |\n", folder.filename().c_str(), used.size(), load_ms,
              gdcm_load_ms, load_ms / gdcm_load_ms);
}

}  // namespace

int main(int argc, char** argv) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  std::vector<fs::path> folders(argv + 1, argv + argc);
  if (folders.empty())
    folders = {facenav::testing::t1Dicom(), facenav::testing::sharedData() / "dicom_variety"};
  std::printf("\n## DICOM import: FaceNav beside GDCM's reading of the same files (processor time)\n\n");
  std::printf("| folder | files | step | FaceNav ms | GDCM ms | ratio |\n|---|---|---|---|---|---|\n");
  for (const fs::path& folder : folders) {
    if (!fs::exists(folder)) {
      std::printf("| %s | - | left out: not here | | | |\n", folder.c_str());
      continue;
    }
    try {
      timeFolder(folder);
    } catch (const Error& error) {
      std::printf("| %s | - | %s | | | |\n", folder.c_str(), error.what());
    }
  }
  return 0;
}
