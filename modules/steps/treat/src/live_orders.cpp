#include "facenav/treat/live_orders.h"

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/plain_words.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/links/pulse_dead_times.h"

namespace facenav::steps {
namespace {

constexpr std::size_t kMostWaiting = 256, kMostNames = 100;
constexpr double kJudgeAgain_s = 1.0;

bool isSame(const links::LiveOrder& a, const links::LiveOrder& b) {
  return a.pose == b.pose && a.place_mm == b.place_mm;
}

std::string obeyed(const links::LiveOrder& order, Treatment& treatment) {
  if (order.name == "stop") {
    treatment.pause("stopped by " + order.from);
    return "the session is paused";
  }
  if (order.name == "start") {
    if (!treatment.isPaused()) return "the session was not paused";
    treatment.resume();
    return "the session goes on";
  }
  treatment.takePulse(pulseOf(order));
  return "a pulse was given";
}

std::string placeWords(const interop::Item& judged) {
  if (!judged.mri_T_coil && !judged.mri_place) return {};
  const Eigen::Vector3d p_mm = judged.mri_T_coil ? judged.mri_T_coil->translation_mm() : judged.mri_place->mm;
  return formatted(" at (%.1f, %.1f, %.1f) mm", p_mm.x(), p_mm.y(), p_mm.z());
}

}  // namespace

links::PulseTrigger pulseOf(const links::LiveOrder& order) {
  links::PulseTrigger pulse;
  pulse.source = kOrderSource;
  const double age_s = pulse.at - order.arrived;
  pulse.at = order.arrived;
  pulse.utc -=
      std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::duration<double>(age_s));
  pulse.dead_time_s = settingsOf<links::PulseDeadTimes>().network_dead_s;
  pulse.coil = order.coil;
  return pulse;
}

std::string OfferedTarget::refusal() const {
  if (preview.items.empty()) return "nothing was sent";
  const auto& item = preview.items.front();
  if (item.fate == ItemFate::added) return {};
  if (item.fate == ItemFate::unchanged) return "the case has this target already";
  return item.reason.empty() ? "no pose" : item.reason;
}

links::LiveIncoming LiveOrders::incoming(bool takes_commands, bool takes_targets) {
  return {takes_commands, takes_targets, [this](const links::LiveOrder& order) { note(order); }};
}

void LiveOrders::note(const links::LiveOrder& order) {
  std::lock_guard lock(mutex_);
  if (orders_.size() < kMostWaiting) orders_.push_back(order);
}

OrderNews LiveOrders::judge(const links::LiveOrder& order, const OrderReceiver& receiver,
                            const casefile::CaseStore* store) {
  const std::string who = "target '" + order.name + "' from " + order.from;
  if (!store) return {who + ": not taken: there is no case that it could belong to", {}};
  OfferedTarget offer;
  offer.from = order.from;
  offer.origin.file = "OpenIGTLink " + order.from;
  interop::OtherFile sent;
  sent.format = "openigtlink";
  sent.words = "sent by OpenIGTLink";
  interop::Item item;
  item.kind = order.pose ? interop::Kind::target : interop::Kind::landmark;
  item.name = order.name;
  item.where = order.from;
  if (order.pose && order.pose->isIdentity(1e-6))
    item.reason = "it is the identity: nobody has placed it";
  else
    item.pose = order.pose;
  item.place_mm = order.place_mm;
  sent.items.push_back(item);
  offer.preview = previewItems(*store, headOf(*store), offer.origin, std::move(sent));
  const std::string refusal = offer.refusal();
  const std::string place = placeWords(offer.preview.items.front().item);
  const bool is_offered = refusal.empty();
  const std::string words =
      who + place + (is_offered ? ": offered; the chosen target is as before" : ": not taken: " + refusal);
  if (receiver.note) receiver.note(is_offered ? "target offered" : "target refused", words);
  offers_[order.name] = std::move(offer);
  return {words, is_offered ? order.name : std::string()};
}

/// Remembers the newest pose of each target that is sent.
void LiveOrders::collect(const links::LiveOrder& order) {
  if (!faultOfWords(order.name, kLongestName).empty()) return;  // its name cannot be shown
  if (sent_.size() >= kMostNames && sent_.count(order.name) == 0) return;
  auto& sent = sent_[order.name];
  sent.is_new = sent.is_new || !isSame(sent.order, order);
  sent.order = order;
}

std::vector<OrderNews> LiveOrders::obey(Treatment& treatment, const casefile::CaseStore& store) {
  return obey(
      {[&](const links::LiveOrder& order) { return obeyed(order, treatment); },
       [&](const std::string& event, const std::string& words) { treatment.log().addEvent(event, words); }},
      &store);
}

std::vector<OrderNews> LiveOrders::obey(const OrderReceiver& receiver, const casefile::CaseStore* store) {
  std::deque<links::LiveOrder> orders;
  {
    std::lock_guard lock(mutex_);
    orders.swap(orders_);
  }
  std::vector<OrderNews> news;
  for (const auto& order : orders) {
    if (order.kind != links::LiveOrder::Kind::command) {
      collect(order);
      continue;
    }
    news.push_back({"command " + order.name + " from " + order.from + ": " + receiver.obey(order), {}});
    if (receiver.note) receiver.note("command", news.back().words);
  }
  for (auto& [name, sent] : sent_) {
    if (!sent.is_new || (sent.judged.s > 0 && Timestamp::now() - sent.judged < kJudgeAgain_s)) continue;
    sent.is_new = false;
    sent.judged = Timestamp::now();
    news.push_back(judge(sent.order, receiver, store));
  }
  return news;
}

const interop::CaseHead& LiveOrders::headOf(const casefile::CaseStore& store) {
  if (!head_) head_ = caseHead(store);
  return *head_;
}

void LiveOrders::forget() {
  std::lock_guard lock(mutex_);
  orders_.clear();
  sent_.clear();
  offers_.clear();
  head_.reset();
}

void LiveOrders::take(const std::string& name, const casefile::CaseStore& store, const std::string& by,
                      const WritePlan& write) {
  const auto found = offers_.find(name);
  if (found == offers_.end()) throw Error("no target '" + name + "' is offered");
  const auto refusal = found->second.refusal();
  if (!refusal.empty()) throw Error("the target '" + name + "' cannot be taken: " + refusal);
  auto origin = found->second.origin;
  origin.by = by;
  interop::OtherFile sent = found->second.preview.file;
  sent.items = {found->second.preview.items.front().item};
  const auto again = previewItems(store, headOf(store), origin, sent);  // the plan may have changed since
  if (again.count(ItemFate::added) == 0) {
    const auto& item = again.items.front();
    throw Error("the target '" + name + "' cannot be taken now: " +
                (item.reason.empty() ? std::string("the case has it already") : item.reason));
  }
  if (write)
    importOthers(store, {{origin, again, {}}}, write);
  else
    importOther(store, origin, again);
  offers_.erase(name);
}

}  // namespace facenav::steps
