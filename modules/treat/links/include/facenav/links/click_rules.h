#pragma once
// ClickRules: criteria for the click of a stimulating coil in a sound, for the source "sound:".

#include "facenav/core/setting.h"

namespace facenav::links {

struct ClickRules {
  static constexpr const char* kModule = "links";
  static constexpr const char* kSubject = "the coil's click in a sound";

  double click_high_pass_hz = 2000, click_rise = 6, click_over_floor = 20, click_lull_before_ms = 25,
         click_longest_ms = 4, click_lull_after_ms = 14, click_still_after = 0.3, click_least_peak = 0.003,
         click_echo_ms = 60, click_over_echo = 0.2, click_over_others = 0.02;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kSpectrum("click_high_pass_hz", 100, 10000, "Hz", "what lies below is not listened to"),
            self.click_high_pass_hz);
    visitor(kFitted("click_rise", 1, 1000, "1", "power of a click against the loudest moment just before it"),
            self.click_rise);
    visitor(kFitted("click_over_floor", 1, 10000, "1", "power of a click against the usual noise"),
            self.click_over_floor);
    visitor(kPitch("click_lull_before_ms", 1, 50, "ms", "how long before a click nothing like it is heard"),
            self.click_lull_before_ms);
    visitor(kLength("click_longest_ms", 0.5, 10, "ms", "a click is over after this"), self.click_longest_ms);
    visitor(kTrain("click_lull_after_ms", 2, 18, "ms", "until when after a click nothing like it is heard"),
            self.click_lull_after_ms);
    visitor(kFitted("click_still_after", 0, 1, "1", "largest power after a click, against its own"),
            self.click_still_after);
    visitor(kFitted("click_least_peak", 0, 1, "1", "quietest click, against full scale"),
            self.click_least_peak);
    visitor(kEcho("click_echo_ms", 0, 90, "ms", "so long after a click its echoes may be heard"),
            self.click_echo_ms);
    visitor(kEcho("click_over_echo", 0, 1, "1", "power of a click against the one before, within that time"),
            self.click_over_echo);
    visitor(
        kOthers("click_over_others", 0, 1, "1", "power of a click against that of the last five (median)"),
        self.click_over_others);
  }

  static constexpr Evidence kSpectrum{
      Origin::chosen, "a coil's click has its power between 1 and 7 kHz; hum and most of speech lie below 2"};
  static constexpr Evidence kPitch{Origin::physics,
                                   "the lowest voices beat 70 times a second, so a beat of the voice has "
                                   "another one within 15 ms before it"};
  static constexpr Evidence kLength{Origin::chosen, "coils click for 0.3 to 3 ms"};
  static constexpr Evidence kTrain{Origin::physics, "pulses of a theta burst are 20 ms apart"};
  static constexpr Evidence kEcho{
      Origin::chosen,
      "an echo has 6 to 20 m to go in a room and is 12 dB weaker or more; pulses of "
      "a train are alike"};
  static constexpr Evidence kOthers{
      Origin::physics,
      "a click's power grows with the square of the output: 30 % of the largest one "
      "is 10 dB weaker, and 17 dB are allowed"};
  static constexpr Evidence kFitted{Origin::fitted,
                                    "made sound (testing/support/made_clicks.h), seeds 1 to 8: speech, hum, "
                                    "40 to 10 dB; held out, seeds 401 to "
                                    "410, of 2000 clicks: 0 missed and 1 wrong at 40 dB, 1 and 9 at 30 dB, "
                                    "382 and 17 at 20 dB; no real coil was "
                                    "heard"};
};

}  // namespace facenav::links
