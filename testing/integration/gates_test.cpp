// `facenav evaluate gates --strangers`: one drawn world with two heads, so that each has one stranger.

#include <gmock/gmock.h>

#include <map>

#include "facenav/core/csv_table.h"
#include "support/command_line.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Row = std::map<std::string, std::string>;

std::vector<Row> pairsIn(const fs::path& folder) {
  const CsvTable table(folder / "strangers.csv");
  std::vector<Row> rows(table.rows());
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (const char* name : {"head", "scan", "mirrored", "accepted", "from", "bound_mm", "person_asked",
                             "confirmed_accepted", "confirmed_bound_mm", "refusal"})
      rows[row][name] = table.text(row, table.column(name));
  return rows;
}

TEST(EvaluateGates, PairsAWorldWithAnotherHeadAndItsMirrorImage) {
  const fs::path labels = sharedData() / "head_labels";
  FACENAV_NEEDS(labels);
  FACENAV_NEEDS(virtualPatientMri());
  const TemporaryFolder folder;
  for (const char* name : {"02.nii.gz", "t1_intensities.csv"})
    fs::create_symlink(labels / name, folder.path() / name);
  const fs::path out = folder.path() / "out";
  const std::string words = "evaluate gates --labels '" + folder.path().string() +
                            "' --worlds 1 --seed 17094 --even --strangers 5 -o '" + out.string() + "'";
  const auto drawn = runFacenav(words + " --keep", 280);
  ASSERT_EQ(drawn.status, 0) << drawn.errors;
  const auto pairs = pairsIn(out);
  ASSERT_EQ(pairs.size(), 2u);
  const std::string summary = readText(out / "worlds.md"), worlds = readText(out / "worlds.csv");
  for (const bool is_mirrored : {false, true}) {
    Row pair = pairs[is_mirrored];
    EXPECT_EQ(pair["mirrored"], is_mirrored ? "1" : "0");
    EXPECT_EQ(pair["scan"] == pair["head"], is_mirrored);
    const bool is_accepted = pair["accepted"] == "1";
    EXPECT_EQ(pair["refusal"].empty(), is_accepted);
    EXPECT_EQ(std::stod(pair["bound_mm"]) > 0.0, is_accepted);
    EXPECT_LE(pair["confirmed_accepted"], pair["person_asked"]);
    EXPECT_THAT(summary, HasSubstr(std::string(is_mirrored ? "the person's own, mirrored" : "of others") +
                                   (is_accepted ? " | 1 | 1 | 100.00 % |" : " | 1 | 0 | 95.00 % |")));
  }

  const auto kept = runFacenav(words + " --kept", 280);
  ASSERT_EQ(kept.status, 0) << kept.errors;
  EXPECT_EQ(pairsIn(out), pairs);
  EXPECT_EQ(readText(out / "worlds.csv"), worlds);
  EXPECT_EQ(readText(out / "worlds.md"), summary);
}

}  // namespace
}  // namespace facenav::testing
