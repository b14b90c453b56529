#include "facenav/casefile/threshold_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "appended_file.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/utc_time.h"
#include "facenav/core/whole_folder.h"
#include "json_lines.h"
#include "pulse_json.h"
#include "utc_now.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

std::string lineOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string now() { return isoUtc(std::chrono::system_clock::now()); }

std::string headLine(stimulation::ThresholdMethod method, const std::string& muscle,
                     const std::optional<guidance::Target>& target) {
  Json json{{"threshold", 1}, {"started_utc", now()}, {"method", toString(method)}, {"muscle", muscle}};
  if (target) json["target"] = targetJson(*target);
  return lineOf(json);
}

std::string answerLine(const KeptAnswer& kept) {
  Json json{{"utc", kept.utc},
            {"intensity_pct", kept.answer.intensity_pct},
            {"response", kept.answer.has_response ? 1 : 0}};
  if (kept.mep_uv) json["mep_uv"] = *kept.mep_uv;
  return lineOf(json);
}

void applyLine(const JsonReader& line, KeptThreshold& kept) {
  if (line.has("taken_back")) {
    if (!kept.answers.empty()) kept.answers.pop_back();
    return;
  }
  KeptAnswer answer;
  answer.utc = line.at("utc").text();
  answer.answer = {line.at("intensity_pct").number(), line.at("response").integer() != 0};
  if (line.has("mep_uv")) answer.mep_uv = line.at("mep_uv").number();
  kept.answers.push_back(answer);
}

fs::path freePath(const fs::path& folder) {
  const std::string time = utcNow();
  fs::path path = folder / (time + ".jsonl");
  for (int count = 2; fs::exists(path); ++count)
    path = folder / (time + "_" + std::to_string(count) + ".jsonl");
  return path;
}

}  // namespace

std::vector<stimulation::ThresholdAnswer> KeptThreshold::plain() const {
  std::vector<stimulation::ThresholdAnswer> plain;
  for (const auto& kept : answers) plain.push_back(kept.answer);
  return plain;
}

KeptThreshold readThreshold(const fs::path& path) {
  if (!fs::exists(path)) throw Error("file does not exist", path.string(), "choose a kept search");
  auto lines = readJsonLines(path);
  if (lines.lines.empty() || !lines.lines.front().has("threshold"))
    throw Error("this is no search for a threshold", path.string(), "begin a new one");
  KeptThreshold kept;
  kept.path = path;
  kept.problems = std::move(lines.problems);
  const JsonReader& head = lines.lines.front();
  kept.started_utc = head.at("started_utc").text();
  kept.method = stimulation::thresholdMethodFrom(head.at("method").text());
  kept.muscle = head.at("muscle").text();
  if (head.has("target")) kept.target = targetFrom(head.at("target"));
  for (std::size_t i = 1; i < lines.lines.size(); ++i) {
    try {
      applyLine(lines.lines[i], kept);
    } catch (const Error& fault) {
      kept.problems.push_back(std::string(fault.what()) + ": the answer is left out");
    }
  }
  return kept;
}

std::vector<KeptThreshold> readThresholds(const fs::path& case_folder) {
  std::vector<KeptThreshold> all;
  const fs::path folder = case_folder / "thresholds";
  if (!fs::is_directory(folder)) return all;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".jsonl") continue;
    try {
      all.push_back(readThreshold(entry.path()));
    } catch (const Error& error) {
      logWarning(error.what());
    }
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return all;
}

struct ThresholdFile::Implementation {
  KeptThreshold kept;
  AppendedFile file;

  void append(const std::string& line) {
    file.append(line);
    try {
      file.sync();
    } catch (const Error&) {
      file.undoLast();
      throw;
    }
  }
};

ThresholdFile::ThresholdFile(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ThresholdFile::~ThresholdFile() = default;
ThresholdFile::ThresholdFile(ThresholdFile&&) noexcept = default;
ThresholdFile& ThresholdFile::operator=(ThresholdFile&&) noexcept = default;

ThresholdFile ThresholdFile::begin(const fs::path& case_folder, stimulation::ThresholdMethod method,
                                   const std::string& muscle, const std::optional<guidance::Target>& target) {
  if (!fs::is_directory(case_folder))
    throw Error("folder does not exist", case_folder.string(), "open a case first");
  const fs::path folder = case_folder / "thresholds";
  if (!fs::exists(folder)) makePrivateFolder(folder);
  const fs::path path = freePath(folder);
  {
    AppendedFile file(path, headLine(method, muscle, target));
    file.sync();
  }
  makeNamesDurable(folder);
  makeNamesDurable(case_folder);
  return open(path);
}

ThresholdFile ThresholdFile::open(const fs::path& path) {
  auto kept = readThreshold(path);
  return ThresholdFile(std::unique_ptr<Implementation>(
      new Implementation{std::move(kept), AppendedFile(path, "", AppendedFile::Start::old_or_fresh)}));
}

const KeptThreshold& ThresholdFile::kept() const { return implementation_->kept; }

void ThresholdFile::keep(KeptAnswer answer) {
  answer.utc = now();
  implementation_->append(answerLine(answer));
  implementation_->kept.answers.push_back(answer);
}

void ThresholdFile::takeBack() {
  auto& answers = implementation_->kept.answers;
  if (answers.empty()) throw Error("there is no answer to take back", implementation_->kept.path.string());
  implementation_->append(lineOf({{"utc", now()}, {"taken_back", int(answers.size())}}));
  answers.pop_back();
}

}  // namespace facenav::casefile
