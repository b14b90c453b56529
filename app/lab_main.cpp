// facenav-lab: the virtual treatment room, the evaluation of the methods, and the demo. facenav runs it for
// its verbs simulate, evaluate and demo; no clinic needs it.

#include "command_line.h"
#include "commands/lab_commands.h"
#include "facenav/peers/bet_segmenter.h"

int main(int argc, char** argv) {
  using namespace facenav;
  const app::Program lab{{{"Lab", {app::addSimulate, app::addEvaluate, app::addDemo}}},
                         {"evaluate", "demo"},
                         [](steps::Registrations& methods) {
                           methods.brain_segmenters.add("bet", "plain deformable surface",
                                                        peers::makeBetSegmenter);
                         }};
  return app::runProgram(lab, argc, argv);
}
