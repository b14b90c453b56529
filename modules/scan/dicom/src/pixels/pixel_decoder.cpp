#include "pixel_decoder.h"

#include <gdcmByteValue.h>
#include <gdcmDataElement.h>
#include <gdcmJPEG2000Codec.h>
#include <gdcmJPEGCodec.h>
#include <gdcmJPEGLSCodec.h>
#include <gdcmRLECodec.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTransferSyntax.h>

#include <cstring>

#include "codestream_size.h"
#include "facenav/core/error.h"
#include "isolated_codec.h"

namespace facenav::dicom {
namespace {

enum class Coding { native, rle, jpeg, jpeg_ls, jpeg_2000, unknown };

Coding codingOf(const std::string& syntax) {
  const std::string root = "1.2.840.10008.1.2";
  if (syntax == root || syntax == root + ".1" || syntax == root + ".2") return Coding::native;
  if (syntax == root + ".5") return Coding::rle;
  for (const char* end : {".4.50", ".4.51", ".4.57", ".4.70"})
    if (syntax == root + end) return Coding::jpeg;
  if (syntax == root + ".4.80" || syntax == root + ".4.81") return Coding::jpeg_ls;
  if (syntax == root + ".4.90" || syntax == root + ".4.91") return Coding::jpeg_2000;
  return Coding::unknown;
}

std::string decompress(gdcm::ImageCodec& codec, const VoxelFormat& format, const std::string& syntax,
                       const std::string& stream) {
  gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = new gdcm::SequenceOfFragments;
  gdcm::Fragment fragment;
  fragment.SetByteValue(stream.data(), std::uint32_t(stream.size()));
  fragments->AddFragment(fragment);
  gdcm::DataElement in(gdcm::Tag(0x7fe0, 0x0010), 0, gdcm::VR::OB), out;
  in.SetValue(*fragments);
  const unsigned int size[3] = {unsigned(format.columns), unsigned(format.rows), 1};
  codec.SetNumberOfDimensions(2);
  codec.SetDimensions(size);
  codec.SetPlanarConfiguration(0);
  codec.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  codec.SetPixelFormat(gdcm::PixelFormat(1, std::uint16_t(format.bits_allocated),
                                         std::uint16_t(format.bits_stored), std::uint16_t(format.high_bit),
                                         format.is_signed ? 1 : 0));
  if (!codec.CanDecode(gdcm::TransferSyntax(gdcm::TransferSyntax::GetTSType(syntax.c_str())))) return {};
  if (!codec.Decode(in, out) || !out.GetByteValue()) return {};
  return {out.GetByteValue()->GetPointer(), std::size_t(out.GetByteValue()->GetLength())};
}

template <class T>
T load(const char* bytes, bool is_big_endian) {
  unsigned char b[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i)
    b[i] = static_cast<unsigned char>(bytes[is_big_endian ? sizeof(T) - 1 - i : i]);
  T value;
  std::memcpy(&value, b, sizeof(T));
  return value;
}

/// The stored value within its bits: removes overlay bits, extends the sign (PS3.5 8.1.1).
template <class T>
T withinStoredBits(T value, const VoxelFormat& format) {
  using Wide = std::int64_t;
  const int shift = format.high_bit + 1 - format.bits_stored;
  Wide bits = (Wide(value) >> shift) & ((Wide(1) << format.bits_stored) - 1);
  if (format.is_signed && bits >> (format.bits_stored - 1) & 1) bits -= Wide(1) << format.bits_stored;
  return T(bits);
}

/// Some files have wrong depths. Therefore bits above the stored ones are removed only where they are known
/// to contain something else, and at 12 bits, where dcm2niix removes them too.
bool needsMask(const VoxelFormat& format) {
  return format.has_embedded_overlay || format.high_bit + 1 != format.bits_stored || format.bits_stored == 12;
}

template <class T>
void rescale(std::string_view bytes, bool is_big_endian, const VoxelFormat& format, const ImagePlace& place,
             float* out) {
  // NIfTI keeps slope and intercept in 32 bits; so does this code, so that values equal dcm2niix's to the
  // last bit.
  const double slope = float(place.slope), intercept = float(place.intercept);
  const std::size_t count = bytes.size() / sizeof(T);
  const bool is_masked = std::is_integral_v<T> && needsMask(format);
  if (std::is_integral_v<T> && sizeof(T) <= 2 && !is_big_endian && !is_masked && slope == 1 &&
      intercept == 0) {
    for (std::size_t i = 0; i < count; ++i) {  // exact, and twice as fast as with double
      T value;
      std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
      out[i] = float(value);
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));  // common case: vectorised
    if (is_big_endian || is_masked) {
      value = load<T>(bytes.data() + i * sizeof(T), is_big_endian);
      if constexpr (std::is_integral_v<T>)
        if (is_masked) value = withinStoredBits(value, format);
    }
    out[i] = float(slope * double(value) + intercept);
    if constexpr (!std::is_integral_v<T>)
      if (!(out[i] - out[i] == 0)) out[i] = 0.f;
  }
}

}  // namespace

