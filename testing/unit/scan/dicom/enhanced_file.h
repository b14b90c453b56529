#pragma once
// An enhanced MR file made byte by byte (PS3.3 A.36): every frame with its own place, echo and rescale.

#include <algorithm>

#include "dicom_bytes.h"

namespace facenav::testing {

struct Enhanced {
  int frames = 10;
  int echoes = 1;
  Syntax syntax;
  bool has_own_intercepts = true;  // intercept of frame k is k
  int stacks = 0;                  // Stack IDs; 0: none
  bool has_slabs = false;          // each stack is a slab; otherwise neighbours are in different stacks
  double between_stacks_mm = 0;    // gap beside each slab, beyond the spacing
  std::string patient_id = {};     // omitted if empty
};

inline std::string enhancedFile(const Enhanced& spec) {
  Slice s;
  s.syntax = spec.syntax;
  const Syntax& x = s.syntax;
  DataSetBytes d(x);
  d.raw(0x00080008, "CS", "ORIGINAL\\PRIMARY\\VOLUME\\NONE")
      .raw(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.4.1");
  d.raw(0x00080018, "UI", "1.2.3.4.5").raw(0x00080060, "CS", "MR").raw(0x0008103E, "LO", "T1 3D");
  if (!spec.patient_id.empty()) d.raw(0x00100020, "LO", spec.patient_id);
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
      const int stack = spec.stacks == 0 ? 0
                        : spec.has_slabs ? k * spec.stacks / spec.frames
                                         : k % spec.stacks;
      if (spec.stacks > 0)
        frame.sequence(0x00209111, {DataSetBytes(x).raw(0x00209056, "SH", std::to_string(stack + 1))});
      const double along_mm = 1.5 * k + spec.between_stacks_mm * stack;
      frame.sequence(0x00209113, {DataSetBytes(x).ds(0x00200032, {-40 + along_mm, -80, 60})});
      frame.sequence(
          0x00289145,
          {DataSetBytes(x).ds(0x00281052, {spec.has_own_intercepts ? double(k) : 0.0}).ds(0x00281053, {2})});
      frames.push_back(frame);
      for (int p = 0; p < s.rows * s.columns; ++p)
        pixels += d.encoded(std::uint32_t((p + 1000 * k + 7 * e) % 4096), 2);
    }
  d.sequence(0x52009230, frames);
  return fileOf(d.raw(0x7FE00010, "OW", pixels));
}

}  // namespace facenav::testing
