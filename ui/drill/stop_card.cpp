#include "ui/drill/stop_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/device/homing_view.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

QString what_helps(const StorageFailure& f) {
  const QString where = isolate(QString::fromStdString(f.where)), reason = isolate(QString::fromStdString(f.detail));
  switch (f.code) {
    case StorageError::disk_full: return StopCard::tr("Free some space for %1.").arg(where);
    case StorageError::quota_exceeded: return StopCard::tr("Your quota is used up: free some space for %1.").arg(where);
    case StorageError::busy: return StopCard::tr("Close the program that holds %1.").arg(where);
    case StorageError::read_only: return StopCard::tr("Make %1 and its folder writable again.").arg(where);
    default:
      return f.detail.empty() ? StopCard::tr("Remove the cause at %1.").arg(where)
                              : StopCard::tr("Remove the cause at %1: %2.").arg(where, reason);
  }
}

}  // namespace

Message describe_refused_record(const StorageFailure& failure) { return {describe(failure).what, what_helps(failure)}; }

StopCard::StopCard(QWidget* parent) : QFrame(parent) {
  set_kind(this, "card");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(24), px(16), px(24), px(16));
  column->setSpacing(px(8));
  title_ = make_label({}, TextRole::live, Weight::bold);
  title_->setWordWrap(true);
  more_ = make_label({}, TextRole::body, Weight::regular, "text2");
  more_->setWordWrap(true);
  column->addWidget(title_);
  column->addWidget(more_);
  homing_ = new HomingView(this);
  homing_->hide();
  column->addWidget(homing_);
  auto* ways = new QHBoxLayout;
  leave_ = make_button(tr("Leave"), ButtonKind::standard);
  go_on_ = make_button(tr("Resume"), ButtonKind::standard, QStringLiteral("play"));
  finish_again_ = make_button(tr("Try again"), ButtonKind::standard);
  connect(leave_, &QPushButton::clicked, this, &StopCard::leave);
  connect(go_on_, &QPushButton::clicked, this, &StopCard::go_on);
  connect(finish_again_, &QPushButton::clicked, this, &StopCard::finish_again);
  ways->addStretch();
  ways->addWidget(leave_);
  ways->addWidget(go_on_);
  ways->addWidget(finish_again_);
  column->addLayout(ways);
  hide();
}

bool StopCard::show_stop(Stop stop, const Message& record, Fault fault) {
  const QString cause = stop == Stop::record || stop == Stop::record_at_end ? record.line() : QString();
  if (stop == stop_ && cause == cause_ && (stop != Stop::fault || fault == fault_)) return false;
  stop_ = stop;
  fault_ = fault;
  cause_ = cause;
  setVisible(stop != Stop::none);
  if (stop == Stop::none) return true;
  show_ways();
  QString title, more;
  switch (stop) {
    case Stop::none: break;
    case Stop::paused:
      title = tr("Paused");
      more = tr("The clock stands still. P resumes.");
      break;
    case Stop::fault: {
      const Message homing_text = describe(fault);
      title = homing_text.what;
      more = homing_text.more;
      break;
    }
    case Stop::device_gone:
      title = tr("The device does not answer");
      more = tr("The force is off and the clock stands still. Plug it in again where it was, then resume.");
      break;
    case Stop::handle_gone:
      title = tr("The handle of the device does not answer");
      more = tr("The force is off and the clock stands still. Switch the handle on again, then resume.");
      break;
    case Stop::device_back:
      title = tr("The device answers again");
      more = tr("The force is off and the clock stands still. Take the handpiece, then resume.");
      break;
    case Stop::silent:
      title = tr("The driver of the device stands still");
      more = tr("Unplug the device and plug it in again. What was drilled until then is kept.");
      break;
    case Stop::record:
      title = tr("The record cannot be written");
      more = tr("%1 What you drilled so far is kept while this window stays open. Resume then writes it and goes on.").arg(cause);
      break;
    case Stop::record_at_end:
      title = tr("The record cannot be written");
      more = tr("%1 What you drilled is kept while this window stays open. Try again then writes it and measures the tooth.").arg(cause);
      break;
    case Stop::behind:
      title = tr("This computer is too slow for the exercise");
      more = tr("The attempt ends here and is measured as it stands.");
      break;
    case Stop::undrawn:
      title = tr("The tooth cannot be drawn any more");
      more = tr("The force is off and the clock stands still. Leave, and start Cusp anew: an attempt that is kept then goes on from here.");
      break;
  }
  title_->setText(title);
  more_text_ = more;
  raise();
  announce(this, title + (title.endsWith(u'.') ? u" "_qs : u". "_qs) + more);  // with what to do next
  return true;
}

/// A session that is stopped can neither be resumed nor, while it is measured, be left. Without a tick it cannot be resumed.
void StopCard::show_ways() {
  const bool at_end = stop_ == Stop::record_at_end || stop_ == Stop::behind;
  leave_->setHidden(at_end);
  go_on_->setHidden(at_end || stop_ == Stop::silent || stop_ == Stop::undrawn);
  finish_again_->setVisible(stop_ == Stop::record_at_end);
  if (stop_ == Stop::record_at_end) finish_again_->setFocus();  // Finish had the keys, and is off
}

bool StopCard::show_falcon(const FalconView* view) {
  const bool wanted = view != nullptr && stop_ == Stop::device_gone;
  if (wanted) homing_->show_falcon(*view);
  const QString homing_text = wanted ? homing_->text() : QString();
  const QString which = wanted && view->by_port
                            ? tr("Plug in the same Falcon: it has no serial number of its own, and another one at its USB port would be taken for it.")
                            : QString();
  if (homing_text == homing_text_ && which == which_text_) return false;
  if (std::exchange(which_text_, which) != which && !which.isEmpty()) announce(this, which);
  homing_text_ = homing_text;
  homing_->setVisible(wanted);
  return true;
}

void StopCard::fit(QSize most) {
  const bool homing = !homing_text_.isEmpty();
  const auto high = [&] { return std::max(heightForWidth(most.width()), minimumSizeHint().height()); };
  const QString more = which_text_.isEmpty() ? more_text_ : more_text_ + u' ' + which_text_;
  more_->setText(more);
  homing_->setVisible(homing);
  int height = high();
  if (homing && height > most.height()) {
    homing_->hide();
    more_->setText(more + u'\n' + homing_text_);
    height = high();
  }
  resize(most.width(), height);
}

}  // namespace cusp::ui
