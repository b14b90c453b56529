#pragma once
// One function per verb. It adds the subcommand with its options and a callback that does the work. A
// callback throws facenav::Error on failure; runProgram reports it in one line with exit status 1.

#include <CLI/CLI.hpp>

#include "context.h"

namespace facenav::app {

void addSeries(CLI::App& app, Context& context);
void addPacs(CLI::App& app, Context& context);
void addPrepare(CLI::App& app, Context& context);
void addCalibrate(CLI::App& app, Context& context);
void addCameras(CLI::App& app, Context& context);
void addRig(CLI::App& app, Context& context);
void addRecord(CLI::App& app, Context& context);
void addProjector(CLI::App& app, Context& context);
void addCalibrateCoil(CLI::App& app, Context& context);
void addAlign(CLI::App& app, Context& context);
void addTrack(CLI::App& app, Context& context);
void addCloud(CLI::App& app, Context& context);
void addGuide(CLI::App& app, Context& context);
void addServe(CLI::App& app, Context& context);
void addSessions(CLI::App& app, Context& context);
void addPulses(CLI::App& app, Context& context);
void addReport(CLI::App& app, Context& context);
void addThreshold(CLI::App& app, Context& context);
void addHotspot(CLI::App& app, Context& context);
void addNote(CLI::App& app, Context& context);
void addWorklist(CLI::App& app, Context& context);
void addLabel(CLI::App& app, Context& context);
void addCheck(CLI::App& app, Context& context);
void addBrain(CLI::App& app, Context& context);
void addLocate(CLI::App& app, Context& context);
void addTarget(CLI::App& app, Context& context);
void addPlan(CLI::App& app, Context& context);
void addField(CLI::App& app, Context& context);
void addExport(CLI::App& app, Context& context);
void addCoil(CLI::App& app, Context& context);
void addFaceCase(CLI::App& app, Context& context);
void addImport(CLI::App& app, Context& context);
void addMarker(CLI::App& app, Context& context);
void addSettings(CLI::App& app, Context& context);
void addLicences(CLI::App& app, Context& context);
void addSupportBundle(CLI::App& app, Context& context);
void addHelp(CLI::App& app, Context& context);

}  // namespace facenav::app
