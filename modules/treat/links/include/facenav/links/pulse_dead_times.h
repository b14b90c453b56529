#pragma once
// PulseDeadTimes: by source, the time within which a second trigger is a bounce and not a pulse. Trains have
// pulses 100 ms (10 Hz), 50 ms (20 Hz) and, in theta bursts, 20 ms apart (50 Hz); over a USB adapter they
// arrive up to 16 ms late. So only keys and pedals may have a dead time of more than a few milliseconds.

#include "facenav/core/setting.h"

namespace facenav::links {

struct PulseDeadTimes {
  static constexpr const char* kModule = "links";
  static constexpr const char* kSubject = "dead times of pulse sources";

  double keyboard_dead_s = 0.15, serial_byte_dead_s = 0.003, serial_line_dead_s = 0.005,
         network_dead_s = 0.002, lsl_dead_s = 0.002, sound_dead_s = 0.012;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kHand("keyboard_dead_s", 0, 1, "s", "of the key and the button"), self.keyboard_dead_s);
    visitor(kByte("serial_byte_dead_s", 0, 1, "s", "of bytes on a serial line"), self.serial_byte_dead_s);
    visitor(kLine("serial_line_dead_s", 0, 1, "s", "of edges on CTS or DSR"), self.serial_line_dead_s);
    visitor(kMessage("network_dead_s", 0, 1, "s", "of network messages"), self.network_dead_s);
    visitor(kMessage("lsl_dead_s", 0, 1, "s", "of LSL samples"), self.lsl_dead_s);
    visitor(kClick("sound_dead_s", 0, 1, "s", "of clicks in a sound"), self.sound_dead_s);
  }

  static constexpr Evidence kHand{
      Origin::chosen,
      "a person presses at most about 6 times a second, a key bounces for some 20 "
      "ms; InVesalius waits 0.15 s too, NaviNIBS 0.2 s"};
  static constexpr Evidence kByte{
      Origin::physics,
      "a line does not bounce; three bytes of one message take 3.1 ms at 9600 baud, "
      "and a USB adapter that sends every 16 ms brings 50 Hz pulses no less than 4 ms "
      "apart"};
  static constexpr Evidence kLine{
      Origin::physics,
      "a small relay bounces for 1 to 3 ms, an optocoupler not at all; a quarter of the "
      "20 ms between pulses at 50 Hz"};
  static constexpr Evidence kClick{
      Origin::physics, "a click lasts 3 ms and its first echoes 10; pulses of a theta burst are 20 ms apart"};
  static constexpr Evidence kMessage{
      Origin::physics,
      "a network does not bounce; a message that is sent twice arrives within a "
      "millisecond, paired pulses are 3 ms or more apart"};
};

}  // namespace facenav::links
