#pragma once
// SetupSteps: processes each pair in the four steps of the set-up, without a thread (setup/rig_setup.h).

#include <functional>

#include "facenav/setup/rig_setup.h"
#include "rig_check_run.h"

namespace facenav::steps {

class SetupSteps {
 public:
  SetupSteps(const SetupOptions& options, SetupMethods methods, const cv::Size& size);

  /// Processes a frame and returns its view. `publish` is called with a view that asks for patience before
  /// something takes seconds.
  SetupView look(const std::shared_ptr<const cameras::StereoFrame>& frame,
                 const std::function<void(const SetupView&)>& publish);

  /// True if the step needs another frame. Where it does not, a file is not read on.
  bool wantsFrame() const;

  void go(SetupStep step);
  void useBoard(const cameras::Board& board);
  void finishViews();
  void takeMoreViews() { wants_more_ = true; }
  void repeatViews();
  void useCoil(const coil_tracking::CoilModel& coil);
  void startPivots();
  void startJig(const coil_tracking::CoilModel& jig);
  void startWave();

  struct Results {
    std::optional<cameras::StereoRig> rig;
    std::optional<capture::RigUncertainty_mm> uncertainty;
    std::optional<health::RigVerification> verification;
    std::optional<coil_tracking::CoilCalibration> coil;
    std::optional<std::array<double, 2>> row_times_s;
  };
  const Results& results() const { return results_; }

 private:
  using Publish = std::function<void(const SetupView&)>;
  void place(SetupView& now);
  void count(SetupView& now) const;  // views so far, their coverage and progress
  void collect(SetupView& now, const Publish& publish);
  void addView(SetupView& now);
  void calibrateNow(SetupView& now, const Publish& publish);
  void keep(const cameras::Calibration& result);
  void describe(const cameras::Calibration& result);
  void verify(SetupView& now);
  void followCoil(SetupView& now);

  SetupOptions options_;
  const SetupMethods methods_;
  const cv::Size size_;
  SetupStep step_ = SetupStep::place;
  PlacementJudge placement_;
  BoardCollector collector_;
  bool is_calibrated_, is_finish_wanted_ = false, wants_more_ = false;
  bool is_new_ = true;  // false: a file stays at the frame that was processed last
  std::shared_ptr<const cameras::StereoFrame> seen_;
  std::vector<SetupLine> calibration_lines_;
  std::string calibration_words_;
  std::unique_ptr<RigCheckRun> check_;
  std::unique_ptr<CoilSetup> coil_;
  Results results_;
};

}  // namespace facenav::steps
