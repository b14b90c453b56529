#pragma once
// LiveOrders: what clients of the OpenIGTLink server ask (links/live_order.h), from the server's thread to
// the loop of a session, of a window, or of a server alone. "stop" begins a pause, "start" ends one, "pulse"
// reports a pulse. Targets are judged like those of a file (plan/import_other.h) and offered: a person takes
// or refuses them, and no order chooses a target.

#include <deque>
#include <functional>
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

/// What stands behind the server: a session, or none.
struct OrderReceiver {
  /// Obeys a command. Returns what became of it: "the session is paused".
  std::function<std::string(const links::LiveOrder&)> obey;
  /// Notes an event in a log; null: there is none.
  std::function<void(const std::string& event, const std::string& words)> note = nullptr;
};

/// The pulse that a client reports.
links::PulseTrigger pulseOf(const links::LiveOrder& order);

class LiveOrders {
 public:
  /// Says to the server what it may take; it hands orders to this object, which must outlive the server.
  links::LiveIncoming incoming(bool takes_commands, bool takes_targets);
  /// Obeys the commands that came since the last call, and judges new targets. A target that is sent again
  /// and again is judged at most once a second.
  std::vector<OrderNews> obey(Treatment& treatment, const casefile::CaseStore& store);
  /// Does the same for any receiver. `store`: null if there is no case; targets are then refused.
  std::vector<OrderNews> obey(const OrderReceiver& receiver, const casefile::CaseStore* store);
  /// Forgets offers and case: another case was opened.
  void forget();
  /// Adds an offered target to the case's plan, stored by `write`; null: in the case. Throws Error: no such
  /// offer, or one that cannot be taken now.
  void take(const std::string& name, const casefile::CaseStore& store, const std::string& by,
            const WritePlan& write = nullptr);
  /// Forgets an offer. It returns only if the client sends another pose.
  void refuse(const std::string& name) { offers_.erase(name); }
  const std::map<std::string, OfferedTarget>& offers() const { return offers_; }

 private:
  struct Sent {
    links::LiveOrder order;
    Timestamp judged;
    bool is_new = false;
  };
  void note(const links::LiveOrder& order);
  const interop::CaseHead& headOf(const casefile::CaseStore& store);
  OrderNews judge(const links::LiveOrder& order, const OrderReceiver& receiver,
                  const casefile::CaseStore* store);
  void collect(const links::LiveOrder& order);

  std::mutex mutex_;
  std::deque<links::LiveOrder> orders_;  // guarded by the mutex
  // The next members belong to the session's loop.
  std::map<std::string, Sent> sent_;  // targets, by their names
  std::map<std::string, OfferedTarget> offers_;
  std::optional<interop::CaseHead> head_;  // of the case, made for the first target
};

}  // namespace facenav::steps
