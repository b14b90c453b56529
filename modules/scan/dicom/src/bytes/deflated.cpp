#include "deflated.h"

#include <zlib.h>

#include <algorithm>

#include "damage_error.h"

namespace facenav::dicom {

void inflateDataSet(FilePrefix& file, std::uint64_t data_set_start) {
  constexpr std::size_t kMost = std::size_t(4) << 30, kStep = 1 << 20;
  const auto refuse = [&] { throw DamageError("deflated data set is damaged", file.path()); };
  if (!file.ensure(file.fileSize())) refuse();
  std::string out = file.bytes().substr(0, data_set_start);
  std::string in = file.bytes().substr(data_set_start);
  z_stream stream{};
  if (in.size() > 0xFFFFFFFFu || inflateInit2(&stream, -MAX_WBITS) != Z_OK) refuse();
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = uInt(in.size());
  int status = Z_OK;
  while (status == Z_OK && out.size() < kMost) {
    const std::size_t have = out.size();
    out.resize(have + kStep);
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + have);
    stream.avail_out = uInt(kStep);
    status = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (status != Z_STREAM_END) refuse();
  file.replace(std::move(out));
}

}  // namespace facenav::dicom
