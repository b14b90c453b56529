#pragma once
// LiveOrders: what clients of the OpenIGTLink server ask of a running session (links/live_order.h), from the
// server's thread to the session's loop. "stop" begins a pause, "start" ends one, "pulse" reports a pulse.
// Targets are judged like those of a file (plan/import_other.h) and offered: no order chooses a target.

#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "facenav/links/live_order.h"
#include "facenav/plan/import_other.h"
#include "facenav/treat/treatment.h"

namespace facenav::steps {

/// Source of the pulses that clients report, in the log and for CoilOfSource.
constexpr const char* kOrderSource = "igtl";

/// A target that a client offers.
struct OfferedTarget {
  std::string from;  // "127.0.0.1:50112"
  OtherImport origin;
  ImportPreview preview;  // of this one item
  /// Why it cannot be taken; empty: it can.
  std::string refusal() const;
};

/// Tells people in one line what a client sent.
struct OrderNews {
  std::string words;
  std::string offered;  // name of a target that can be taken; empty: none
};

class LiveOrders {
 public:
  /// Says to the server what it may take; it hands orders to this object, which must outlive the server.
  links::LiveIncoming incoming(bool takes_commands, bool takes_targets);
  /// Obeys the commands that came since the last call, and judges new targets. A target that is sent again
  /// and again is judged at most once a second.
  std::vector<OrderNews> obey(Treatment& treatment, const casefile::CaseStore& store);
  /// Forgets offers and case: another case was opened.
  void forget();
  /// Adds an offered target to the case's plan. Throws Error: no such offer, or one that cannot be taken.
  void take(const std::string& name, const casefile::CaseStore& store, const std::string& by);
  const std::map<std::string, OfferedTarget>& offers() const { return offers_; }

 private:
  struct Sent {
    links::LiveOrder order;
    Timestamp judged;
    bool is_new = false;
  };
  void note(const links::LiveOrder& order);
  const interop::CaseHead& headOf(const casefile::CaseStore& store);
  OrderNews judge(const links::LiveOrder& order, Treatment& treatment, const casefile::CaseStore& store);

  std::mutex mutex_;
  std::deque<links::LiveOrder> orders_;  // guarded by the mutex
  // The next members belong to the session's loop.
  std::map<std::string, Sent> sent_;  // targets, by their names
  std::map<std::string, OfferedTarget> offers_;
  std::optional<interop::CaseHead> head_;  // of the session's case, made for the first target
};

}  // namespace facenav::steps