std::string voxelProblem(const SliceHeader& header) {
  const VoxelFormat& v = header.voxels;
  constexpr int kLargestMatrix = 8192, kMostFrames = 65536;
  if (!header.layout.has_pixels) return "holds no image";
  if (v.rows < 1 || v.columns < 1) return "image without rows or columns";
  if (v.rows > kLargestMatrix || v.columns > kLargestMatrix || v.frames < 1 || v.frames > kMostFrames)
    return "image of an impossible size (" + std::to_string(v.columns) + " x " + std::to_string(v.rows) +
           " x " + std::to_string(v.frames) + ")";
  if (v.samples != 1) return "colour image";
  if (v.photometric == "PALETTE COLOR") return "colour image (palette)";
  const int bits = v.bits_allocated;
  const bool has_known_bits =
      header.layout.is_float ? bits == 32 || bits == 64 : bits == 8 || bits == 16 || bits == 32;
  if (!has_known_bits) return std::to_string(bits) + " bits a voxel are not read";
  if (v.bits_stored < 1 || v.bits_stored > bits || v.high_bit < v.bits_stored - 1 || v.high_bit >= bits)
    return "bits stored, high bit and bits allocated contradict each other";
  const Coding coding = codingOf(header.layout.transfer_syntax);
  if (coding == Coding::unknown) return "compression " + header.layout.transfer_syntax + " is not read";
  if (header.layout.is_encapsulated == (coding == Coding::native))
    return "transfer syntax and pixel data contradict each other";
  return {};
}

bool usesForeignCodec(const SliceHeader& header) {
  const Coding coding = codingOf(header.layout.transfer_syntax);
  return coding != Coding::native && coding != Coding::unknown;
}

void PixelDecoder::refuse(const std::string& what) const {
  throw Error(what, header_.file.string(), "copy or export it again");
}

PixelDecoder::PixelDecoder(FilePrefix& file, const SliceHeader& header, Isolation isolation)
    : file_(file), header_(header), isolation_(isolation) {
  const std::string problem = voxelProblem(header);
  if (!problem.empty()) throw Error(problem, header.file.string(), "choose another series");
  const FileLayout& layout = header.layout;
  if (layout.is_encapsulated) {
    fragments_ = walkFragments(file, layout);
    if (fragments_.size() < 2) refuse("compressed pixel data holds no image");
    return;
  }
  if (layout.is_truncated || layout.pixels.length > file.fileSize() ||
      layout.pixels.offset > file.fileSize() - layout.pixels.length)
    refuse("pixel data is cut off");
  if (layout.pixels.length < imageBytes() * header.voxels.frames)
    refuse("pixel data holds " + std::to_string(layout.pixels.length) + " bytes, " +
           std::to_string(imageBytes() * header.voxels.frames) + " were expected");
}

std::size_t PixelDecoder::imageBytes() const {
  return std::size_t(header_.voxels.rows) * header_.voxels.columns * (header_.voxels.bits_allocated / 8);
}

std::string PixelDecoder::frameStream(int frame) const {
  const std::size_t count = fragments_.size() - 1, frames = std::size_t(header_.voxels.frames);
  std::size_t first = 1, last = count;  // fragments of this frame
  const ByteRange table = fragments_[0];
  if (frames > 1 && count == frames) {
    first = last = 1 + std::size_t(frame);
  } else if (frames > 1) {
    if (table.length != frames * 4) refuse("compressed frames cannot be separated (no offset table)");
    const auto offset = [&](std::size_t f) {
      return fragments_[1].offset - 8 + load<std::uint32_t>(&file_.bytes()[table.offset + 4 * f], false);
    };
    const std::uint64_t begin = offset(frame),
                        end = std::size_t(frame) + 1 < frames ? offset(frame + 1) : UINT64_MAX;
    while (first <= count && fragments_[first].offset - 8 < begin) ++first;
    last = first;
    while (last < count && fragments_[last + 1].offset - 8 < end) ++last;
    if (first > count || fragments_[first].offset - 8 != begin)
      refuse("compressed frames cannot be separated");
  }
  std::string stream;
  for (std::size_t f = first; f <= last; ++f)
    stream.append(file_.bytes(), fragments_[f].offset, fragments_[f].length);
  return stream;
}

