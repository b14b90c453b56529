#pragma once
// CameraBackend: one kind of camera connection. A new one is a file with a CameraBackend and a line in
// app/registrations.cpp; its cameras pass testing/support/camera_contract.h.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "facenav/capture/camera.h"
#include "facenav/core/registry.h"

namespace facenav::capture {

/// A camera that is connected now.
struct FoundCamera {
  enum class Use {
    free,
    in_use,         // by another program
    no_permission,  // this user may not open it
    no_answer,      // listed by the system, but it cannot be opened
  };
  CameraIdentity identity;
  Use use = Use::free;
  std::string user;  // program that uses it, if known: "cheese (process 4711)"
};

class CameraBackend {
 public:
  virtual ~CameraBackend() = default;
  /// Connected cameras, without starting them.
  virtual std::vector<FoundCamera> list() = 0;
  /// Opens a camera. Throws CameraError: missing, in_use, no_permission, refused.
  virtual std::unique_ptr<Camera> open(const CameraIdentity& camera) = 0;
  /// True if list() waits for answers from the network (a second).
  virtual bool isSlow() const { return false; }
};

using CameraBackends = Registry<CameraBackend>;

/// Backend for USB and other cameras of Video4Linux.
std::unique_ptr<CameraBackend> makeV4l2Backend();
/// Backend for GigE Vision and USB3 Vision cameras, through Aravis. Without Aravis in this build: lists none;
/// open() reports it.
std::unique_ptr<CameraBackend> makeGenicamBackend();
/// Backend for IEEE 1394 (FireWire) cameras, through libdc1394. Without it in this build: lists none; open()
/// reports it.
std::unique_ptr<CameraBackend> makeDc1394Backend();
/// Backend for videos and network streams (RTSP, HTTP, ..) through FFmpeg. list() is empty: an address opens
/// them. A folder of numbered pictures is a stream, too.
std::unique_ptr<CameraBackend> makeStreamBackend();

enum class Search { quick, everywhere };  // quick: without backends that ask the network
/// Cameras of all backends. A serial number that several equal cameras share is removed, because it
/// identifies none.
std::vector<FoundCamera> listCameras(const CameraBackends& backends, Search search = Search::everywhere);
/// The camera that `text` names: its stable name, address, serial number, "video2" or "2". An address with
/// "://" or the path of an existing file or folder (also file://..) is a stream. Throws CameraError: missing
/// (the message lists what is there), or if several cameras fit.
CameraIdentity findCamera(const std::vector<FoundCamera>& found, const std::string& text);
/// The connected camera that is `wanted`, with its current address. Throws CameraError missing; if an equal
/// model is connected (another serial number, another port), the message reports it.
CameraIdentity findCamera(const std::vector<FoundCamera>& found, const CameraIdentity& wanted);
std::unique_ptr<Camera> openCamera(const CameraBackends& backends, const CameraIdentity& camera);

/// Advice on what a user must know or do before two of these cameras can be used, most urgent first: "no
/// camera found: ..", "one camera only: ..", two equal ones without serial numbers, cameras in use by another
/// program. Empty if two cameras are free and distinguishable.
std::vector<std::string> adviceOn(const std::vector<FoundCamera>& found);
/// One line for a list: "HD Pro Webcam C920, serial number A1B2 (/dev/video2): in use by cheese (process
/// 4711)".
std::string inWords(const FoundCamera& camera);

}  // namespace facenav::capture
