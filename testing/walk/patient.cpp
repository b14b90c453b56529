#include "facenav/casefile/sign_off.h"
#include "facenav/dicom/series.h"
#include "facenav/volume/nifti.h"
#include "gui/home_fixtures.h"
#include "jobs.h"
#include "registrations.h"
#include "support/command_line.h"

namespace facenav::walk {
namespace {

namespace fs = std::filesystem;

constexpr double kHandle_rad = 0.8, kGap_mm = 4;

/// The point of the brain's surface that is farthest to the upper right.
Point<Mri> upperRight(const surface::BrainModel& brain) {
  const Eigen::Vector3d towards(0.5, 0, 0.87);
  Eigen::Vector3d best = brain.mesh.vertices_mm.front();
  for (const auto& vertex : brain.mesh.vertices_mm)
    if (vertex.dot(towards) > best.dot(towards)) best = vertex;
  return Point<Mri>(best);
}

}  // namespace

Patient::Patient()
    : series_(folder_.path() / "dicom"),
      recording_(ui::home_fixtures::writeCapturedRecording(folder_.path())),
      prepared_(folder_.path() / "prepared") {
  dicom::writeSeries(volume::readNifti(testing::virtualPatientMri()).volume, series_, {});
  fs::create_directories(folder_.path() / "home/Desktop");
}

void Patient::prepare(const fs::path& input, TaskMonitor& monitor) {
  if (fs::exists(prepared_)) return;
  ui::PrepareOrder order;
  order.input = input;
  order.case_folder = prepared_;
  ui::servicesWith(app::makeRegistrations).prepareCase(order, monitor);
}

fs::path Patient::roomRecording() {
  const fs::path recording = folder_.path() / "room";
  if (!fs::exists(recording))
    testing::runFacenav("simulate treatment --frames 60 -q -o '" + recording.string() + "'");
  return recording;
}

ui::Services Patient::services() {
  ui::Services services = ui::servicesWith(app::makeRegistrations);
  services.prepareCase = [this](const ui::PrepareOrder& order, TaskMonitor& monitor) {
    prepare(order.input, monitor);
    fs::create_directories(order.case_folder.parent_path());
    fs::copy(prepared_, order.case_folder, fs::copy_options::recursive);
  };
  return services;
}

fs::path Patient::casesFolder(const std::string& name) {
  TaskMonitor monitor;
  prepare(series_, monitor);
  const fs::path cases = folder_.path() / name, copy = cases / "patient";
  fs::remove_all(cases);
  fs::create_directories(cases);
  fs::copy(prepared_, copy, fs::copy_options::recursive);
  const auto loaded = ui::loadCase(copy, monitor);
  loaded->store.setTargets({{guidance::planTarget("M1 hand R", *loaded->scalp, upperRight(*loaded->brain),
                                                  kHandle_rad, kGap_mm)}});
  casefile::signOff(loaded->store, {"AB", "seen", true});
  return cases;
}

}  // namespace facenav::walk
