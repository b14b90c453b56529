#pragma once
// Changes settings during a test. A program fixes its settings before the first work and never changes them;
// only a test may.

#include "facenav/core/settings_in_force.h"

namespace facenav::testing {

/// Changes settings of one group and restores them at the end of the scope. Not for threads.
template <class Group>
class ChangedSettings {
 public:
  ChangedSettings() : kept_(settings_detail::values<Group>) {}
  ~ChangedSettings() { settings_detail::values<Group> = kept_; }
  ChangedSettings(const ChangedSettings&) = delete;
  ChangedSettings& operator=(const ChangedSettings&) = delete;
  Group* operator->() { return &settings_detail::values<Group>; }

 private:
  const Group kept_;
};

}  // namespace facenav::testing
