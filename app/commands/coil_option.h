#pragma once
// A coil given on the command line: by its name in the library of coils, or by its coil.json.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "facenav/coil_library/coil_library.h"

namespace facenav::app {

struct CoilChoice {
  std::string words;              // a name or a file; empty: none
  std::filesystem::path library;  // empty: the usual one
  std::string second = {};        // a second coil, likewise; empty: none
};

/// Returns the chosen coil, or the default one if none is chosen. Throws Error if there is no such coil.
inline coil_tracking::CoilModel coilOf(const CoilChoice& choice) {
  if (choice.words.empty()) return coil_tracking::defaultCoil();
  return coil_tracking::readCoil(
      coil_library::coilFileOf(choice.words, coil_library::coilLibrary(choice.library)));
}

inline void addCoilLibraryOption(CLI::App& verb, std::filesystem::path& library) {
  verb.add_option("--coils", library,
                  "folder of the library of coils (default: FACENAV_COILS, else " +
                      std::string("facenav/coils in the user's data folder)"));
}

}  // namespace facenav::app
