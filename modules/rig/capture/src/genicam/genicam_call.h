#pragma once
// Ownership and errors of Aravis (GObject) in C++.

#include <arv.h>

#include <memory>
#include <string>

namespace facenav::capture {

struct GObjectRelease {
  void operator()(void* object) const { g_object_unref(object); }
};
template <class T>
using GObjectOwner = std::unique_ptr<T, GObjectRelease>;

/// Takes the error of one call: `GenicamCall call; arv_camera_get_gain(camera, call);`
class GenicamCall {
 public:
  GenicamCall() = default;
  ~GenicamCall() { g_clear_error(&error_); }
  GenicamCall(const GenicamCall&) = delete;
  GenicamCall& operator=(const GenicamCall&) = delete;
  operator GError**() {
    g_clear_error(&error_);
    return &error_;
  }
  bool isOk() const { return !error_; }
  std::string words() const { return error_ ? error_->message : ""; }

 private:
  GError* error_ = nullptr;
};

}  // namespace facenav::capture
