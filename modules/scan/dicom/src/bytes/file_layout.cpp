#include "file_layout.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "damage_error.h"
#include "deflated.h"

namespace facenav::dicom {
namespace {

constexpr std::uint32_t kUndefined = 0xFFFFFFFFu;
constexpr std::uint32_t kItem = 0xFFFEE000u, kItemEnd = 0xFFFEE00Du, kSequenceEnd = 0xFFFEE0DDu;
constexpr std::uint32_t kPixelGroup = 0x7FE00008u;   // Float Pixel Data, the first of the pixel data elements
constexpr std::uint32_t kLargestValue = 256u << 20;  // before the pixels: documents, scanners' raw data
constexpr int kDeepestNesting = 32;
constexpr std::string_view kShortVrs = "AE AS AT CS DA DS DT FL FD IS LO LT PN SH SL SS ST TM UI UL US";
constexpr std::string_view kLongVrs = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";

bool isVr(std::string_view list, const char* vr) {
  for (std::size_t i = 0; i + 1 < list.size(); i += 3)
    if (list[i] == vr[0] && list[i + 1] == vr[1]) return true;
  return false;
}

struct Element {
  std::uint32_t tag = 0, length = 0;
  char vr[2] = {0, 0};  // zero: implicit VR
  std::uint64_t value = 0;
};

class Walker {
 public:
  Walker(FilePrefix& file, bool is_explicit, bool is_big_endian)
      : file_(file), is_explicit_(is_explicit), is_big_endian_(is_big_endian) {}

  [[noreturn]] void refuse(const std::string& what) const { throw DamageError(what, file_.path()); }
  std::uint32_t u16(std::uint64_t at) const {
    const auto* b = reinterpret_cast<const unsigned char*>(file_.bytes().data()) + at;
    return is_big_endian_ ? b[0] << 8 | b[1] : b[1] << 8 | b[0];
  }
  std::uint32_t u32(std::uint64_t at) const {
    return is_big_endian_ ? u16(at) << 16 | u16(at + 2) : u16(at + 2) << 16 | u16(at);
  }
  std::uint32_t tag(std::uint64_t at) const { return u16(at) << 16 | u16(at + 2); }
  void need(std::uint64_t end) {
    if (!file_.ensure(end)) refuse("DICOM header is cut off or damaged");
  }

  Element readElement(std::uint64_t at) {
    need(at + 8);
    Element e;
    e.tag = tag(at);
    const bool is_delimiter = e.tag >> 16 == 0xFFFE;
    if (!is_explicit_ || is_delimiter) {
      e.length = u32(at + 4);
      e.value = at + 8;
      return e;
    }
    std::memcpy(e.vr, file_.bytes().data() + at + 4, 2);
    if (isVr(kShortVrs, e.vr)) {
      e.length = u16(at + 6);
      e.value = at + 8;
    } else if (isVr(kLongVrs, e.vr)) {
      need(at + 12);
      e.length = u32(at + 8);
      e.value = at + 12;
    } else {
      refuse("DICOM header is damaged (an element of unknown type)");
    }
    return e;
  }

  /// Offset of the first byte after `e`.
  std::uint64_t skip(const Element& e, int depth) {
    if (depth > kDeepestNesting) refuse("DICOM header is damaged (sequences nested without end)");
    const bool is_unknown = e.vr[0] == 'U' && e.vr[1] == 'N';
    const bool is_sequence = e.vr[0] == 'S' && e.vr[1] == 'Q';
    if (e.length == kUndefined) {
      if (e.vr[0] && !is_unknown && !is_sequence) refuse("DICOM header is damaged (a value without length)");
      // An unknown element of undefined length is an implicit sequence, whatever the file's syntax (CP-246).
      Walker inner(file_, is_explicit_ && !is_unknown, is_big_endian_ && !is_unknown);
      return inner.skipItems(e.value, 0, depth);
    }
    const std::uint64_t end = e.value + e.length;
    need(end);
    const bool holds_items = e.length >= 8 && tag(e.value) == kItem;
    if (is_sequence || (!e.vr[0] && holds_items))
      if (skipItems(e.value, end, depth) != end)
        refuse("DICOM header is damaged (a sequence of wrong length)");
    return end;
  }

 private:
  /// Walks items up to `end`, or up to the sequence's delimiter where end is 0. Returns the offset after
  /// them.
  std::uint64_t skipItems(std::uint64_t at, std::uint64_t end, int depth) {
    while (end == 0 || at < end) {
      need(at + 8);
      const std::uint32_t item = tag(at), length = u32(at + 4);
      at += 8;
      if (item == kSequenceEnd) return at;
      if (item != kItem) refuse("DICOM header is damaged (no item where a sequence holds one)");
      at = skipElements(at, length == kUndefined ? 0 : at + length, depth + 1);
    }
    return at;
  }

  std::uint64_t skipElements(std::uint64_t at, std::uint64_t end, int depth) {
    if (end) need(end);
    while (end == 0 || at < end) {
      const Element e = readElement(at);
      if (e.tag == kItemEnd) return e.value;
      if (e.tag >> 16 == 0xFFFE) refuse("DICOM header is damaged (a stray sequence delimiter)");
      at = skip(e, depth);
    }
    if (end && at != end) refuse("DICOM header is damaged (an item of wrong length)");
    return at;
  }

