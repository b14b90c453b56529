#include "facenav/volume/fast_compressor.h"

#include <libdeflate.h>
#include <vtkObjectFactory.h>
#include <vtkZLibDataCompressor.h>

#include <memory>

#include "facenav/core/error.h"

namespace facenav::volume {
namespace {

constexpr int kLevel = 1;  // higher levels take 1.5 times as long and save 5 %

struct CompressorDeleter {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};
using CompressorPtr = std::unique_ptr<libdeflate_compressor, CompressorDeleter>;

/// Keeps the name of VTK's class, which is written in the file's header.
class FastCompressor : public vtkZLibDataCompressor {
 public:
  static FastCompressor* New();

 protected:
  std::size_t CompressBuffer(const unsigned char* bytes, std::size_t size, unsigned char* out,
                             std::size_t space) override {
    const std::size_t written =
        compressor_ ? libdeflate_zlib_compress(compressor_.get(), bytes, size, out, space) : 0;
    return written > 0 ? written : vtkZLibDataCompressor::CompressBuffer(bytes, size, out, space);
  }

 private:
  CompressorPtr compressor_{libdeflate_alloc_compressor(kLevel)};
};
vtkStandardNewMacro(FastCompressor);

}  // namespace

vtkSmartPointer<vtkDataCompressor> fastCompressor() {
  return vtkSmartPointer<vtkDataCompressor>::Take(FastCompressor::New());
}

std::vector<unsigned char> gzipped(const void* bytes, std::size_t size) {
  const CompressorPtr compressor(libdeflate_alloc_compressor(kLevel));
  if (!compressor) throw Error("not enough memory to compress a file");
  const std::size_t most = libdeflate_gzip_compress_bound(compressor.get(), size);
  const std::unique_ptr<unsigned char[]> space(new unsigned char[most]);  // untouched pages take no memory
  const std::size_t written = libdeflate_gzip_compress(compressor.get(), bytes, size, space.get(), most);
  FACENAV_EXPECT(written > 0, "the bound holds every input");
  return {space.get(), space.get() + written};
}

}  // namespace facenav::volume
