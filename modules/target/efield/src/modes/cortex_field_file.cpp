#include <array>
#include <cstring>
#include <fstream>
#include <type_traits>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/efield/cortex_field.h"
#include "kernels/field_kernel.h"
#include "modes/packed_modes.h"

namespace facenav::efield {
namespace {

// Little-endian, as every machine this program runs on. The last digit is the version.
constexpr char kMark[] = "FaceNav field 1\n";
constexpr const char* kRemedy = "compute the field again";

/// Checksum of the content (FNV-1a, 64 bits, over 8 bytes at a time).
std::uint64_t checksum(const std::string& bytes) {
  std::uint64_t sum = 14695981039346656037ull;
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
    sum = (sum ^ word) * 1099511628211ull;
  }
  return sum;
}

class Writer {
 public:
  template <class Value>
  void add(const Value* values, std::size_t count) {
    static_assert(std::is_arithmetic_v<Value>);
    bytes_.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
  }
  void addNumber(std::uint64_t value) { add(&value, 1); }
  std::string& bytes() { return bytes_; }

 private:
  std::string bytes_;
};

class Reader {
 public:
  Reader(const std::string& bytes, std::string path) : bytes_(bytes), path_(std::move(path)) {}
  template <class Value>
  void take(Value* values, std::uint64_t count) {
    if (count > (bytes_.size() - at_) / sizeof(Value)) refuse();
    std::memcpy(values, bytes_.data() + at_, std::size_t(count) * sizeof(Value));
    at_ += std::size_t(count) * sizeof(Value);
  }
  template <class Value>
  std::vector<Value> takeMany(std::uint64_t count) {
    if (count > (bytes_.size() - at_) / sizeof(Value)) refuse();
    std::vector<Value> values(static_cast<std::size_t>(count));
    take(values.data(), count);
    return values;
  }
  std::uint64_t number() {
    std::uint64_t value = 0;
    take(&value, 1);
    return value;
  }
  std::size_t at() const { return at_; }
  [[noreturn]] void refuse() const {
    throw Error("the file of the electric field is damaged", path_, kRemedy);
  }

 private:
  const std::string& bytes_;
  std::string path_;
  std::size_t at_ = 0;
};

/// Takes the file's mark and the text of the model.
std::string modelFrom(Reader& file) {
  std::array<char, sizeof kMark - 1> mark{};
  file.take(mark.data(), mark.size());
  if (std::memcmp(mark.data(), kMark, mark.size()) != 0) file.refuse();
  const std::vector<char> model = file.takeMany<char>(file.number());
  return {model.begin(), model.end()};
}

}  // namespace

void writeCortexField(const CortexField& field, const std::string& model, const std::filesystem::path& path,
                      FileAccess access) {
  Writer file;
  file.add(kMark, sizeof kMark - 1);
  file.addNumber(model.size());
  file.add(model.data(), model.size());
  file.addNumber(std::uint64_t(field.points_mm.cols()));
  file.addNumber(std::uint64_t(field.samples_mm.cols()));
  file.addNumber(std::uint64_t(field.modes));
  file.add(&field.mode_error, 1);
  file.add(field.points_mm.data(), std::size_t(field.points_mm.size()));
  file.add(field.is_moved.data(), field.is_moved.size());
  file.add(field.samples_mm.data(), std::size_t(field.samples_mm.size()));
  file.add(field.intake.data(), field.intake.size());
  file.add(field.shapes.data(), field.shapes.size());
  file.addNumber(checksum(file.bytes()));
  writeWholeFile(path, file.bytes(), access);
}

std::string modelOfFile(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error("the file of the electric field cannot be read", path.string(), kRemedy);
  constexpr std::size_t kLongest = 4096;  // of the part that holds the model
  std::string bytes(kLongest, 0);
  stream.read(bytes.data(), std::streamsize(bytes.size()));
  bytes.resize(std::size_t(stream.gcount()));
  Reader file(bytes, path.string());
  return modelFrom(file);
}

CortexField readCortexField(const std::filesystem::path& path, const std::string& model) {
  const std::string bytes = readWholeFile(path);
  Reader file(bytes, path.string());
  if (modelFrom(file) != model)
    throw Error("the electric field was computed for another head model", path.string(), kRemedy);
  const std::uint64_t points = file.number(), samples = file.number(), modes = file.number();
  constexpr std::uint64_t kMost = 1u << 24;
  if (points == 0 || points > kMost || samples > kMost || samples % kernels::kLanes || modes > kMost ||
      modes % kernels::kBlock)
    file.refuse();
  CortexField field;
  file.take(&field.mode_error, 1);
  field.modes = Eigen::Index(modes);
  field.points_mm.resize(3, Eigen::Index(points));
  file.take(field.points_mm.data(), 3 * points);
  field.is_moved = file.takeMany<std::uint8_t>(points);
  field.samples_mm.resize(3, Eigen::Index(samples));
  file.take(field.samples_mm.data(), 3 * samples);
  field.intake = file.takeMany<float>(3 * samples * modes);
  field.shapes = file.takeMany<std::int16_t>(std::uint64_t(paddedRows(Eigen::Index(points))) * modes);
  const std::size_t content = file.at();
  if (file.number() != checksum(bytes.substr(0, content)) || file.at() != bytes.size()) file.refuse();
  return field;
}

}  // namespace facenav::efield
