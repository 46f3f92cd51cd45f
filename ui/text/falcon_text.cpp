#include "ui/text/falcon_text.h"

#include "ui/text/names.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

using falcon::Phase;
using falcon::Trouble;
using falcon::TrialEnd;

QString phase_text(const falcon::SessionState& state) {
  switch (state.phase) {
    case Phase::unplugged:
    case Phase::opening:
      if (state.trouble == Trouble::denied) return FalconText::tr("This user may not open it");
      if (state.trouble == Trouble::busy) return FalconText::tr("Another program holds it");
      return FalconText::tr("Looking for it");
    case Phase::settling:
    case Phase::probing: return FalconText::tr("Asking whether its firmware runs");
    case Phase::needs_image: return FalconText::tr("It needs its firmware file");
    case Phase::arming:
    case Phase::greeting:
    case Phase::locking: return FalconText::tr("Waking its loader");
    case Phase::uploading:
    case Phase::switching: {
      const double share = state.upload_size > 0 ? 100.0 * state.uploaded / state.upload_size : 100.0;
      return FalconText::tr("Loading its firmware, %1").arg(format({share, {}, QStringLiteral("%"), 0}));
    }
    case Phase::homing: return FalconText::tr("Finding its middle");
    case Phase::ready: return FalconText::tr("Ready");
    case Phase::silent: return FalconText::tr("No answer, force off");
    case Phase::failed: return FalconText::tr("Ten attempts failed; it is tried again");
  }
  return {};
}

QString help_text(const falcon::SessionState& state) {
  switch (state.phase) {
    case Phase::homing:
    case Phase::ready: return homing_text(state.homed);
    case Phase::needs_image: return FalconText::tr("Staff can name the file on the Device page, under Firmware.");
    case Phase::silent: return {};
    default: break;
  }
  switch (state.trouble) {
    case Trouble::none:
    case Trouble::absent: return {};
    case Trouble::denied: return FalconText::tr("The Device page shows the line that permits it.");
    case Trouble::busy: return FalconText::tr("Close the other program. The Falcon is then found by itself.");
    case Trouble::no_hello: return FalconText::tr("Most often its power adapter is off. Plug the adapter in.");
    case Trouble::no_lock:
    case Trouble::wrong_echo:
    case Trouble::no_echo:
    case Trouble::no_answer:
    case Trouble::link_failed:
    case Trouble::late_answers: break;
  }
  // A first attempt often fails; the next one mostly succeeds.
  if (state.phase != Phase::failed) return {};
  return FalconText::tr("Pull its power plug, wait five seconds, and put it in.");
}

QString homing_text(std::uint8_t homed) {
  if (homed == falcon::status::kHomed) return FalconText::tr("All three arms know their place.");
  return FalconText::tr("Pull the grip all the way out, then push it all the way in. Do it slowly, until all three arms are filled.");
}

Message describe_falcon(const PortFailure& f) {
  const QString detail = QString::fromStdString(f.detail);
  if (f.code == PortError::bad_file && detail == u"needs_image")
    return {FalconText::tr("The Falcon needs its firmware file."),
            FalconText::tr("Staff can name the file on the Device page, under Firmware.")};
  if (f.code == PortError::bad_file && detail == u"changed")
    return {FalconText::tr("The firmware file is not the one that was named."),
            FalconText::tr("%1 has changed since. Name it again if that was meant.").arg(isolate(QString::fromStdString(f.where)))};
  if (f.code == PortError::bad_file)
    return {FalconText::tr("The firmware file cannot be used."),
            FalconText::tr("Look at %1, or name another one.").arg(isolate(QString::fromStdString(f.where)))};
  if (detail == u"no_hello")
    return {FalconText::tr("The Falcon is plugged in and does not answer."),
            FalconText::tr("Most often its power adapter is off. Plug the adapter in, then try again.")};
  if (detail == u"late_answers")
    return {FalconText::tr("The Falcon answers too late."),
            FalconText::tr("Plug it into another USB socket of this computer, without a hub, then try again.")};
  if (f.code == PortError::io && !detail.isEmpty())
    return {FalconText::tr("The Falcon did not start."),
            FalconText::tr("Pull its power plug, wait five seconds, put it in, and try again. (%1)").arg(isolate(detail))};
  return describe(PortFailure{f.code, f.where.empty() ? "Falcon" : f.where, f.detail});  // the first one that is found has no name yet
}

Message describe_image(const falcon::ImageFailure& failure) {
  const QString what = FalconText::tr("This is no firmware of a Falcon.");
  const QString kept = FalconText::tr("The file that was named before is kept.");
  QString why;
  switch (failure.code) {
    case falcon::ImageError::unreadable: return {FalconText::tr("The file cannot be read."), kept};
    case falcon::ImageError::too_small: why = FalconText::tr("It is too small."); break;
    case falcon::ImageError::too_large: why = FalconText::tr("It is too large."); break;
    case falcon::ImageError::truncated: why = FalconText::tr("It breaks off."); break;
    default: why = FalconText::tr("It is built in another way."); break;
  }
  return {what, why + u' ' + kept};
}

QString end_text(TrialEnd end) {
  switch (end) {
    case TrialEnd::none:
    case TrialEnd::done: return {};
    case TrialEnd::stopped: return FalconText::tr("Stopped. Nothing was changed.");
    case TrialEnd::device_lost: return FalconText::tr("The Falcon stopped answering. Nothing was changed.");
    case TrialEnd::too_fast: return FalconText::tr("The grip moved too fast, so the force was switched off. Nothing was changed.");
    case TrialEnd::out_of_range: return FalconText::tr("The grip was held, or came to the end of its travel. Nothing was changed.");
  }
  return {};
}

QString way_text(falcon::ForceWay way) {
  switch (way) {
    case falcon::ForceWay::right: return FalconText::tr("It pushes to the right");
    case falcon::ForceWay::left: return FalconText::tr("It pushes to the left");
    case falcon::ForceWay::up: return FalconText::tr("It pushes up");
    case falcon::ForceWay::down: return FalconText::tr("It pushes down");
    case falcon::ForceWay::to_user: return FalconText::tr("It pushes towards you");
    case falcon::ForceWay::away: return FalconText::tr("It pushes away from you");
  }
  return {};
}

QString measured_text(const falcon::SelfTestResult& found, double stiffness_before, double stiffness_now) {
  const auto stiffness = [](double value) { return format({value, {}, QStringLiteral("N/mm"), 2}); };
  return FalconText::tr("Damping %1, friction %2, delay %3, step %4. Exercises may be as stiff as %5 (before: %6).")
      .arg(format({found.damping_ns_per_m().value_or(0.0), {}, QStringLiteral("N s/m"), 2}),
           format({found.friction_n().value_or(0.0), {}, QStringLiteral("N"), 2}),
           format({found.delay_ms().value_or(0.0), {}, QStringLiteral("ms"), 2}),
           format({found.encoder_mm().value_or(0.0), {}, QStringLiteral("mm"), 3}), stiffness(stiffness_now),
           stiffness(stiffness_before));
}

QString device_title(const std::string& kind, const std::string& name) {
  if (kind == "falcon") return (u"Falcon "_qs + isolate(QString::fromStdString(name))).trimmed();
  if (kind == "emulated-falcon") return FalconText::tr("Emulated Falcon, driven by mouse");
  return device_name(kind);
}

}  // namespace cusp::ui
