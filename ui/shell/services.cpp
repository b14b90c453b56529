#include "shell/services.h"

#include "facenav/align/align_case.h"
#include "facenav/capture/camera_pair_source.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/dicom/patient.h"
#include "facenav/prepare/case_field.h"
#include "facenav/prepare/prepare_case.h"
#include "facenav/setup/settle_camera.h"

namespace facenav::ui {
namespace {

using MakeMethods = std::function<steps::Registrations()>;

/// The cameras go on where it cannot be kept.
void keepStart(const std::string& rig, const steps::RigStart& found) {
  try {
    steps::keepRigStart(capture::RigStore(), rig, found);
  } catch (const Error& error) {
    logWarning(error.what());
  }
}

void addScans(Services& services) {
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
  services.storeInArchive = pacs::store;
  services.readTemplate = [] { return atlas::readColin27(); };
}

void addPreparing(Services& services, const MakeMethods& makeMethods) {
  services.prepareCase = [makeMethods](const PrepareOrder& order, TaskMonitor& monitor) {
    const auto methods = makeMethods();
    steps::PrepareRequest request;
    request.input = order.input;
    request.case_folder = order.case_folder;
    request.series_uid = order.series_uid;
    request.is_labelled_by_patient = order.is_labelled_by_patient;
    request.head_segmenter = methods.head_segmenters.defaultName();
    request.brain_segmenter = methods.brain_segmenters.defaultName();
    request.replace = std::filesystem::exists(order.case_folder / "case.json");
    steps::prepareCase(methods, request, monitor);
  };
  services.buildField = [](const std::filesystem::path& case_folder, TaskMonitor& monitor) {
    const auto store = casefile::CaseStore::open(case_folder);
    if (steps::canHaveField(store) && !steps::keptField(store)) steps::buildField(store, monitor);
  };
}

void addTreating(Services& services, const MakeMethods& makeMethods) {
  services.align = [makeMethods](const casefile::CaseStore& store, const capture::Recording& recording,
                                 const HeadKnown& known, TaskMonitor& monitor) {
    const auto methods = makeMethods();
    steps::AlignOrder order{methods.aligners.defaultName()};
    order.stored_pair_stands_in = true;
    if (known.coil) order.coil = *known.coil;
    order.is_patient_confirmed = known.is_patient_confirmed;
    return steps::alignRecording(methods, store, recording, order, monitor).outcome;
  };
  services.seeAlignment = steps::seeAlignment;
  services.makeNavigator = [makeMethods](const session::NavigatorSetup& setup) {
    const auto all = makeMethods();
    const auto& coil_tracker = all.coil_trackers.defaultName();
    auto navigator =
        std::make_unique<session::Navigator>(setup, all.head_trackers.create(all.head_trackers.defaultName()),
                                             all.coil_trackers.create(coil_tracker));
    if (setup.second_coil)
      navigator->addSecondCoil(*setup.second_coil, all.coil_trackers.create(coil_tracker));
    return navigator;
  };
}

void addCameras(Services& services, const MakeMethods& makeMethods) {
  services.listCameras = [makeMethods](capture::Search search) {
    return capture::listCameras(makeMethods().cameras, search);
  };
  services.openCameras = [makeMethods](const cameras::StereoRig& rig, const std::string& left,
                                       const std::string& right) -> std::unique_ptr<capture::FrameSource> {
    const auto methods = makeMethods();
    const auto found = capture::listCameras(methods.cameras);
    return capture::openCameraPair(rig,
                                   capture::openCamera(methods.cameras, capture::findCamera(found, left)),
                                   capture::openCamera(methods.cameras, capture::findCamera(found, right)));
  };
  services.openNewCameras = [makeMethods](const std::string& left, const std::string& right, int width_px,
                                          int height_px) {
    capture::CameraSettings settings;
    settings.width_px = width_px;
    settings.height_px = height_px;
    auto pair = steps::openNewPair(makeMethods().cameras, left, right, settings);
    return NewCameras{std::move(pair.source), pair.left, pair.right};
  };
}

void addVerifiedRig(Services& services, const MakeMethods& makeMethods) {
  services.openRig = [makeMethods](const capture::NamedRig& rig,
                                   const RigVerifying& verifying) -> std::unique_ptr<capture::FrameSource> {
    const auto methods = makeMethods();
    if (!verifying.told) return capture::openRig(methods.cameras, rig);
    steps::RigStartMethods judges{methods.face_detector(),
                                  methods.coil_trackers.create(methods.coil_trackers.defaultName()),
                                  verifying.coil};
    return steps::openVerified(methods.cameras, rig, std::move(judges),
                               "repair them: Check and repair the cameras",
                               [name = rig.name, told = verifying.told](const steps::RigStart& found) {
                                 keepStart(name, found);
                                 told(found);
                               });
  };
}

void addRigStore(Services& services) {
  services.listRigs = [] { return capture::RigStore().list(); };
  services.keepRig = [](const capture::NamedRig& rig, Existing existing) {
    capture::RigStore().write(rig, existing);
  };
  services.noteRig = [](const std::string& name, const capture::RigCheckNote& note) {
    capture::RigStore().note(name, note);
  };
  services.keepLearnt = [](const std::string& name, const steps::CamerasLearnt& learnt) {
    steps::keepLearnt(capture::RigStore(), name, learnt);
  };
}

void addSetup(Services& services, const MakeMethods& makeMethods) {
  services.makeSetupMethods = [makeMethods] {
    const auto methods = std::make_shared<steps::Registrations>(makeMethods());
    return steps::SetupMethods{methods->face_detector(), [methods] {
                                 return methods->coil_trackers.create(methods->coil_trackers.defaultName());
                               }};
  };
}

}  // namespace

Services servicesWith(std::function<steps::Registrations()> makeMethods) {
  Services services;
  addScans(services);
  addPreparing(services, makeMethods);
  addTreating(services, makeMethods);
  addCameras(services, makeMethods);
  addVerifiedRig(services, makeMethods);
  addRigStore(services);
  addSetup(services, makeMethods);
  return services;
}

}  // namespace facenav::ui
