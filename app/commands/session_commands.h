#pragma once
// Commands to a running session, line by line on standard input, and what happens in it as JSON lines on
// standard output: for programs that drive `facenav track --pulses --commands`.

#include <string>

#include "facenav/treat/treatment.h"

namespace facenav::app {

/// For the help text.
std::string sessionCommandWords();

class SessionCommands {
 public:
  /// `coil_library`: where the command `coil NAME` finds coils.
  explicit SessionCommands(std::filesystem::path coil_library) : coil_library_(std::move(coil_library)) {}
  /// Takes commands that have come, and tells what is new: pulses that are on the disk (only those: what was
  /// told survives a crash), checks, losses. Returns at once. False: the session is to end.
  bool look(steps::Treatment& treatment);

 private:
  bool readInput(steps::Treatment& treatment);
  bool obey(const std::string& line, steps::Treatment& treatment);
  void judgeTip(const std::string& verdict, steps::Treatment& treatment);
  void judgeSpot(const std::string& words, steps::Treatment& treatment);
  void tell(steps::Treatment& treatment);

  std::filesystem::path coil_library_;
  std::shared_ptr<const guidance::TipCheck> tip_check_;  // made at the first use
  std::string input_;
  bool has_begun_ = false, has_input_ = true, is_check_due_ = false, is_camera_away_ = false;
  int told_check_ = 0;
  std::string told_withheld_;
};

}  // namespace facenav::app
