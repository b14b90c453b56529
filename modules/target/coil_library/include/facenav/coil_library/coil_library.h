#pragma once
// The coil library: a folder with one subfolder per coil, each with coil.json (resources/doc/formats.md,
// coil_card.h), mesh and patterns. Verbs and window choose a coil by its name. Two coils of a library never
// carry the same marker, because an image could not show which of them is in use.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/coil_tracking/coil_card.h"
#include "facenav/core/setting.h"

namespace facenav::coil_library {

struct CoilRules {
  static constexpr const char* kModule = "workflow";
  static constexpr const char* kSubject = "calibration of coils";

  double recalibrate_days = 180;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kRecalibrate("recalibrate_days", 0, 3650, "d",
                         "a coil whose calibration is older is reminded of; 0: never"),
            self.recalibrate_days);
  }

  static constexpr Evidence kRecalibrate{
      Origin::chosen,
      "by judgement: a glued print or its mount moves when a coil is knocked or its glue ages; no study of "
      "printed markers on coils was found"};
};

struct LibraryCoil {
  std::string name;
  std::filesystem::path file;  // its coil.json
  coil_tracking::CoilModel model;
  coil_tracking::CoilCard card;
  std::string problem;  // why its file cannot be used; empty if it can
};

/// Returns the library's folder: `asked` if not empty, else FACENAV_COILS, else facenav/coils in the user's
/// data folder (XDG_DATA_HOME, or ~/.local/share). The folder need not exist.
std::filesystem::path coilLibrary(const std::filesystem::path& asked = {});
/// Lists the coils by name. Unreadable ones come last, with their problem. Empty if the folder does not
/// exist.
std::vector<LibraryCoil> coilsIn(const std::filesystem::path& library);
/// Finds a coil by its name or by a unique beginning of it; case does not matter. Throws Error that lists the
/// existing names, or with the coil's own problem.
LibraryCoil findCoil(const std::filesystem::path& library, const std::string& name);
/// Takes `words` as the path of an existing coil.json, else as a name in the library. Throws Error.
std::filesystem::path coilFileOf(const std::string& words, const std::filesystem::path& library);

/// Values that the user gives when a coil is added. An absent value stays as in the coil's file.
struct CoilChanges {
  std::optional<std::string> name, make, model, serial;
  std::optional<Eigen::Vector3d> focus_mm;
};
/// Copies coil.json with its mesh and patterns into the library, all or nothing. Throws Error if the file is
/// no coil's, has no name, or if the library has a coil of that name (unless `replaces`) or with the same
/// marker.
LibraryCoil addCoil(const std::filesystem::path& library, const std::filesystem::path& coil_json,
                    const CoilChanges& changes, bool replaces);
/// Removes a coil. Throws Error as findCoil does; a damaged coil can be removed by the name of its folder.
void removeCoil(const std::filesystem::path& library, const std::string& name);

/// Reminder text for a calibration that is old or was never recorded: "the calibration of figure-8 70 mm is
/// 213 days old: calibrate it again (facenav calibrate-coil)". Returns nothing if it is recent. `now_s`:
/// seconds since 1970; default: now.
std::optional<std::string> calibrationReminder(const coil_tracking::CoilCard& card,
                                               std::optional<double> now_s = {});
/// Caution text: "the field of C100 is strongest 12 mm beside its centre: guidance brings the centre to the
/// target". Returns nothing if the field is strongest under the centre.
std::optional<std::string> focusCaution(const coil_tracking::CoilCard& card);
/// One line such as "figure-8 70 mm (Magstim D70, 12 345); marker 4x4_50 id 7; calibrated 2026-05-04, 0.21
/// mm".
std::string inWords(const LibraryCoil& coil);

}  // namespace facenav::coil_library
