#include "facenav/core/licences.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace facenav {
namespace {

TEST(Licences, EveryPartHasALicenceAndAPackage) {
  ASSERT_GT(licensedParts().size(), 25u);
  for (const auto& part : licensedParts()) {
    EXPECT_FALSE(part.name.empty());
    EXPECT_FALSE(part.licence.empty()) << part.name;
    EXPECT_FALSE(part.package.empty()) << part.name;
    const bool is_linked = part.use == PartUse::linked || part.use == PartUse::linked_in_lab;
    EXPECT_NE(part.libraries.empty(), is_linked) << part.name;
  }
}

/// A package with the GPL alone must not be linked; the compiler's runtime has its exception.
TEST(Licences, NoLinkedPartIsUnderTheGplAlone) {
  for (const auto& part : licensedParts()) {
    if (part.use == PartUse::data || part.use == PartUse::run) continue;
    const bool is_gpl = part.licence.rfind("GPL", 0) == 0 || part.licence.rfind("AGPL", 0) == 0;
    EXPECT_EQ(is_gpl && part.licence.find("GCC-exception") == std::string::npos, false) << part.name;
  }
}

TEST(Licences, VersionsAreThoseOfTheInstalledPackages) {
  const auto& parts = licensedParts();
  const auto vtk = std::find_if(parts.begin(), parts.end(), [](const auto& p) { return p.name == "VTK"; });
  ASSERT_NE(vtk, parts.end());
  EXPECT_EQ(vtk->version.substr(0, 2), "9.") << vtk->version;
}

TEST(Licences, TheUpstreamVersionHasNoEpochNoRevisionAndNoRepacking) {
  EXPECT_EQ(upstreamVersion("9.1.0+really9.1.0+dfsg2-5"), "9.1.0");
  EXPECT_EQ(upstreamVersion("1:1.2.13.dfsg-1"), "1.2.13.dfsg");
  EXPECT_EQ(upstreamVersion("2.36-9+deb12u14"), "2.36");
  EXPECT_EQ(upstreamVersion("3.0"), "3.0");
  EXPECT_EQ(upstreamVersion(""), "");
}

}  // namespace
}  // namespace facenav
