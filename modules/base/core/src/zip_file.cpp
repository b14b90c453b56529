#include "facenav/core/zip_file.h"

#include <zip.h>

#include <cstdint>
#include <memory>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav {
inline namespace core {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = std::uint64_t(8) << 30;  // limit of one entry, unpacked
constexpr double kMostDeflated = 1040;                        // deflate's limit is 1032
constexpr std::time_t kOneDate = 1704067200;  // 2024-01-01 for every entry: the archive reveals no date

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Archive = std::unique_ptr<zip_t, Discard>;
using Source = std::unique_ptr<zip_source_t, Discard>;

[[noreturn]] void refuseZip(const fs::path& path, const std::string& what) {
  throw Error("the archive cannot be read: " + what, path.string(), "copy or export the file again");
}

std::string wordsOf(zip_error_t& error) {
  std::string words = zip_error_strerror(&error);
  zip_error_fini(&error);
  return words;
}

/// An archive in memory. It keeps a reference to `source`.
Archive opened(zip_source_t* source, int flags, const fs::path& path) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_keep(source);
  Archive archive(zip_open_from_source(source, flags, &error));
  if (!archive) {
    zip_source_free(source);
    refuseZip(path, wordsOf(error));
  }
  zip_error_fini(&error);
  return archive;
}

Source bufferOf(const void* bytes, std::size_t size, const fs::path& path) {
  zip_error_t error;
  zip_error_init(&error);
  Source source(zip_source_buffer_create(bytes, size, 0, &error));
  if (!source) refuseZip(path, wordsOf(error));
  zip_error_fini(&error);
  return source;
}

void requireInside(const std::string& name, const fs::path& path) {
  const fs::path relative = fs::path(name).lexically_normal();
  if (relative.empty() || relative.is_absolute() || *relative.begin() == "..")
    refuseZip(path, "it holds a name that leads elsewhere");
}

std::string contentOf(zip_t* archive, const zip_stat_t& entry, const fs::path& path) {
  const std::string name = entry.name;
  if (entry.size > kMostBytes || double(entry.size) > kMostDeflated * double(entry.comp_size) + 64)
    refuseZip(path, "'" + name + "' is too large");
  const std::unique_ptr<zip_file_t, Discard> file(zip_fopen_index(archive, entry.index, 0));
  if (!file) refuseZip(path, "'" + name + "': " + zip_error_strerror(zip_get_error(archive)));
  std::string content(entry.size, '\0');
  char beyond = 0;  // the checksum is verified when a read goes past the end
  if (zip_fread(file.get(), content.data(), content.size()) != zip_int64_t(content.size()) ||
      zip_fread(file.get(), &beyond, 1) != 0)
    refuseZip(path, "'" + name + "' is damaged");
  return content;
}

void addTo(zip_t* archive, const std::string& name, const std::string& content, const fs::path& path) {
  Source source = bufferOf(content.data(), content.size(), path);
  const auto index = zip_file_add(archive, name.c_str(), source.get(), ZIP_FL_ENC_UTF_8);
  if (index < 0 || zip_file_set_mtime(archive, std::uint64_t(index), kOneDate, 0) != 0)
    throw Error("cannot be packed: " + std::string(zip_error_strerror(zip_get_error(archive))),
                path.string());
  source.release();  // the archive owns it now
}

/// Content written into `source`.
std::string writtenInto(zip_source_t* source, const fs::path& path) {
  zip_stat_t stat;
  std::string bytes;
  if (zip_source_stat(source, &stat) == 0 && zip_source_open(source) == 0) {
    bytes.resize(stat.size);
    const auto n = zip_source_read(source, bytes.data(), bytes.size());
    zip_source_close(source);
    if (n == zip_int64_t(bytes.size())) return bytes;
  }
  throw Error("cannot be packed: " + std::string(zip_error_strerror(zip_source_error(source))),
              path.string());
}

}  // namespace

namespace {

/// An archive that is read, with the bytes behind it.
struct Reading {
  std::unique_ptr<const std::string> bytes;  // never moves: the source points into it
  Source source;
  Archive archive;
};

Reading openedToRead(const fs::path& path) {
  Reading reading;
  reading.bytes = std::make_unique<const std::string>(readWholeFile(path));
  if (reading.bytes->empty()) refuseZip(path, "it is empty");
  reading.source = bufferOf(reading.bytes->data(), reading.bytes->size(), path);
  reading.archive = opened(reading.source.get(), ZIP_RDONLY, path);
  return reading;
}

/// Calls `visit` with each file of the archive.
template <class Visit>
void visitEntries(zip_t* archive, const fs::path& path, Visit visit) {
  const auto count = zip_get_num_entries(archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t entry;
    if (zip_stat_index(archive, zip_uint64_t(i), 0, &entry) != 0 || !(entry.valid & ZIP_STAT_SIZE))
      refuseZip(path, zip_error_strerror(zip_get_error(archive)));
    const std::string name = entry.name;
    requireInside(name, path);
    if (name.back() != '/') visit(entry);
  }
}

}  // namespace

ZipEntries readZip(const fs::path& path) {
  const auto reading = openedToRead(path);
  ZipEntries entries;
  visitEntries(reading.archive.get(), path, [&](const zip_stat_t& entry) {
    entries[entry.name] = contentOf(reading.archive.get(), entry, path);
  });
  return entries;
}

std::vector<std::string> zipNames(const fs::path& path) {
  const auto reading = openedToRead(path);
  std::vector<std::string> names;
  visitEntries(reading.archive.get(), path, [&](const zip_stat_t& entry) { names.push_back(entry.name); });
  return names;
}

std::string readZipEntry(const fs::path& path, const std::string& name, std::size_t most_bytes) {
  const auto reading = openedToRead(path);
  std::string content;
  bool is_found = false;
  visitEntries(reading.archive.get(), path, [&](const zip_stat_t& entry) {
    if (is_found || name != entry.name) return;
    if (entry.size > most_bytes) refuseZip(path, "'" + name + "' is too large");
    content = contentOf(reading.archive.get(), entry, path);
    is_found = true;
  });
  if (!is_found) refuseZip(path, "'" + name + "' is not in it");
  return content;
}

void writeZip(const ZipEntries& entries, const fs::path& path, FileAccess access) {
  const Source source = bufferOf(nullptr, 0, path);
  Archive archive = opened(source.get(), ZIP_CREATE | ZIP_TRUNCATE, path);
  for (const auto& [name, content] : entries) addTo(archive.get(), name, content, path);
  if (zip_close(archive.get()) != 0)
    throw Error("cannot be packed: " + std::string(zip_error_strerror(zip_get_error(archive.get()))),
                path.string());
  archive.release();  // closed: zip_close freed it
  writeWholeFile(path, writtenInto(source.get(), path), access);
}

}  // namespace core
}  // namespace facenav
