#include "evaluate/gate_words.h"

#include <utility>

namespace facenav::app {

std::set<std::string> faultsNamedIn(const std::string& words) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"different moments", "out_of_step"},
      {"out_of_step", "out_of_step"},
      {"exchanged", "swapped"},
      {"swapped", "swapped"},
      {"moved since their calibration", "moved"},
      {"turned since the calibration", "moved"},
      {"turned sideways since the calibration (by", "moved"},
      {"moved on its mount", "moved"},
      {"cameras_moved", "moved"},
      {"does not belong to these cameras", "other_rig"},
      {"other_rig", "other_rig"},
      {"the MRI is mirrored", "mirrored"},
      {"the patient's own MRI", "other_person"},
      {"other_face", "other_person"},
      {"frozen", "frozen"},
  };
  std::set<std::string> named;
  for (const auto& [part, name] : kNames)
    if (words.find(part) != std::string::npos) named.insert(name);
  // These words blame a camera first; the patient's own MRI is their second advice.
  if (named.count("moved")) named.erase("other_person");
  // "the MRI is mirrored: its left and right are swapped"
  if (named.count("mirrored")) named.erase("swapped"), named.erase("other_person");
  return named;
}

std::string rightNameOf(room::WorldFault fault) {
  switch (fault) {
    case room::WorldFault::none:
      return {};
    case room::WorldFault::turned:
    case room::WorldFault::shifted:
      return "moved";
    default:
      return room::nameOf(fault);
  }
}

}  // namespace facenav::app