PixelDecoder::Raw PixelDecoder::raw(int frame, std::string& scratch) const {
  const VoxelFormat& v = header_.voxels;
  Raw raw;
  raw.bits = v.bits_allocated;
  if (!header_.layout.is_encapsulated) {
    scratch.resize(imageBytes());
    if (!file_.copy(header_.layout.pixels.offset + frame * imageBytes(), imageBytes(), scratch.data()))
      refuse("pixel data is cut off");
    raw.bytes = scratch;
    raw.is_big_endian = header_.layout.is_big_endian;
    return raw;
  }
  const std::string stream = frameStream(frame);
  const std::size_t voxels = std::size_t(v.rows) * v.columns;
  const Coding coding = codingOf(header_.layout.transfer_syntax);
  if (coding != Coding::rle) {  // whose stream does not state a size
    const auto size = coding == Coding::jpeg_2000 ? jpeg2000Size(stream) : jpegSize(stream);
    if (!size || size->width != v.columns || size->height != v.rows || size->components != 1)
      refuse("compressed pixel data is damaged or of another size than its header says");
  }
  const std::string& syntax = header_.layout.transfer_syntax;
  const auto decompressed = [&]() -> std::string {
    gdcm::JPEGCodec jpeg;
    gdcm::JPEGLSCodec jpeg_ls;
    gdcm::JPEG2000Codec jpeg_2000;
    gdcm::RLECodec rle;
    rle.SetBufferLength(imageBytes());
    if (coding == Coding::jpeg) return decompress(jpeg, v, syntax, stream);
    if (coding == Coding::jpeg_ls) return decompress(jpeg_ls, v, syntax, stream);
    if (coding == Coding::rle) return decompress(rle, v, syntax, stream);
    return decompress(jpeg_2000, v, syntax, stream);
  };
  constexpr std::size_t kWidestVoxel = 4;
  scratch =
      isolation_ == Isolation::each_image ? runIsolated(decompressed, voxels * kWidestVoxel) : decompressed();
  for (const int bits : {8, 16, 32})
    if (scratch.size() / voxels == std::size_t(bits / 8)) raw.bits = bits;
  if (scratch.size() < voxels * (raw.bits / 8)) refuse("compressed pixel data is damaged");
  raw.bytes = std::string_view(scratch).substr(0, voxels * (raw.bits / 8));
  return raw;
}

void PixelDecoder::decode(int frame, float* out, std::string& scratch) const {
  if (frame < 0 || frame >= header_.voxels.frames || header_.images.empty() ||
      (header_.images.size() > 1 && std::size_t(frame) >= header_.images.size()))
    refuse("does not hold the frame asked for");
  const ImagePlace& place = header_.images[header_.images.size() == 1 ? 0 : std::size_t(frame)];
  const VoxelFormat& v = header_.voxels;
  const Raw data = raw(frame, scratch);
  const auto as = [&](auto type) { rescale<decltype(type)>(data.bytes, data.is_big_endian, v, place, out); };
  if (header_.layout.is_float) return data.bits == 64 ? as(double{}) : as(float{});
  if (data.bits == 8 && data.is_big_endian && header_.layout.is_pixel_vr_word) {
    std::string swapped(data.bytes);  // 8-bit voxels are stored in 16-bit words
    for (std::size_t i = 0; i + 1 < swapped.size(); i += 2) std::swap(swapped[i], swapped[i + 1]);
    return v.is_signed ? rescale<std::int8_t>(swapped, false, v, place, out)
                       : rescale<std::uint8_t>(swapped, false, v, place, out);
  }
  if (data.bits == 8) return v.is_signed ? as(std::int8_t{}) : as(std::uint8_t{});
  if (data.bits == 16) return v.is_signed ? as(std::int16_t{}) : as(std::uint16_t{});
  return v.is_signed ? as(std::int32_t{}) : as(std::uint32_t{});
}

std::vector<float> PixelDecoder::image(int frame) const {
  std::vector<float> values(std::size_t(header_.voxels.rows) * header_.voxels.columns);
  std::string scratch;
  decode(frame, values.data(), scratch);
  return values;
}

}  // namespace facenav::dicom
