#include "ui/signin/pin_boxes.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpressionValidator>

#include "ui/widgets/theme.h"

namespace cusp::ui {

PinBoxes::PinBoxes(QWidget* parent) : QWidget(parent) {
  setLayoutDirection(Qt::LeftToRight);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(16));
  for (int i = 0; i < kDigits; ++i) {
    auto* box = new QLineEdit;
    box->setProperty("kind", u"pin"_qs);
    box->setMaxLength(1);
    box->setAlignment(Qt::AlignCenter);
    box->setEchoMode(QLineEdit::Password);
    box->setInputMethodHints(Qt::ImhDigitsOnly | Qt::ImhSensitiveData);
    box->setValidator(new QRegularExpressionValidator(QRegularExpression(u"[0-9]"_qs), box));
    box->setAccessibleName(tr("PIN, digit %1 of %2").arg(i + 1).arg(kDigits));
    box->setFixedSize(px(40), px(44));
    box->installEventFilter(this);
    connect(box, &QLineEdit::textEdited, this, [this, i](const QString& text) {
      Q_EMIT edited();
      if (text.isEmpty()) return;
      if (i + 1 < kDigits) {
        boxes_[i + 1]->setFocus();
        boxes_[i + 1]->selectAll();
      } else if (pin().size() == kDigits) {
        Q_EMIT completed();
      }
    });
    connect(box, &QLineEdit::returnPressed, this, &PinBoxes::accepted);
    boxes_ += box;
    row->addWidget(box);
  }
  setFocusProxy(boxes_.first());
}

QString PinBoxes::pin() const {
  QString text;
  for (const QLineEdit* box : boxes_) text += box->text();
  return text;
}

void PinBoxes::clear() {
  for (QLineEdit* box : boxes_) box->clear();
}

void PinBoxes::set_wrong(bool wrong) {
  for (QLineEdit* box : boxes_) {
    if (box->property("wrong").toBool() == wrong) continue;
    box->setProperty("wrong", wrong);
    set_kind(box, "pin");
  }
}

bool PinBoxes::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto at = boxes_.indexOf(qobject_cast<QLineEdit*>(watched));
  auto* key = static_cast<QKeyEvent*>(event);
  if (at < 0) return QWidget::eventFilter(watched, event);
  const auto move = [&](qsizetype to) {
    if (to < 0 || to >= kDigits) return false;
    boxes_[to]->setFocus();
    boxes_[to]->selectAll();
    return true;
  };
  if (key->key() == Qt::Key_Backspace && boxes_[at]->text().isEmpty() && at > 0) {
    boxes_[at - 1]->clear();
    Q_EMIT edited();
    return move(at - 1);
  }
  if (key->key() == Qt::Key_Left) return move(at - 1);
  if (key->key() == Qt::Key_Right) return move(at + 1);
  if (key->matches(QKeySequence::Paste)) {
    const QString pasted = QGuiApplication::clipboard()->text();
    qsizetype to = at;
    for (const QChar c : pasted) {
      if (!c.isDigit() || to >= kDigits) continue;
      boxes_[to++]->setText(QString(c));
    }
    move(std::min<qsizetype>(to, kDigits - 1));
    Q_EMIT edited();
    if (pin().size() == kDigits) Q_EMIT completed();
    return true;
  }
  // A digit over a full box replaces it.
  if (!key->text().isEmpty() && key->text().front().isDigit()) boxes_[at]->selectAll();
  return QWidget::eventFilter(watched, event);
}

}  // namespace cusp::ui
