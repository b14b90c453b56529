// facenav-lab: the virtual treatment room, the evaluation of the methods, and the demo. facenav runs it for
// its verbs simulate, evaluate and demo; no clinic needs it.

#include "command_line.h"
#include "commands/lab_commands.h"
#include "facenav/peers/bet_segmenter.h"
#include "facenav/peers/cascade_detector.h"
#include "facenav/peers/feature_head_tracker.h"
#include "facenav/peers/icp_aligner.h"

int main(int argc, char** argv) {
  using namespace facenav;
  const app::Program lab{
      {{"Lab", {app::addSimulate, app::addEvaluate, app::addDemo}}},
      {"evaluate", "demo"},
      [](steps::Registrations& methods) {
        methods.brain_segmenters.add("bet", "plain deformable surface", peers::makeBetSegmenter);
        methods.aligners.add("icp", "the 2010 paper's iterative closest point", peers::makeIcpAligner);
        methods.head_trackers.add("features7", "the 2010 paper's seven features", [] {
          return peers::makeFeatureHeadTracker(
              peers::makeCascadeDetector(std::make_shared<face::LandmarkModel>()));
        });
      }};
  return app::runProgram(lab, argc, argv);
}
