#include "shell/elided_label.h"

#include <gtest/gtest.h>

#include "shell/users_words.h"

namespace facenav::ui {
namespace {

int widthOf(const QLabel& label, const QString& words) {
  return label.fontMetrics().horizontalAdvance(words);
}

TEST(ElidedLabel, LeavesOutWholePartsFromTheSecondOn) {
  ElidedLabel label;
  label.resize(2000, 30);
  label.setParts({"case 7", "checked by AB", "not aligned"});
  const QString whole = label.text();
  EXPECT_EQ(whole, QString::fromUtf8("case 7  \u00b7  checked by AB  \u00b7  not aligned"));
  label.resize(widthOf(label, whole) - 1, 30);
  label.show();
  EXPECT_EQ(label.text(), QString::fromUtf8("case 7  \u00b7  not aligned"));
  label.resize(widthOf(label, "case 7") + 1, 30);
  EXPECT_EQ(label.text(), "case 7");
  EXPECT_EQ(label.toolTip(), whole);
  label.resize(2000, 30);
  EXPECT_EQ(label.text(), whole);
}

TEST(ElidedLabel, ShortensThePartThatIsLeftOnlyIfAPersonWroteIt) {
  ElidedLabel label;
  label.resize(20, 30);
  label.setParts({"no cameras", "not aligned"});
  EXPECT_EQ(label.text(), "");
  EXPECT_TRUE(label.toolTip().contains("no cameras"));
  markUsersWords(label);
  label.setParts({"a long name of a case", "not aligned"});
  EXPECT_EQ(label.text(), "a long name of a case") << "painted with an ellipsis";
}

}  // namespace
}  // namespace facenav::ui
