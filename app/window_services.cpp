#include "window_services.h"

#include "case_pictures.h"
#include "context.h"
#include "facenav/capture/camera_pair_source.h"
#include "facenav/core/error.h"
#include "facenav/dicom/patient.h"
#include "pipeline.h"
#include "prepare_case.h"
#include "stored_capture.h"

namespace facenav::app {
namespace {

Context makeContext(TaskMonitor& monitor) {
  return Context{makeRegistrations(), monitor, std::filesystem::read_symlink("/proc/self/exe"), false};
}

capture::CapturePair captureOf(const casefile::CaseStore& store, const capture::Recording& recording) {
  if (recording.capture) return *recording.capture;
  if (auto stored = readStoredCapture(store.folder(), recording.rig)) return *stored;
  throw Error("not aligned: the recording has no capture pair", recording.folder.string(),
              "record one with the dots projected (capture/ in the recording)");
}

}  // namespace

ui::Services windowServices() {
  ui::Services services;
  services.listSeries = [](const auto& folder, TaskMonitor& monitor) {
    return dicom::listSeries(folder, monitor);
  };
  services.makeThumbnail = [](const dicom::SeriesInfo& series) { return dicom::makeThumbnail(series); };
  services.whoseSeries = [](const dicom::SeriesInfo& series) {
    return dicom::inWords(dicom::patientOf(series));
  };
  services.callArchive = [](const pacs::PacsNode& node) { pacs::echo(node); };
  services.findInArchive = [](const pacs::PacsNode& node, const pacs::PacsQuery& query,
                              TaskMonitor& monitor) { return pacs::findSeries(node, query, monitor); };
  services.fetchFromArchive = [](const pacs::PacsNode& node, const pacs::PacsSeries& series,
                                 const std::filesystem::path& folder, pacs::Retrieval how,
                                 TaskMonitor& monitor) {
    std::filesystem::create_directories(folder.parent_path());
    return pacs::retrieve(node, series.study_uid, series.series_uid, folder, how, monitor);
  };
  services.readTemplate = [] { return atlas::readColin27(); };
  services.software_version = softwareVersion();
  services.prepareCase = [](const ui::PrepareOrder& order, TaskMonitor& monitor) {
    auto context = makeContext(monitor);
    PrepareRequest request;
    request.input = order.input;
    request.case_folder = order.case_folder;
    request.series_uid = order.series_uid;
    request.is_labelled_by_patient = order.is_labelled_by_patient;
    request.head_segmenter = context.registrations.head_segmenters.defaultName();
    request.brain_segmenter = context.registrations.brain_segmenters.defaultName();
    request.replace = std::filesystem::exists(order.case_folder / "case.json");
    prepareCase(context, request);
  };
  services.align = [](const casefile::CaseStore& store, const capture::Recording& recording,
                      TaskMonitor& monitor) {
    auto context = makeContext(monitor);
    return alignCase(context, store, recording.rig, captureOf(store, recording),
                     context.registrations.aligners.defaultName());
  };
  services.makeNavigator = [](const session::NavigatorSetup& setup) {
    const auto all = makeRegistrations();
    return std::make_unique<session::Navigator>(setup,
                                                all.head_trackers.create(all.head_trackers.defaultName()),
                                                all.coil_trackers.create(all.coil_trackers.defaultName()));
  };
  services.listCameras = [] { return capture::listCameras(); };
  services.openCameras = [](const stereo::StereoRig& rig, int left, int right) {
    return capture::openCameraPair(rig, left, right);
  };
  services.drawSurfaceDistance = writeSurfaceDistance;
  services.readCoil = [](const std::filesystem::path& path) { return tracking::readCoil(path); };
  return services;
}

}  // namespace facenav::app
