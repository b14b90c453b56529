// facenav-cli: the verbs of the clinic (facenav runs it).

#include "command_line.h"
#include "lab_program.h"

int main(int argc, char** argv) {
  using namespace facenav;
  const app::Program clinic{
      {{"Prepare",
        {app::addPacs, app::addSeries, app::addPrepare, app::addCheck, app::addBrain, app::addWorklist,
         app::addLabel, app::addExport}},
       {"Plan", {app::addLocate, app::addTarget, app::addPlan, app::addField}},
       {"Set up",
        {app::addCameras, app::addCalibrate, app::addRig, app::addRecord, app::addProjector, app::addMarker,
         app::addCalibrateCoil, app::addCoil}},
       {"Align", {app::addAlign, app::addCloud}},
       {"Treat", {app::addTrack, app::addGuide, app::addServe, app::addThreshold}},
       {"Review", {app::addSessions, app::addPulses, app::addHotspot, app::addNote, app::addReport}},
       {"Home", {app::addFaceCase, app::addImport}},
       {"Lab and others", {app::addLabVerbs, app::addSettings, app::addLicences, app::addSupportBundle}}},
      {"prepare", "align", "track", "guide", "serve", "cloud", "settings", "threshold", "hotspot", "pulses",
       "report", "coil", "target", "rig"}};
  return app::runProgram(clinic, argc, argv);
}
