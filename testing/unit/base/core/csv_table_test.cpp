#include "facenav/core/csv_table.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav {
namespace {

constexpr CsvRules kLoose{true, true};

class CsvTableTest : public ::testing::Test {
 protected:
  CsvTable read(const std::string& content, const CsvRules& rules = {}) {
    writeWholeFile(folder_.path() / "a.csv", content);
    return CsvTable(folder_.path() / "a.csv", rules);
  }
  template <class Work>
  std::string messageOf(Work&& work) {
    try {
      work();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
  testing::TemporaryFolder folder_;
};

TEST_F(CsvTableTest, FindsColumnsByNameInAnyOrder) {
  const auto table = read("\xEF\xBB\xBFname,t_s,extra\r\n\"a, \"\"b\"\"\",0.5,x\r\n\nc,-1e3,\n");
  ASSERT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.number(0, table.column("t_s")), 0.5);
  EXPECT_EQ(table.number(1, table.column("t_s")), -1000);
  EXPECT_EQ(table.text(0, table.column("name")), "a, \"b\"");
  EXPECT_EQ(table.text(1, table.column("extra")), "");
  EXPECT_FALSE(table.findColumn("absent"));
}

TEST_F(CsvTableTest, NamesFileAndLineOfAFault) {
  const auto table = read("a,b\n1,2\n\n1.5,x\n");
  EXPECT_NE(messageOf([&] { table.number(1, 1); }).find("a.csv, line 4"), std::string::npos);
  EXPECT_NE(messageOf([&] { table.number(1, 1); }).find("'x' in column 'b'"), std::string::npos);
  EXPECT_NE(messageOf([&] { table.integer(1, 0); }).find("no whole number"), std::string::npos);
  EXPECT_NE(messageOf([&] { table.column("c"); }).find("'c'"), std::string::npos);
}

TEST_F(CsvTableTest, RefusesNumbersThatAreNotFinite) {
  const auto table = read("a\nnan\ninf\n1e999\n1x\n");
  for (std::size_t row = 0; row < table.rows(); ++row) EXPECT_THROW(table.number(row, 0), Error) << row;
}

TEST_F(CsvTableTest, RefusesRaggedRowsUnlessAllowed) {
  EXPECT_NE(messageOf([&] { read("a,b\n1,2\n3\n"); }).find("2 fields were expected, 1 found"),
            std::string::npos);
  const auto table = read("a,b\n1\n1,2,3\n", kLoose);
  EXPECT_EQ(table.number(0, 0), 1);
  EXPECT_EQ(table.number(1, 1), 2);
  EXPECT_NE(messageOf([&] { table.text(0, 1); }).find("the value of column 'b' is missing"),
            std::string::npos);
}

TEST_F(CsvTableTest, LeavesOutBlanksWhereTheyAreAllowed) {
  const auto table = read("a , b\n 1,\t2 \n   \n\" x \" ,3\n", kLoose);
  ASSERT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.number(0, table.column("b")), 2);
  EXPECT_EQ(table.text(1, table.column("a")), " x ") << "what is quoted stays";
  EXPECT_THROW(read("a,b\n 1,2\n").number(0, 0), Error);
}

TEST_F(CsvTableTest, RefusesAnEmptyFile) { EXPECT_THROW(read(""), Error); }

}  // namespace
}  // namespace facenav
