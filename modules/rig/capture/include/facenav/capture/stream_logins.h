#pragma once
// StreamLogins: passwords of cameras' addresses ("rtsp://doe:secret@host/left"). They lie in one file of the
// user's configuration folder, for its owner alone (0600): stream_logins.json, address as shown -> as typed.
// Everything else has the address as shown (core/shown_address.h): identities, rigs, settings, messages.

#include <filesystem>
#include <string>

#include "facenav/capture/camera.h"

namespace facenav::capture {

/// Identity of a stream, by the address as typed. Its password is in `full_address` alone.
CameraIdentity streamIdentity(const std::string& typed);

class StreamLogins {
 public:
  /// The file need not exist yet. Empty: stream_logins.json in the user's configuration folder.
  explicit StreamLogins(std::filesystem::path file = {}) : given_(std::move(file)) {}
  /// Keeps the password of an address, in place of an earlier one. An address without one changes nothing.
  /// Throws Error if the file is damaged or cannot be written, or the user has no home folder.
  void keep(const CameraIdentity& camera) const;
  /// The address that opens this camera: with the password that was typed, else the kept one, else as it is.
  /// Throws Error as keep(), if the address has a user's name or a query.
  std::string openingAddress(const CameraIdentity& camera) const;

 private:
  std::filesystem::path file() const;
  std::filesystem::path given_;
};

/// Keeps the password of an address as typed, and returns the address as shown: what a window may display and
/// store. Other text is returned as it is. Throws Error as StreamLogins::keep.
std::string keptApart(const std::string& typed);

}  // namespace facenav::capture
