#include "ui/drill/session_foot.h"

#include <QLabel>
#include <algorithm>

#include "ui/widgets/format.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

double picture_behind_s(const LiveView& live) noexcept { return std::max(0.0, live.seconds - live.shown_seconds); }

SessionNews session_news(const LiveView& live) noexcept {
  if (live.recording == RecordingState::failed) return SessionNews::failed;
  if (live.ring_warning) return SessionNews::too_slow;
  if (picture_behind_s(live) >= kPictureBehindS) return SessionNews::picture_behind;
  if (live.recording == RecordingState::behind) return SessionNews::disk_behind;
  return live.recording == RecordingState::off ? SessionNews::off : SessionNews::recording;
}

SessionFoot::SessionFoot() {
  setContentsMargins(px(16), px(10), px(16), px(10));
  setSpacing(px(8));
  icon_ = new QLabel;
  text_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  text_->setWordWrap(true);
  addWidget(icon_);
  addWidget(text_, 1);
}

QString SessionFoot::text() const { return text_->text(); }

void SessionFoot::show_values(const LiveView& live) {
  const SessionNews news = session_news(live);
  if (news == SessionNews::picture_behind) {
    const QString seconds = format({picture_behind_s(live), {}, QStringLiteral("s"), 0});
    text_->setText(tr("The picture is %1 behind the bur. Lift the bur and wait.").arg(seconds));
  }
  if (shown_ == news) return;
  shown_ = news;
  Ink ink = Ink::look;
  switch (news) {
    case SessionNews::failed:
      text_->setText(tr("The record cannot be written"));
      ink = Ink::bad;
      break;
    case SessionNews::too_slow:
      text_->setText(tr("This computer is too slow. Lift the bur and wait, or the attempt ends."));
      ink = Ink::bad;
      break;
    case SessionNews::picture_behind: break;
    case SessionNews::disk_behind: text_->setText(tr("Recording, not yet written to the disk")); break;
    case SessionNews::recording:
      text_->setText(tr("Recording, saved every second"));
      ink = Ink::text2;
      break;
    case SessionNews::off:
      text_->setText(tr("Nothing is kept"));
      ink = Ink::text2;
      break;
  }
  const QString icon = ink == Ink::text2 ? QStringLiteral("save") : QStringLiteral("warning");
  icon_->setPixmap(icon_pixmap(icon, ink, 16, icon_->devicePixelRatioF()));
  set_ink(text_, ink == Ink::bad ? "bad" : ink == Ink::look ? "look" : "text2");
  // The card over the view reads a failed record aloud.
  if (news == SessionNews::too_slow || news == SessionNews::picture_behind) announce(text_, text_->text());
}

}  // namespace cusp::ui
