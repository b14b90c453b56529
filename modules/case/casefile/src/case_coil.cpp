#include "facenav/casefile/case_coil.h"

#include "facenav/core/json_reader.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

fs::path coilFile(const fs::path& case_folder) { return case_folder / "coil.json"; }

}  // namespace

CaseCoil coilOf(const fs::path& case_folder) {
  CaseCoil coil;
  const fs::path file = coilFile(case_folder);
  if (!fs::exists(file)) return coil;
  const JsonReader json = JsonReader::readFile(file);
  if (json.has("name")) coil.name = json.at("name").text();
  coil.plate = guidance::readPlate(file);
  coil.is_default = false;
  return coil;
}

void setCoil(const fs::path& case_folder, const fs::path& coil_json) {
  guidance::readPlate(coil_json);  // throws for a file that is no coil's
  writeWholeFile(coilFile(case_folder), readWholeFile(coil_json), FileAccess::owner_only);
}

}  // namespace facenav::casefile
