#pragma once
// Commands to a running session, line by line on standard input, and its events as JSON lines on standard
// output: for programs that drive `facenav track --pulses --commands`.

#include <string>

#include "facenav/treat/live_orders.h"
#include "facenav/treat/treatment.h"

namespace facenav::app {

/// Describes the commands for the help text.
std::string sessionCommandWords();

class SessionCommands {
 public:
  /// `coil_library`: where the command `coil NAME` finds coils; `orders`: the targets that `take NAME` takes.
  SessionCommands(std::filesystem::path coil_library, std::filesystem::path case_folder,
                  steps::LiveOrders& orders)
      : coil_library_(std::move(coil_library)), case_folder_(std::move(case_folder)), orders_(orders) {}
  /// Takes new commands and reports new events: checks, losses, and pulses once they are on the disk, so that
  /// a reported pulse survives a crash. Returns at once; false if the session must end.
  bool look(steps::Treatment& treatment);

 private:
  bool readInput(steps::Treatment& treatment);
  bool obey(const std::string& line, steps::Treatment& treatment);
  void judgeTip(const std::string& verdict, steps::Treatment& treatment);
  void judgeSpot(const std::string& words, steps::Treatment& treatment);
  void tell(steps::Treatment& treatment);

  std::filesystem::path coil_library_, case_folder_;
  steps::LiveOrders& orders_;
  std::shared_ptr<const guidance::TipCheck> tip_check_;  // made at the first use
  std::string input_;
  bool has_begun_ = false, has_input_ = true, is_check_due_ = false, is_camera_away_ = false;
  int told_check_ = 0;
  std::string told_withheld_;
};

}  // namespace facenav::app
