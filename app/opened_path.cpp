#include "opened_path.h"

#include "wrong_usage.h"

namespace facenav::app {
namespace fs = std::filesystem;

OpenedPath openedPath(const fs::path& typed) {
  std::error_code fault;
  if (!fs::exists(typed, fault)) throw WrongUsage("'" + typed.string() + "' does not exist");
  const bool is_folder = fs::is_directory(typed, fault);
  const fs::path folder = is_folder ? typed : fs::absolute(typed).parent_path();
  const auto holds = [&](const char* name) {
    return fs::is_regular_file(folder / name, fault) && (is_folder || typed.filename() == name);
  };
  if (!is_folder && holds("home.json")) return {{}, {}, folder};
  if (holds("case.json")) return {folder, {}, {}};
  if (holds("stereo.yml")) return {{}, folder, {}};
  throw WrongUsage("'" + typed.string() + "' is neither a case nor a recording",
                   "give a folder with case.json or stereo.yml in it");
}

}  // namespace facenav::app
