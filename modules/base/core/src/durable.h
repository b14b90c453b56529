#pragma once
// Code shared by whole files and whole folders: temporary names beside the destination, and the sync to the
// disk.

#include <filesystem>
#include <string>

namespace facenav {
inline namespace core {

/// The folder that contains `path`; "." for a bare name.
std::filesystem::path parentOf(const std::filesystem::path& path);
/// A hidden name beside `path` that no other process uses. It keeps everything after the first dot, since
/// writers choose the format by extension. Throws Error if the parent folder is missing or not writable.
std::filesystem::path temporaryBeside(const std::filesystem::path& path);
/// The place that a write to `path` fills: behind a link the file or folder that it leads to. Throws Error if
/// something is there that is neither a file nor a folder (a device, a pipe), if a link leads nowhere, or for
/// a path in /dev, /proc or /sys.
std::filesystem::path placeOf(const std::filesystem::path& path);
/// Gives the file or folder this mode. A file system that keeps no modes (a USB stick) is left as it is.
/// Throws Error.
void setMode(const std::filesystem::path& path, unsigned mode);
/// Throws Error("cannot be written (<errno>)", path, remedy).
[[noreturn]] void refuseWriting(const std::filesystem::path& path);
/// fsync of one file. Throws Error.
void syncFile(const std::filesystem::path& path);
/// Syncs the names in `folder`. Ignores file systems that cannot sync a folder and folders without read
/// permission, since the rename is already done. Throws Error on an input/output error.
void syncNamesIn(const std::filesystem::path& folder);
/// Syncs all files and folders in `folder`. Many files: syncs the whole file system at once, which is faster
/// than one fsync each. Throws Error.
void syncAllIn(const std::filesystem::path& folder);

}  // namespace core
}  // namespace facenav
