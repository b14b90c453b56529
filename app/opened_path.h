#pragma once
// What a path that was given to the window means: the desktop gives a file that was clicked on, a person may
// give a folder.

#include <filesystem>

namespace facenav::app {

struct OpenedPath {
  std::filesystem::path case_folder, recording, home;  // one of them is set
};

/// Tells a case (its folder or case.json), a recording (its folder or stereo.yml) and a case for use at home
/// (home.json) apart. Throws WrongUsage: it is none of them.
OpenedPath openedPath(const std::filesystem::path& typed);

}  // namespace facenav::app