  FilePrefix& file_;
  bool is_explicit_, is_big_endian_;
};

bool hasPreamble(FilePrefix& file) { return file.ensure(132) && file.bytes().compare(128, 4, "DICM") == 0; }

/// Reads group 0002; sets transfer syntax and start of the data set.
void walkMeta(FilePrefix& file, FileLayout& layout) {
  std::uint64_t at = layout.data_set_start;
  Walker walker(file, true, false);
  while (file.ensure(at + 8) && walker.u16(at) == 0x0002) {
    const Element e = walker.readElement(at);
    at = walker.skip(e, 0);
    if (e.tag == 0x00020010u) layout.transfer_syntax = file.bytes().substr(e.value, e.length);
  }
  while (!layout.transfer_syntax.empty() &&
         (layout.transfer_syntax.back() == '\0' || layout.transfer_syntax.back() == ' '))
    layout.transfer_syntax.pop_back();
  layout.data_set_start = at;
}

void guessSyntax(FilePrefix& file, FileLayout& layout) {
  const std::uint64_t at = layout.data_set_start;
  const bool has_vr = file.ensure(at + 8) &&
                      (isVr(kShortVrs, &file.bytes()[at + 4]) || isVr(kLongVrs, &file.bytes()[at + 4]));
  const bool is_big = file.ensure(at + 2) && file.bytes()[at] == 0 && file.bytes()[at + 1] != 0;
  layout.transfer_syntax = is_big   ? "1.2.840.10008.1.2.2"
                           : has_vr ? "1.2.840.10008.1.2.1"
                                    : "1.2.840.10008.1.2";
  layout.is_explicit = has_vr;
  layout.is_big_endian = is_big;
}

void readPixelElement(FilePrefix& file, Walker& walker, const Element& e, FileLayout& layout) {
  layout.has_pixels = true;
  layout.is_float = e.tag != 0x7FE00010u;
  layout.is_pixel_vr_word = e.vr[0] == 'O' && e.vr[1] == 'W';
  layout.is_encapsulated = e.length == kUndefined;
  layout.pixels = {e.value, layout.is_encapsulated ? 0 : e.length};
  if (e.tag > 0x7FE00010u)
    walker.refuse("DICOM header is damaged (an element of the pixel group is unknown)");
  layout.is_truncated = !layout.is_encapsulated && e.value + e.length > file.fileSize();
}

}  // namespace

bool looksLikeDicom(FilePrefix& file) {
  if (hasPreamble(file)) return true;
  if (!file.ensure(8)) return false;
  const auto* b = reinterpret_cast<const unsigned char*>(file.bytes().data());
  const bool is_little = (b[0] == 0x08 || b[0] == 0x02) && b[1] == 0 && b[3] == 0;
  const bool is_big = b[0] == 0 && b[1] == 0x08 && b[2] == 0;
  const bool has_vr = isVr(kShortVrs, &file.bytes()[4]) || isVr(kLongVrs, &file.bytes()[4]);
  const bool is_short = b[6] == 0 && b[7] == 0;  // implicit VR: a first element of less than 64 KB
  return (is_little || is_big) && (has_vr || is_short);
}

FileLayout walkHeader(FilePrefix& file) {
  FileLayout layout;
  layout.data_set_start = hasPreamble(file) ? 132 : 0;
  walkMeta(file, layout);
  if (layout.transfer_syntax == kDeflatedSyntax) {
    inflateDataSet(file, layout.data_set_start);
    layout.is_deflated = true;
    layout.transfer_syntax = "1.2.840.10008.1.2.1";
  }
  if (layout.transfer_syntax.empty()) {
    guessSyntax(file, layout);
  } else {
    layout.is_explicit = layout.transfer_syntax != "1.2.840.10008.1.2";
    layout.is_big_endian = layout.transfer_syntax == "1.2.840.10008.1.2.2";
  }
  Walker walker(file, layout.is_explicit, layout.is_big_endian);
  std::uint64_t at = layout.data_set_start;
  while (at < file.fileSize()) {
    const Element e = walker.readElement(at);
    if (e.tag >= kPixelGroup) {
      if (e.tag >> 16 == 0x7FE0) readPixelElement(file, walker, e, layout);
      break;  // ignore anything after the pixels (padding, junk)
    }
    const bool is_sequence = e.vr[0] == 'S' && e.vr[1] == 'Q';
    if (!is_sequence && e.length != kUndefined && e.length > kLargestValue &&
        e.value + e.length <= file.fileSize())
      break;  // raw data: no image follows
    at = walker.skip(e, 0);
  }
  layout.header_end = at;
  return layout;
}

std::vector<ByteRange> walkFragments(FilePrefix& file, const FileLayout& layout) {
  Walker walker(file, true, false);
  file.ensure(file.fileSize());  // one read for the whole file
  std::vector<ByteRange> fragments;
  std::uint64_t at = layout.pixels.offset;
  while (true) {
    if (!file.ensure(at + 8)) walker.refuse("pixel data is cut off");
    const std::uint32_t tag = walker.tag(at), length = walker.u32(at + 4);
    at += 8;
    if (tag == kSequenceEnd) return fragments;
    if (tag != kItem || length == kUndefined) walker.refuse("compressed pixel data is damaged");
    if (!file.ensure(at + length)) walker.refuse("pixel data is cut off");
    fragments.push_back({at, length});
    at += length;
  }
}

}  // namespace facenav::dicom
