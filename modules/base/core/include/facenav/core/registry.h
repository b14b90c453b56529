#pragma once
// Registry<I>: the plug-in table of one interface (segmenters, head trackers, aligners, coil trackers, frame
// sources). app/registrations.cpp fills it explicitly, since a static library drops objects that register
// themselves. CLI help, settings and GUI list its entries.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {

template <class Interface>
class Registry {
 public:
  using Factory = std::function<std::unique_ptr<Interface>()>;
  struct Entry {
    std::string name, help;
    Factory factory;
  };

  /// `kind` is the name that users see ("head tracker"). The first entry added is the default.
  explicit Registry(std::string kind) : kind_(std::move(kind)) {}

  void add(std::string name, std::string help, Factory factory) {
    entries_.push_back({std::move(name), std::move(help), std::move(factory)});
  }
  const std::vector<Entry>& entries() const { return entries_; }
  const std::string& kind() const { return kind_; }
  const std::string& defaultName() const {
    FACENAV_EXPECT(!entries_.empty(), "no " + kind_ + " is registered");
    return entries_.front().name;
  }
  /// Creates a new instance. Throws Error for an unknown name; the message lists the known ones.
  std::unique_ptr<Interface> create(const std::string& name) const {
    std::string known;
    for (const auto& entry : entries_) {
      if (entry.name == name) return entry.factory();
      known += (known.empty() ? "" : ", ") + entry.name;
    }
    throw Error("unknown " + kind_ + " '" + name + "'", {}, "choose one of: " + known);
  }

 private:
  std::string kind_;
  std::vector<Entry> entries_;
};

}  // namespace core
}  // namespace facenav
