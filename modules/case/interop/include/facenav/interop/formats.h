#pragma once
// The formats of other programs by name: which there are, reading a file by its content (never by its
// ending), writing one. Text in, text out; who writes it to disk is the caller.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "facenav/interop/item.h"
#include "facenav/interop/t1.h"

namespace facenav::interop {

constexpr std::size_t kMostItems = 100000;            // of one file
constexpr std::size_t kLargestFile_bytes = 64 << 20;  // such files have some kB

/// File to be read.
struct Source {
  std::string content;         // without a byte order mark
  std::filesystem::path path;  // for messages, and for names and dates that stand in no other place
  const T1* t1 = nullptr;      // of the case, for formats whose coordinates need it
};

/// Several files by their names in a folder, with '/' between folders, and the folder's T1.
struct WrittenFolder {
  std::map<std::string, std::string> files;
  std::string t1_name;             // where the T1 belongs
  std::vector<std::string> notes;  // what the format could not hold
};

/// What is written. Items have mri_T_coil or mri_place set.
struct Order {
  std::vector<Item> items;
  T1 t1;
  std::string coil;      // its name; may be empty
  std::string software;  // "FaceNav 0.1.0"
  std::string utc;       // now, as 2026-11-23T14:05:09.123Z
  std::string subject;   // label of the person, of formats that need one: letters and digits
};

struct Written {
  std::string content;
  std::vector<std::string> notes;  // what the format could not hold
};

struct Format {
  std::string name, words, file_name;  // as in `--as`; one line; default name of a file
  bool holds_pulses = false;           // beside targets, or in their place
  std::function<bool(const std::string& content)> recognises;  // nothing: is not read
  std::function<OtherFile(const Source&)> read;
  std::function<Written(const Order&)> write;                    // nothing: is not written as one file
  std::function<WrittenFolder(const Order&)> write_folder = {};  // nothing: is not written as a folder
};

const std::vector<Format>& formats();
/// Throws Error with the names of all formats that are written.
const Format& writtenFormat(const std::string& name);
/// "brainsight, localite, ..": the names of all that are written.
std::string namesOfWritten();

/// Returns true if one of the formats recognises the content.
bool isKnown(const std::string& content);
/// Returns true if the file is an archive with a session or a data set of another program.
bool isSessionArchive(const std::filesystem::path& path);
/// Returns true if the folder is a session or a data set of another program, which is read as a whole.
bool isSessionFolder(const std::filesystem::path& path);
/// Reads a file of any known format, a folder of one session or data set, or such an archive. Throws Error
/// with one line: no such file, empty, too large, not recognised, damaged; a format that is known but not
/// read; several files, sessions or people to choose from.
OtherFile readOther(const std::filesystem::path& path, const T1* t1);
/// Reads content that is already in memory. Throws as readOther does.
OtherFile readOtherText(Source source);

}  // namespace facenav::interop
