#include "facenav/treat/live_outputs.h"

#include <algorithm>

#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/interop/invesalius_space.h"
#include "facenav/interop/t1.h"
#include "facenav/links/igtl_content.h"
#include "facenav/session/live_frame.h"

namespace facenav::steps {
namespace {

links::IgtlSurface surfaceOf(const surface::TriangleMesh& mesh) {
  links::IgtlSurface sent;
  sent.points_mm.reserve(mesh.vertices_mm.size());
  for (const auto& vertex_mm : mesh.vertices_mm) sent.points_mm.push_back(vertex_mm.cast<float>());
  sent.triangles.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    sent.triangles.push_back(
        {std::uint32_t(triangle[0]), std::uint32_t(triangle[1]), std::uint32_t(triangle[2])});
  return sent;
}

links::IgtlImage imageOf(volume::Volume mri) {
  links::IgtlImage image;
  image.size = mri.grid.size;
  image.steps_mm = mri.grid.mri_from_voxel.linear();
  image.centre_mm = mri.grid.centre().mm;
  image.voxels = std::move(mri.voxels);
  return image;
}

std::vector<links::IgtlPoint> pointsOf(const guidance::TreatmentPlan& plan) {
  std::vector<links::IgtlPoint> points;
  for (const auto& target : plan.targets) {
    links::IgtlPoint point;
    point.name = target.name;
    point.group = "Target";
    point.position_mm = target.cortex_point.mm;
    points.push_back(point);
  }
  return points;
}

std::optional<links::IgtlSurface> cortexOf(const casefile::CaseStore& store) {
  if (const auto cortex = store.cortex()) return surfaceOf(cortex->mesh);
  if (const auto brain = store.brain()) return surfaceOf(brain->mesh);
  return std::nullopt;
}

/// Space of the case's MRI, from its header; null for a case without one. Without it no pose in the MRI goes
/// to InVesalius's relay.
std::shared_ptr<const interop::InvesaliusSpace> imageSpace(const std::filesystem::path& folder) {
  const auto mri = folder / "mri.nii.gz";
  if (folder.empty() || !std::filesystem::exists(mri)) return nullptr;
  try {
    return std::make_shared<interop::InvesaliusSpace>(interop::readT1(mri).grid);
  } catch (const Error& error) {
    logWarning(error.what());
    return nullptr;
  }
}

}  // namespace

std::optional<std::vector<std::uint8_t>> caseContent(const std::filesystem::path& folder,
                                                     const std::string& type, const std::string& name) {
  const auto isAsked = [&](const char* of_type, const char* of_name, bool is_first) {
    return type == of_type && (name == of_name || (is_first && name.empty()));
  };
  const auto store = casefile::CaseStore::open(folder);
  if (isAsked("IMAGE", "MRI", true) && store.hasMri()) return links::imageContent(imageOf(store.mri()));
  if (isAsked("POLYDATA", "Scalp", true)) return links::surfaceContent(surfaceOf(store.scalp().mesh));
  if (isAsked("POINT", "Targets", true)) return links::pointsContent(pointsOf(store.targets()));
  if (!isAsked("POLYDATA", "Cortex", false)) return std::nullopt;
  const auto cortex = cortexOf(store);
  return cortex ? std::optional(links::surfaceContent(*cortex)) : std::nullopt;
}

std::optional<std::vector<std::uint8_t>> LiveOutputs::content(const std::string& type,
                                                              const std::string& name) const {
  std::filesystem::path folder;
  {
    std::lock_guard lock(mutex_);
    folder = case_folder_;
  }
  if (folder.empty()) return std::nullopt;
  return caseContent(folder, type, name);
}

void LiveOutputs::open(const std::string& words, const links::LiveIncoming& incoming) {
  const auto open_names = names();
  if (std::find(open_names.begin(), open_names.end(), words) != open_names.end())
    throw Error("is open already", words);
  std::shared_ptr<links::LiveOutput> output = links::openLiveOutput(
      words, [this](const std::string& type, const std::string& name) { return content(type, name); },
      incoming);
  std::lock_guard lock(mutex_);
  outputs_.push_back(std::move(output));
}

void LiveOutputs::close(const std::string& words) {
  Outputs closed;  // they end after the lock is released: an output may wait for its thread
  std::lock_guard lock(mutex_);
  const auto last = std::stable_partition(outputs_.begin(), outputs_.end(),
                                          [&](const auto& each) { return each->name() != words; });
  closed.assign(last, outputs_.end());
  outputs_.erase(last, outputs_.end());
}

void LiveOutputs::close() {
  Outputs closed;
  std::lock_guard lock(mutex_);
  closed.swap(outputs_);
}

bool LiveOutputs::isEmpty() const {
  std::lock_guard lock(mutex_);
  return outputs_.empty();
}

std::vector<std::string> LiveOutputs::names() const {
  std::lock_guard lock(mutex_);
  std::vector<std::string> names;
  for (const auto& each : outputs_) names.push_back(each->name());
  return names;
}

std::vector<std::string> LiveOutputs::receivers() const {
  std::lock_guard lock(mutex_);
  std::vector<std::string> lines;
  for (const auto& each : outputs_)
    for (const auto& receiver : each->report().receivers) lines.push_back(each->name() + ": " + receiver);
  return lines;
}

std::vector<links::LiveReport> LiveOutputs::reports() const {
  std::lock_guard lock(mutex_);
  std::vector<links::LiveReport> reports;
  for (const auto& each : outputs_) reports.push_back(each->report());
  return reports;
}

void LiveOutputs::setCase(const std::filesystem::path& folder) {
  auto image = imageSpace(folder);
  std::lock_guard lock(mutex_);
  case_folder_ = folder;
  image_ = std::move(image);
}

void LiveOutputs::publish(const session::NavigationState& state) {
  std::lock_guard lock(mutex_);  // so that no output ends on the caller's thread
  if (outputs_.empty()) return;
  const auto frame = std::make_shared<links::LiveFrame>(session::liveFrameOf(state));
  frame->image = image_;
  for (const auto& each : outputs_) each->publish(frame);
}

void LiveOutputs::publish(const links::PulseTrigger& pulse) {
  std::lock_guard lock(mutex_);
  for (const auto& each : outputs_) each->publish(pulse);
}

}  // namespace facenav::steps
