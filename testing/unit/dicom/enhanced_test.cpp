// Enhanced MR: many frames in one file, each with its place in functional groups (PS3.3 C.7.6.16).

#include "compare_volumes.h"
#include "dicom_bytes.h"
#include "facenav/dicom/import_volume.h"

namespace facenav::testing {
namespace {

struct Enhanced {
  int frames = 10;
  int echoes = 1;
  Syntax syntax;
};

std::string enhancedFile(const Enhanced& spec) {
  Slice s;
  s.syntax = spec.syntax;
  const Syntax& x = s.syntax;
  DataSetBytes d(x);
  d.raw(0x00080008, "CS", "ORIGINAL\\PRIMARY\\VOLUME\\NONE")
      .raw(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.4.1");
  d.raw(0x00080018, "UI", "1.2.3.4.5").raw(0x00080060, "CS", "MR").raw(0x0008103E, "LO", "T1 3D");
  d.raw(0x0020000D, "UI", "1.2.3").raw(0x0020000E, "UI", "1.2.3.4");
  d.us(0x00280002, 1)
      .raw(0x00280004, "CS", "MONOCHROME2")
      .raw(0x00280008, "IS", std::to_string(spec.frames * spec.echoes));
  d.us(0x00280010, s.rows)
      .us(0x00280011, s.columns)
      .us(0x00280100, 16)
      .us(0x00280101, 12)
      .us(0x00280102, 11)
      .us(0x00280103, 0);
  DataSetBytes shared(x);
  shared.sequence(0x00209116, {DataSetBytes(x).ds(0x00200037, {0, 1, 0, 0, 0, -1})});
  shared.sequence(0x00289110, {DataSetBytes(x).ds(0x00180050, {1.5}).ds(0x00280030, {0.9, 1.1})});
  d.sequence(0x52009229, {shared});
  std::vector<DataSetBytes> frames;
  std::string pixels;
  for (int f = 0; f < spec.frames; ++f)
    for (int e = 0; e < spec.echoes; ++e) {
      const int k = spec.frames - 1 - f;  // stored backwards
      DataSetBytes frame(x);
      const double echo_ms = 3.5 + e;
      std::string echo(reinterpret_cast<const char*>(&echo_ms), 8);
      if (x.is_big_endian) std::reverse(echo.begin(), echo.end());
      frame.sequence(0x00189114, {DataSetBytes(x).raw(0x00189082, "FD", echo)});
      frame.sequence(0x00209113, {DataSetBytes(x).ds(0x00200032, {-40 + 1.5 * k, -80, 60})});
      frame.sequence(0x00289145, {DataSetBytes(x).ds(0x00281052, {double(k)}).ds(0x00281053, {2})});
      frames.push_back(frame);
      for (int p = 0; p < s.rows * s.columns; ++p)
        pixels += d.encoded(std::uint32_t((p + 1000 * k + 7 * e) % 4096), 2);
    }
  d.sequence(0x52009230, frames);
  return fileOf(d.raw(0x7FE00010, "OW", pixels));
}

TEST(EnhancedMr, FramesArePlacedByTheirFunctionalGroups) {
  for (const Syntax& syntax : {explicitLittle(), implicitLittle(), explicitBig()}) {
    SCOPED_TRACE(syntax.uid);
    const TemporaryFolder folder;
    writeBytes(folder.path() / "in", enhancedFile({10, 1, syntax}));
    TaskMonitor monitor;
    const auto volume = dicom::importVolume(folder.path() / "in", std::nullopt, monitor).volume;
    ASSERT_EQ(volume.grid.size, (std::array<int, 3>{20, 24, 10}));
    // Row +y, column -z: normal -x, so index k runs from the frame of greatest x down. RAS of frame place 9.
    EXPECT_LT((volume.grid.toMri({2, 3, 0}).mm - Eigen::Vector3d(40 - 13.5, 80 - 2.2, 60 - 2.7)).norm(),
              1e-9);
    EXPECT_EQ(volume.at(2, 3, 0), float(2 * ((3 * 20 + 2 + 9000) % 4096) + 9));
  }
}

TEST(EnhancedMr, EchoesOfOneFileAreSplit) {
  const TemporaryFolder folder;
  writeBytes(folder.path() / "in", enhancedFile({10, 2, explicitLittle()}));
  TaskMonitor monitor;
  const auto series = dicom::listSeries(folder.path(), monitor);
  ASSERT_EQ(series.size(), 2u);
  for (const auto& info : series) {
    EXPECT_TRUE(info.is_loadable) << info.problem;
    EXPECT_EQ(info.slices, 10);
    const int echo = info.part == "echo 3.5 ms" ? 0 : 1;
    EXPECT_EQ(dicom::loadSeries(info, monitor).at(0, 0, 0), float(2 * ((9000 + 7 * echo) % 4096) + 9));
  }
}

}  // namespace
}  // namespace facenav::testing
