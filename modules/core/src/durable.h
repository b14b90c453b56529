#pragma once
// What whole files and whole folders share: names beside the place, and the sync to the disk.

#include <filesystem>
#include <string>

namespace facenav {
inline namespace core {

/// The folder that `path` lies in; "." for a bare name.
std::filesystem::path parentOf(const std::filesystem::path& path);
/// A hidden name beside `path`, of this process alone. It keeps everything after the first dot, since writers
/// choose the format by extension. Throws Error where the parent folder is missing or not writable.
std::filesystem::path temporaryBeside(const std::filesystem::path& path);
/// Throws Error("cannot be written (<errno>)", path, remedy).
[[noreturn]] void refuseWriting(const std::filesystem::path& path);
/// fsync of one file. Throws Error.
void syncFile(const std::filesystem::path& path);
/// The names in `folder`. File systems that cannot sync a folder, and folders that may not be read, are let
/// pass: the rename has been made. Throws Error on an input/output error.
void syncNamesIn(const std::filesystem::path& folder);
/// All files and folders in `folder`; where they are many, the whole file system at once, which is faster
/// than one fsync each. Throws Error.
void syncAllIn(const std::filesystem::path& folder);

}  // namespace core
}  // namespace facenav
