#include "ui/device/falcon_text.h"

#include "ui/widgets/format.h"

namespace cusp::ui {

using falcon::Phase;
using falcon::TrialEnd;

QString phase_text(const falcon::SessionState& state) {
  switch (state.phase) {
    case Phase::unplugged:
    case Phase::opening: return FalconWords::tr("Looking for it");
    case Phase::settling:
    case Phase::probing: return FalconWords::tr("Asking whether its firmware runs");
    case Phase::needs_image: return FalconWords::tr("It needs its firmware file");
    case Phase::arming:
    case Phase::greeting:
    case Phase::locking: return FalconWords::tr("Waking its loader");
    case Phase::uploading:
    case Phase::switching: {
      const double share = state.upload_size > 0 ? 100.0 * state.uploaded / state.upload_size : 100.0;
      return FalconWords::tr("Loading its firmware, %1").arg(format({share, {}, QStringLiteral("%"), 0}));
    }
    case Phase::homing: return FalconWords::tr("Finding its middle");
    case Phase::ready: return FalconWords::tr("Ready");
    case Phase::silent: return FalconWords::tr("No answer, force off");
    case Phase::failed: return FalconWords::tr("Ten attempts failed; it is tried again");
  }
  return {};
}

QString homing_text(std::uint8_t homed) {
  if (homed == falcon::status::kHomed) return FalconWords::tr("All three arms know their place.");
  return FalconWords::tr("Pull the grip all the way out, then push it all the way in. Do it slowly, until all three arms are filled.");
}

Told tell_falcon(const PortFailure& f) {
  const QString detail = QString::fromStdString(f.detail);
  if (f.code == PortError::bad_file && detail == u"needs_image")
    return {FalconWords::tr("The Falcon needs its firmware file."),
            FalconWords::tr("Staff can name the file on the Device page, under Firmware.")};
  if (f.code == PortError::bad_file && detail == u"changed")
    return {FalconWords::tr("The firmware file is not the one that was named."),
            FalconWords::tr("%1 has changed since. Name it again if that was meant.").arg(isolate(QString::fromStdString(f.where)))};
  if (f.code == PortError::bad_file)
    return {FalconWords::tr("The firmware file cannot be used."),
            FalconWords::tr("Look at %1, or name another one.").arg(isolate(QString::fromStdString(f.where)))};
  if (detail == u"no_hello")
    return {FalconWords::tr("The Falcon is plugged in and does not answer."),
            FalconWords::tr("Most often its power adapter is off. Plug the adapter in, then try again.")};
  if (f.code == PortError::io && !detail.isEmpty())
    return {FalconWords::tr("The Falcon did not start."),
            FalconWords::tr("Pull its power plug, wait five seconds, put it in, and try again. (%1)").arg(isolate(detail))};
  return tell(f);
}

Told tell_image(const falcon::ImageFailure& failure) {
  const QString what = FalconWords::tr("This is no firmware of a Falcon.");
  const QString kept = FalconWords::tr("The file that was named before is kept.");
  QString why;
  switch (failure.code) {
    case falcon::ImageError::unreadable: return {FalconWords::tr("The file cannot be read."), kept};
    case falcon::ImageError::too_small: why = FalconWords::tr("It is too small."); break;
    case falcon::ImageError::too_large: why = FalconWords::tr("It is too large."); break;
    case falcon::ImageError::truncated: why = FalconWords::tr("It breaks off."); break;
    default: why = FalconWords::tr("It is built in another way."); break;
  }
  return {what, why + u' ' + kept};
}

QString end_text(TrialEnd end) {
  switch (end) {
    case TrialEnd::none:
    case TrialEnd::done: return {};
    case TrialEnd::stopped: return FalconWords::tr("Stopped. Nothing was changed.");
    case TrialEnd::device_lost: return FalconWords::tr("The Falcon stopped answering. Nothing was changed.");
    case TrialEnd::too_fast: return FalconWords::tr("The grip moved too fast, so the force was switched off. Nothing was changed.");
    case TrialEnd::out_of_range: return FalconWords::tr("The grip was held, or came to the end of its travel. Nothing was changed.");
  }
  return {};
}

QString device_title(const std::string& kind, const std::string& name) {
  if (kind == "falcon") return (u"Falcon "_qs + isolate(QString::fromStdString(name))).trimmed();
  if (kind == "emulated-falcon") return FalconWords::tr("Emulated Falcon, driven by mouse");
  return device_name(kind);
}

}  // namespace cusp::ui
