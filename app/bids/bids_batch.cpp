#include "bids/bids_batch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "facenav/casefile/case_store.h"
#include "facenav/core/child_process.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

fs::path folderOf(const BidsImage& image, const fs::path& output) {
  fs::path folder = output / ("sub-" + image.participant);
  if (!image.session.empty()) folder /= "ses-" + image.session;
  return folder;
}

fs::path logOf(const BidsImage& image, const fs::path& output) {
  return output / "logs" / (image.prefix() + ".log");
}

/// Runs `facenav prepare` and returns its exit status, or -1 if it was killed. Its messages go to `log`.
int runPrepare(const fs::path& facenav, const fs::path& t1, const fs::path& case_folder,
               const fs::path& log) {
  ChildOptions options;
  options.output = ChildOptions::Output::file;
  options.output_file = log;
  options.ends_with_parent = true;  // a killed batch leaves no job that a second run would meet
  return ChildProcess::start(
             {facenav.string(), "prepare", t1.string(), "-o", case_folder.string(), "--quiet"}, options)
      .wait()
      .exit_status;
}

std::string lastLine(const fs::path& log) {
  std::string text = fs::exists(log) ? readWholeFile(log) : "";
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const auto start = text.rfind('\n');
  return text.empty() ? "ended without a word (killed, or out of memory)"
                      : text.substr(start == std::string::npos ? 0 : start + 1);
}

/// Returns true if the case opens. It is then complete, since prepare moves a case into place in one step.
bool isThere(const fs::path& case_folder) {
  try {
    casefile::CaseStore::open(case_folder);
    return true;
  } catch (const Error&) {
    return false;
  }
}

void describe(const fs::path& case_folder, BidsResult& result) {
  const auto store = casefile::CaseStore::open(case_folder);
  result.findings = store.findings().size();
  if (const auto brain = store.brainMask()) result.brain_ml = brain->volume_ml();
}

/// Links the masks under their BIDS names: hard links if the file system allows them, else copies.
void linkDerivatives(const BidsImage& image, const fs::path& folder) {
  fs::create_directories(folder / "anat");
  for (const char* kind : {"head", "brain"}) {
    const fs::path mask = folder / "case" / (std::string(kind) + "_mask.nii.gz");
    const fs::path named = folder / "anat" / (image.prefix() + "_desc-" + kind + "_mask.nii.gz");
    if (!fs::exists(mask) || fs::exists(named)) continue;
    std::error_code fault;
    fs::create_hard_link(mask, named, fault);
    if (fault) fs::copy_file(mask, named);
  }
}

std::string lineOf(const BidsResult& r) {
  const char* state = r.state == BidsState::prepared        ? "prepared"
                      : r.state == BidsState::there_already ? "there"
                      : r.state == BidsState::not_run       ? "not run"
                                                            : "FAILED";
  char line[160];
  std::snprintf(line, sizeof line, "%-24s %-9s %7.1f  %8s  %8zu  ", r.image.prefix().c_str(), state,
                r.seconds, r.brain_ml ? std::to_string(std::lround(*r.brain_ml)).c_str() : "-", r.findings);
  return line + r.problem + "\n";
}

}  // namespace

BidsResult prepareImage(const BidsImage& image, const fs::path& output, const fs::path& facenav) {
  BidsResult result;
  result.image = image;
  const auto start = std::chrono::steady_clock::now();
  try {
    const fs::path folder = folderOf(image, output), case_folder = folder / "case";
    const fs::path log = logOf(image, output);
    fs::create_directories(folder);
    fs::create_directories(log.parent_path());
    if (isThere(case_folder)) {
      result.state = BidsState::there_already;
    } else if (runPrepare(facenav, image.t1, case_folder, log) == 0) {
      result.state = BidsState::prepared;
    } else if (isThere(case_folder)) {  // another run finished it meanwhile
      result.state = BidsState::there_already;
    } else {
      result.problem = lastLine(log);
    }
    if (result.state != BidsState::failed) {
      linkDerivatives(image, folder);
      describe(case_folder, result);
    }
  } catch (const std::exception& error) {
    result.state = BidsState::failed;
    result.problem = error.what();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

BidsResult foundImage(const BidsImage& image, const fs::path& output) {
  BidsResult result;
  result.image = image;
  const fs::path case_folder = folderOf(image, output) / "case", log = logOf(image, output);
  try {
    if (isThere(case_folder)) {
      result.state = BidsState::there_already;
      describe(case_folder, result);
    } else if (fs::exists(log)) {
      result.problem = lastLine(log);
    } else {
      result.state = BidsState::not_run;
    }
  } catch (const std::exception& error) {
    result.state = BidsState::failed;
    result.problem = error.what();
  }
  return result;
}

std::string toTable(const std::vector<BidsResult>& results) {
  std::string table = "image                    state           s  brain ml  findings  problem\n";
  std::size_t count[4] = {0, 0, 0, 0};
  for (const auto& result : results) {
    table += lineOf(result);
    ++count[std::size_t(result.state)];
  }
  return table + std::to_string(count[0]) + " prepared, " + std::to_string(count[1]) + " there already, " +
         std::to_string(count[2]) + " failed" +
         (count[3] == 0 ? "" : ", " + std::to_string(count[3]) + " not run") + "\n";
}

}  // namespace facenav::app
