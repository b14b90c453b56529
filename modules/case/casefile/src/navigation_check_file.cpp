#include "facenav/casefile/navigation_check_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace {

using Json = nlohmann::ordered_json;
constexpr char kFile[] = "navigation_check.json";

double rounded(double value_mm) { return std::round(1000 * value_mm) / 1000; }

Json triple(const Eigen::Vector3d& v) { return {rounded(v.x()), rounded(v.y()), rounded(v.z())}; }

Eigen::Vector3d readTriple(const JsonReader& json) {
  const auto v = json.numbers(3);
  return {v[0], v[1], v[2]};
}

Json toJson(const surface::FaceMeasure& m) {
  Json json{{"name", m.name},
            {"from", m.from},
            {"to", m.to},
            {"mm", rounded(m.value_mm)},
            {"uncertainty_mm", rounded(m.uncertainty_mm)}};
  if (m.is_lower_bound) json["on_scan_edge"] = true;
  if (m.usual) json["adult_range_mm"] = {m.usual->low_mm, m.usual->high_mm};
  return json;
}

surface::FaceMeasure readMeasure(const JsonReader& json) {
  surface::FaceMeasure m;
  m.name = json.at("name").text();
  m.from = json.at("from").text();
  m.to = json.at("to").text();
  m.value_mm = json.at("mm").number();
  m.uncertainty_mm = json.at("uncertainty_mm").number();
  m.is_lower_bound = json.has("on_scan_edge");
  if (!json.has("adult_range_mm")) return m;
  const auto range = json.at("adult_range_mm").numbers(2);
  m.usual = surface::UsualRange{range[0], range[1]};
  return m;
}

surface::CheckFinding readFinding(const JsonReader& json) {
  surface::CheckFinding finding;
  try {
    finding.topic = surface::topicFrom(json.at("topic").text());
  } catch (const Error&) {
    json.at("topic").refuse("a topic of the import check was expected");
  }
  const std::string words = json.at("verdict").text();
  if (words != "fine" && words != "caution" && words != "not usable")
    json.at("verdict").refuse("fine, caution or not usable was expected");
  finding.verdict = surface::verdictFrom(words);
  finding.finding = json.at("finding").text();
  if (json.has("ask")) finding.ask = json.at("ask").text();
  return finding;
}

}  // namespace

void writeNavigationCheck(const surface::NavigationCheck& check, const std::filesystem::path& path) {
  Json json;
  json["verdict"] = toString(check.verdict());
  json["findings"] = Json::array();
  for (const auto& f : check.findings)
    json["findings"].push_back({{"topic", toString(f.topic)},
                                {"verdict", toString(f.verdict)},
                                {"finding", f.finding},
                                {"ask", f.ask}});
  json["landmarks"] = Json::array();
  for (const auto& p : check.landmarks.points) {
    Json landmark{{"name", p.name}, {"mm", triple(p.point.mm)}, {"sd_mm", p.sd_mm}};
    if (p.is_cut) landmark["on_scan_edge"] = true;
    json["landmarks"].push_back(std::move(landmark));
  }
  json["head_axes"] = {{"right", triple(check.landmarks.right.v)},
                       {"front", triple(check.landmarks.front.v)},
                       {"up", triple(check.landmarks.up.v)}};
  json["measures"] = Json::array();
  for (const auto& m : check.measures) json["measures"].push_back(toJson(m));
  writeWholeFile(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
}

surface::NavigationCheck readNavigationCheck(const std::filesystem::path& path) {
  const JsonReader json = JsonReader::readFile(path);
  surface::NavigationCheck check;
  for (const auto& finding : json.at("findings").elements()) check.findings.push_back(readFinding(finding));
  for (const auto& p : json.at("landmarks").elements())
    check.landmarks.points.push_back({p.at("name").text(), Point<Mri>(readTriple(p.at("mm"))),
                                      p.at("sd_mm").number(), p.has("on_scan_edge")});
  const JsonReader axes = json.at("head_axes");
  check.landmarks.right = Direction<Mri>(readTriple(axes.at("right")));
  check.landmarks.front = Direction<Mri>(readTriple(axes.at("front")));
  check.landmarks.up = Direction<Mri>(readTriple(axes.at("up")));
  for (const auto& measure : json.at("measures").elements()) check.measures.push_back(readMeasure(measure));
  return check;
}

std::optional<surface::NavigationCheck> navigationCheckOf(const CaseStore& store) {
  const auto path = store.folder() / kFile;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return readNavigationCheck(path);
}

}  // namespace facenav::casefile
