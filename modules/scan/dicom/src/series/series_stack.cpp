#include "series_stack.h"

#include <numeric>

#include "bytes/for_files.h"
#include "facenav/core/error.h"
#include "pixels/pixel_decoder.h"
#include "series_scan.h"
#include "single_slices.h"

namespace facenav::dicom {
namespace {

[[noreturn]] void raise(const StackFault& fault) {
  throw Error(fault.what, fault.file.string(), fault.remedy);
}

std::vector<SliceHeader> readHeaders(const SeriesInfo& series, TaskMonitor& monitor) {
  std::vector<SliceHeader> headers(series.files.size());
  forFiles(series.files.size(), monitor, "reading DICOM headers", [&](std::size_t f, std::size_t) {
    auto header = readHeaderOf(series.files[f]);
    if (!header) throw Error("is not DICOM", series.files[f].string(), "list the series again");
    const std::string problem = voxelProblem(*header);
    if (!problem.empty()) throw Error(problem, series.files[f].string(), "choose another series");
    if (!series.joined && header->series_uid != series.series_uid)
      throw Error("belongs to another series", series.files[f].string(), "list the series again");
    headers[f] = std::move(*header);
  });
  if (series.joined)
    for (const SliceHeader& header : headers)
      if (!isOfOneScan(headers[0], header))
        throw Error("belongs to another series", header.file.string(), "list the series again");
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

}  // namespace

SeriesStack readStack(const SeriesInfo& series, TaskMonitor& monitor) {
  if (series.files.empty())
    throw Error("the series holds no files", series.description, "choose another series");
  SeriesStack read;
  read.headers = readHeaders(series, monitor);
  read.stack = stackSlices(read.headers, imagesOf(series, read.headers));
  if (read.stack.fault) raise(*read.stack.fault);
  return read;
}

}  // namespace facenav::dicom
