#include "facenav/treat/treatment.h"

#include "facenav/capture/returning_cameras.h"
#include "facenav/casefile/case_coil.h"
#include "facenav/casefile/face_looks.h"
#include "facenav/coil_tracking/coil_card.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/without_folders.h"
#include "facenav/plan/expert_pose.h"
#include "facenav/prepare/sign_off_gate.h"

namespace facenav::steps {
namespace {

/// Reads key frames of the face from earlier sessions. Empty if a file is damaged: the session runs without
/// them.
std::vector<casefile::StoredKeyFrame> storedKeyFrames(const std::filesystem::path& case_folder) {
  try {
    return casefile::readKeyFrames(case_folder);
  } catch (const Error& error) {
    logWarning(error.what());
    return {};
  }
}

void keepKeyFrames(const session::Session& session, const std::filesystem::path& case_folder) {
  try {
    casefile::addKeyFrames(case_folder, session.learntKeyFrames());
  } catch (const std::exception& error) {  // no caller to report to
    logWarning(std::string("the looks of the face were not kept: ") + error.what());
  }
}

/// Reads the protocol. Nothing if there is none or it cannot be read; the session then has no goal, which is
/// logged.
std::optional<casefile::Protocol> protocolFor(const std::filesystem::path& case_folder,
                                              session::TreatmentLog& log) {
  try {
    auto protocol = casefile::protocolOf(case_folder);
    if (protocol)
      log.addEvent("protocol", protocol->name + formatted(", version %d: %d pulses", protocol->version,
                                                          protocol->dose.pulses));
    return protocol;
  } catch (const Error& error) {
    log.addEvent("protocol", "cannot be read, no goal: " + withoutFolders(error.what()));
    return std::nullopt;
  }
}

void logStart(session::TreatmentLog& log, const TreatmentRequest& request, const guidance::Target* target) {
  if (const auto& given = request.override) log.addEvent("override", given->by + ": " + given->reason);
  log.addEvent("target", target ? target->name : "");
  log.addEvent("coil", request.coil.name);
  if (request.coil_reminder) log.addEvent("coil calibration", *request.coil_reminder);
  if (request.focus_caution) log.addEvent("coil focus", *request.focus_caution);
  if (!request.has_cameras)
    log.addEvent("tracker", "head and coil come from another tracker; its frame stands for the cameras'");
  else if (request.is_coil_served)
    log.addEvent("tracker", "the coil comes from another tracker");
  log.addEvent("alignment", alignmentWords(*request.alignment, target));
  for (const auto& caution : request.alignment->result.cautions)
    log.addEvent(report::session_events::kAlignmentCaution, caution);
}

/// True for a case with a brain; without one there is no field.
bool hasBrain(const casefile::CaseStore& store) {
  return std::filesystem::exists(store.folder() / "brain.vtp");
}

}  // namespace

TreatmentFilm openTreatmentFilm(const std::filesystem::path& folder) {
  TreatmentFilm film{capture::openRecording(folder), coil_tracking::defaultCoil(), {}};
  film.card.name = film.coil.name;
  const auto coil_file = folder / "coil.json";
  if (!std::filesystem::exists(coil_file)) return film;
  film.coil = coil_tracking::readCoil(coil_file);
  film.card = coil_tracking::readCoilCard(coil_file);
  return film;
}

PreparedTreatment prepareTreatment(const TreatmentRequest& request, const TreatmentDevices& devices) {
  FACENAV_EXPECT(request.alignment != nullptr, "a treatment needs an alignment");
  requireSignOff(request.store, request.override.has_value());
  session::NavigatorSetup setup;
  setup.rig = request.recording.rig;
  setup.reference = request.alignment->reference;
  setup.camera_T_mri_at_reference = request.alignment->result.camera_T_mri;
  setup.coil = request.coil;
  setup.scalp = request.alignment->scalp;
  setup.pace = head_tracking::Pace::live;
  setup.key_frames = storedKeyFrames(request.store.folder());
  setup.plate = casefile::coilOf(request.store.folder()).plate;
  setup.is_head_served = !request.has_cameras;
  setup.is_coil_served = request.is_coil_served;
  if (request.second) setup.second_coil = request.second->coil;
  PreparedTreatment prepared{request, devices.makeNavigator(setup), nullptr};
  FACENAV_EXPECT(prepared.navigator->hasSecondCoil() == request.second.has_value(),
                 "the navigator tracks the coils that were asked for");
  prepared.source =
      request.is_live ? capture::makeReturningCameras(devices.openSource) : devices.openSource();
  return prepared;
}

std::shared_ptr<PreparedTreatment> prepareTreatment(
    const TreatmentRequest& request,
    const std::function<std::unique_ptr<session::Navigator>(const session::NavigatorSetup&)>& makeNavigator,
    CameraTurnover& cameras) {
  // Shared, because a copy of the function reopens cameras that were away.
  const auto preview = std::make_shared<std::shared_ptr<const void>>(std::move(cameras.preview));
  const TreatmentDevices devices{
      makeNavigator, [preview, open = cameras.open, is_live = request.is_live, film = request.recording] {
        preview->reset();  // first, because a camera can be opened only once
        return is_live ? open() : capture::makeSource(film);
      }};
  return std::make_shared<PreparedTreatment>(prepareTreatment(request, devices));
}

std::string alignmentWords(const AlignmentOutcome& alignment, const guidance::Target* target) {
  const bool is_stated = alignment.result.points == 0 && alignment.result.inlier_fraction > 0;
  const double rms_mm = alignment.result.rms_mm;
  const int points = int(alignment.result.points);
  const double bound_mm = target ? alignment.errorBound_mm(*target) : 0.0;
  if (!(bound_mm > 0))  // whole sentences, since the window translates them whole
    return is_stated ? std::string("aligned: by a file that states its error")
                     : formatted("aligned: %.2f mm rms over %d points", rms_mm, points);
  const std::string fit = is_stated ? std::string("by a file that states its error")
                                    : formatted("%.2f mm rms over %d points", rms_mm, points);
  return formatted("aligned: 95 %% within %.1f mm at ", bound_mm) + target->name + " (" + fit + ")";
}

session::ChosenTarget chosenTarget(const guidance::Target& target, const AlignmentOutcome* alignment) {
  if (!alignment) return {target};
  return {target, alignment->predictedError_mm(target), alignment->errorBound_mm(target)};
}

Treatment::Treatment(PreparedTreatment prepared, const std::optional<session::ChosenTarget>& target)
    : case_folder_(prepared.request.store.folder()),
      rig_(prepared.request.recording.rig),
      coil_(prepared.request.coil),
      second_(prepared.request.second),
      coil_of_source_(prepared.request.coil_of_source),
      has_cameras_(prepared.request.has_cameras),
      keepLearnt_(prepared.request.keepLearnt),
      alignment_(prepared.request.alignment) {
  prepared.navigator->setTarget(target);
  if (second_) prepared.navigator->setSecondTarget(second_->target);
  session::SessionOptions options;
  options.is_paced = !prepared.request.is_live;
  options.speed = prepared.request.speed;
  session_ =
      std::make_shared<session::Session>(std::move(prepared.source), std::move(prepared.navigator), options);
  const auto& goes_on = prepared.request.goes_on;
  log_ =
      std::make_unique<session::TreatmentLog>(session_, case_folder_, alignment_->scalp, logOptions(goes_on));
  if (!goes_on.empty() || prepared.request.is_checked_first) session_->checkRegistration(true);
  session_folder_ = log_->folder();
  if (hasBrain(prepared.request.store))
    fields_ = std::make_unique<PulseFieldKeeper>(prepared.request.store, session_folder_,
                                                 prepared.request.field_coil);
  logStart(*log_, prepared.request, target ? &target->target : nullptr);
  protocol_ = protocolFor(case_folder_, *log_);
  plan(target ? &target->target : nullptr);
  if (target) target_ = target->target;
  noteOtherCoil();
  noteSecond();
  keyboard_.start(listenerFor(keyboard_.name()));
  session_->start();
}

session::TreatmentLogOptions Treatment::logOptions(const std::filesystem::path& goes_on) {
  session::TreatmentLogOptions options{has_cameras_ ? std::optional(rig_) : std::nullopt, goes_on};
  options.placed = [this](const casefile::Pulse& pulse) {  // only once fields_ is there, if it ever is
    if (fields_) fields_->add(pulse);
  };
  return options;
}

links::PulseListener Treatment::listenerFor(const std::string& source) {
  session::TreatmentLog* log = log_.get();
  return {[this, log](links::PulseTrigger trigger) {
            const double set_pct = intensity_pct_;
            if (!trigger.intensity_pct && set_pct >= 0) trigger.intensity_pct = set_pct;
            if (second_ && trigger.coil.empty()) trigger.coil = coilOf(trigger.source);
            log->addPulse(trigger);
            if (const auto outputs = std::atomic_load(&outputs_)) outputs->publish(trigger);
          },
          [log, source](const std::string& words) {
            log->addEvent(report::session_events::kSource,
                          source + ": " + (words.empty() ? "works again" : words));
          }};
}

void Treatment::listen(std::unique_ptr<links::PulseSource> source) {
  source->start(listenerFor(source->name()));
  log_->addEvent(report::session_events::kSource, source->name() + ": listening");
  sources_.push_back(std::move(source));
}

std::optional<std::string> Treatment::tryToListen(const std::string& source) {
  try {
    listen(links::openPulseSource(source));
    return std::nullopt;
  } catch (const Error& error) {
    log_->addEvent(report::session_events::kSource, withoutFolders(error.what()));
    return error.what();
  }
}

void Treatment::sendTo(std::shared_ptr<LiveOutputs> outputs) {
  std::atomic_store(&outputs_, outputs);
  session_->follow(outputs ? [outputs](const session::NavigationState& state) { outputs->publish(state); }
                           : std::function<void(const session::NavigationState&)>());
}

/// Sets the plan; the target's own dose has priority.
void Treatment::plan(const guidance::Target* target) {
  planned_pulses_.reset();
  auto plan = protocol_;
  if (target && target->dose) plan = casefile::Protocol{target->name, 1, *target->dose, {}, {}};
  if (!plan) return;
  planned_pulses_ = plan->dose.pulses;
  try {  // the session's own copy, with which the report compares
    casefile::writeProtocol(*plan, session_folder_ / "protocol.json", FileAccess::owner_only);
  } catch (const Error& error) {
    log_->addEvent("protocol", "its copy is not kept: " + withoutFolders(error.what()));
  }
}

void Treatment::stopListening() {
  for (const auto& source : sources_)
    log_->addEvent(report::session_events::kSource, source->name() + ": no longer listened to");
  sources_.clear();
}

void Treatment::setIntensity(std::optional<double> intensity_pct) {
  intensity_pct_ = intensity_pct.value_or(-1);
}

Treatment::~Treatment() { end("the program was closed"); }

void Treatment::chooseTarget(const std::optional<session::ChosenTarget>& target, const std::string& name) {
  session_->setTarget(target);
  log_->addEvent("target", name);
  plan(target ? &target->target : nullptr);
  target_ = target ? std::optional(target->target) : std::nullopt;
  noteOtherCoil();
}

void Treatment::chooseTargetNamed(const std::string& name) {
  const auto target = casefile::CaseStore::open(case_folder_).targets().find(name);
  chooseTarget(chosenTarget(target, alignment_.get()), name);
}

void Treatment::chooseCoil(const coil_tracking::CoilModel& coil) {
  if (coil.name == coil_.name) return;
  coil_tracking::requireOwnMarker(coil, coil_);
  if (second_) coil_tracking::requireTellable(coil, second_->coil);
  coil_ = coil;
  session_->setCoil(coil);
  log_->addEvent("coil", coil.name);
  noteOtherCoil();
}

/// Logs a caution if the target's pose is an expert's with another coil: it is right only for that coil.
void Treatment::noteOtherCoil() {
  if (!target_) return;
  if (const auto caution = otherCoilCaution(*target_, coil_.name)) log_->addEvent("other coil", *caution);
}

/// Logs the second coil, its target and which source belongs to which coil.
void Treatment::noteSecond() {
  if (!second_) return;
  log_->addEvent("second coil", second_->coil.name);
  log_->addEvent("second target", second_->target ? second_->target->target.name : "");
  for (const auto& [source, coil] : coil_of_source_)
    log_->addEvent("coil of the pulses", (source.empty() ? "every other source" : source) + ": " + coil);
}

/// Name of the coil that a source's pulses are given with; empty: it is not known.
std::string Treatment::coilOf(const std::string& source) const {
  for (const auto& word : {source, std::string()})
    if (const auto found = coil_of_source_.find(word); found != coil_of_source_.end()) return found->second;
  return {};
}

void Treatment::chooseSecondTarget(const std::optional<session::ChosenTarget>& target,
                                   const std::string& name) {
  FACENAV_EXPECT(second_.has_value(), "there is a second coil");
  second_->target = target;
  session_->setSecondTarget(target);
  log_->addEvent("second target", name);
}

void Treatment::chooseSecondTargetNamed(const std::string& name) {
  const auto target = casefile::CaseStore::open(case_folder_).targets().find(name);
  chooseSecondTarget(chosenTarget(target, alignment_.get()), name);
}

void Treatment::checkRegistration() { session_->checkRegistration(); }

void Treatment::judgeTip(TipVerdict verdict, const guidance::TipReading& reading) {
  log_->addEvent(report::session_events::kTip, inWords(verdict, reading));
  if (verdict != TipVerdict::wrong) return;
  session_->judgeAlignment(true);
  try {  // so that no later session starts with it
    casefile::setAlignmentAside(case_folder_);
  } catch (const Error& error) {
    logWarning(error.what());
  }
}

std::shared_ptr<const guidance::TipCheck> Treatment::makeTipCheck() const {
  return seeAlignment(casefile::CaseStore::open(case_folder_), *alignment_).check;
}

/// True if a check is due, also if the last one could not measure enough.
bool Treatment::isCheckDue() {
  const auto finding = session_->latest()->check;
  if (finding && finding->number != last_check_) {
    last_check_ = finding->number;
    if (finding->measurements > 0) checked_ = Timestamp::now();
  }
  return Timestamp::now() - checked_ > 60 * settingsOf<monitoring::RegistrationCheckRules>().ask_after_min;
}

void Treatment::end(const std::string& why) {
  if (!session_) return;
  log_->endWith(why);
  keyboard_.stop();
  sources_.clear();
  const CamerasLearnt learnt = learntOf(*session_->latest(), rig_);
  session_->stop();
  try {  // log and cameras are released even if the disk fails
    if (keepLearnt_ && !learnt.isEmpty()) keepLearnt_(learnt);
  } catch (const std::exception& error) {
    logWarning(std::string("what was learnt of the cameras was not kept: ") + error.what());
  }
  keepKeyFrames(*session_, case_folder_);
  log_.reset();  // before the session, which its thread reads
  fields_.reset();
  session_.reset();
}

void Treatment::keepReport(const report::ReportOptions& options) const {
  try {
    report::writeSessionReport(case_folder_, session_folder_, options);
  } catch (const std::exception& error) {  // no caller to report to
    logWarning(std::string("the session's report was not written: ") + error.what());
  }
}

}  // namespace facenav::steps
