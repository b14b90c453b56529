#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <set>

#include "facenav/core/error.h"
#include "scu.h"

namespace facenav::pacs {
namespace {

namespace fs = std::filesystem;

struct Outgoing {
  fs::path file;
  std::string kind, syntax;
};

/// Skips files that are not DICOM; a single input file that is not DICOM is refused.
std::vector<Outgoing> dicomFilesUnder(const fs::path& input) {
  std::error_code error;
  std::vector<fs::path> files;
  if (fs::is_regular_file(input, error)) files = {input};
  for (auto it = fs::recursive_directory_iterator(input, error);
       !error && it != fs::recursive_directory_iterator(); it.increment(error))
    if (it->is_regular_file(error)) files.push_back(it->path());
  std::sort(files.begin(), files.end());
  constexpr Uint32 kLongestValue = 4096;
  std::vector<Outgoing> outgoing;
  for (const fs::path& file : files) {
    DcmFileFormat format;
    if (format
            .loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, kLongestValue, ERM_autoDetect,
                              DCM_StudyDate)
            .bad())
      continue;
    OFString kind;
    format.getDataset()->findAndGetOFString(DCM_SOPClassUID, kind);
    const DcmXfer original(format.getDataset()->getOriginalXfer());
    const OFString syntax = original.getXferID();
    if (kind.empty() || syntax.empty()) continue;
    outgoing.push_back({file, kind.c_str(), syntax.c_str()});
  }
  if (outgoing.empty()) throw Error("holds no DICOM files to send", input.string(), "check the path");
  return outgoing;
}

std::vector<Offer> offersFor(const std::vector<Outgoing>& outgoing) {
  constexpr std::size_t kMostContexts = 128;  // PS3.8 7.1.1.13
  std::set<std::pair<std::string, std::string>> kinds;
  for (const Outgoing& file : outgoing) kinds.insert({file.kind, file.syntax});
  if (kinds.size() > kMostContexts)
    throw Error("holds too many kinds of objects for one connection", {}, "send them in parts");
  std::vector<Offer> offers;
  for (const auto& [kind, syntax] : kinds) offers.push_back({kind, {syntax}, false});
  return offers;
}

}  // namespace

int store(const PacsNode& node, const fs::path& input, TaskMonitor& monitor) {
  check(node);
  prepareDcmtk();
  const auto outgoing = dicomFilesUnder(input);
  return withAssociation<PlainScu>(node, offersFor(outgoing), [&](DcmSCU& scu) {
    int sent = 0;
    for (const Outgoing& file : outgoing) {
      monitor.report("sending images", double(sent) / double(outgoing.size()));
      const auto context = scu.findPresentationContextID(file.kind.c_str(), file.syntax.c_str());
      if (context == 0)
        throw Error("the archive does not take this kind of object or its compression", file.file.string(),
                    "ask its administrator");
      Uint16 status = 0;
      require(scu.sendSTORERequest(context, file.file.c_str(), nullptr, status), node,
              "sending " + file.file.filename().string());
      requireStatus(status, node, "sending " + file.file.filename().string());
      ++sent;
    }
    monitor.report("sending images", 1.0);
    return sent;
  });
}

}  // namespace facenav::pacs
