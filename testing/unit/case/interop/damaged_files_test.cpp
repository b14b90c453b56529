// Damaged files: one clear line each, no crash.

#include <gmock/gmock.h>
#include <zlib.h>

#include <cstring>
#include <random>

#include "interop_fixtures.h"
#include "two_forms.h"

namespace facenav::interop {
namespace {

using namespace interop::testing;

/// Every made file, and one of each format that only FaceNav wrote.
std::map<std::string, std::string> contents() {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(made("")))
    if (entry.path().extension() != ".gz") all[entry.path().filename()] = readWholeFile(entry.path());
  Order order;
  order.t1 = madeHead().t1;
  for (const auto& [name, pose] : truth()) {
    Item item;
    item.name = name;
    item.mri_T_coil = pose;
    order.items.push_back(item);
  }
  for (const char* format : {"simnibs-mat", "csv", "json"})
    all[format] = writtenFormat(format).write(order).content;
  return all;
}

/// Reads and judges; returns the refusal, empty if the file was taken.
std::string outcomeOf(const std::string& content) {
  const auto head = madeHead();
  try {
    readCheckedText(content, head);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

void expectOneLine(const std::string& outcome, const std::string& of) {
  EXPECT_EQ(outcome.find('\n'), std::string::npos) << of << ": " << outcome;
  EXPECT_LT(outcome.size(), 500u) << of;
}

TEST(DamagedFiles, CutAnywhereAreRefusedOrShorter) {
  for (const auto& [name, content] : contents())
    for (int part = 0; part < 40; ++part)
      expectOneLine(outcomeOf(content.substr(0, content.size() * std::size_t(part) / 40)), name);
}

TEST(DamagedFiles, ChangedBytesDoNotCrash) {
  std::mt19937 random(7);
  for (const auto& [name, content] : contents())
    for (int trial = 0; trial < 60; ++trial) {
      std::string changed = content;
      for (int i = 0; i < 1 + trial / 6; ++i) changed[random() % changed.size()] = char(random() % 256);
      expectOneLine(outcomeOf(changed), name);
    }
}

TEST(DamagedFiles, NoiseAfterTheFirstWordsDoesNotCrash) {
  std::mt19937 random(11);
  for (const auto& [name, content] : contents()) {
    std::string noise = content.substr(0, std::min<std::size_t>(content.size(), 200));
    for (int i = 0; i < 4000; ++i) noise += char(random() % 256);
    expectOneLine(outcomeOf(noise), name);
  }
}

TEST(DamagedFiles, EmptyAndBinaryFilesAreRefused) {
  EXPECT_THAT(outcomeOf(""), ::testing::HasSubstr("is empty"));
  EXPECT_THAT(outcomeOf(" \n\t\n"), ::testing::HasSubstr("is empty"));
  EXPECT_THAT(outcomeOf(std::string(1000, '\0')), ::testing::HasSubstr("no file of a navigator"));
  EXPECT_THAT(outcomeOf("hello"), ::testing::HasSubstr("no file of a navigator"));
  EXPECT_THAT(outcomeOf(readWholeFile(made("t1_lpi.nii.gz"))),
              ::testing::HasSubstr("no file of a navigator"));
}

TEST(DamagedFiles, FalseCountsInAMatFileEndAtItsEnd) {
  std::string content = contents().at("simnibs-mat");
  for (std::size_t at = 128; at + 4 <= content.size() && at < 2000; at += 4) {
    std::string changed = content;
    for (std::size_t i = 0; i < 4; ++i) changed[at + i] = char(i == 3 ? 0x7F : 0xFF);
    expectOneLine(outcomeOf(changed), "byte " + std::to_string(at));
  }
}

TEST(DamagedFiles, DeeplyNestedFilesAreRefused) {
  const std::string deep(200000, '[');
  expectOneLine(outcomeOf("{\"markups\": " + deep), "json");
  std::string xml = "<InstrumentMarkerList>";
  for (int i = 0; i < 20000; ++i) xml += "<a>";
  expectOneLine(outcomeOf(xml), "xml");
}

/// The file with each variable as one zlib stream, as MATLAB writes it.
std::string compressed(const std::string& plain) {
  std::string result = plain.substr(0, 128);
  for (std::size_t at = 128; at + 8 <= plain.size();) {
    std::uint32_t size = 0;
    std::memcpy(&size, plain.data() + at + 4, 4);
    const std::size_t whole = 8 + size;
    uLongf length = compressBound(whole);
    std::string packed(length, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &length,
             reinterpret_cast<const Bytef*>(plain.data() + at), whole);
    const std::uint32_t tag[2] = {15, std::uint32_t(length)};
    result.append(reinterpret_cast<const char*>(tag), sizeof tag);
    result.append(packed, 0, length);
    at += whole;
  }
  return result;
}

TEST(Mat5, CompressedVariablesAreRead) {
  const std::string content = compressed(contents().at("simnibs-mat"));
  const auto file = readCheckedText(content, madeHead());
  EXPECT_EQ(apart(file, truth()).compared, 4);
  EXPECT_LT(apart(file, truth()).mm, 1e-9);
  for (std::size_t cut = 130; cut < content.size(); cut += 37)
    expectOneLine(outcomeOf(content.substr(0, cut)), "cut");
}

}  // namespace
}  // namespace facenav::interop
