#include "ui/signin/pin_field.h"

#include <QMouseEvent>
#include <QPainter>
#include <QValidator>
#include <algorithm>

#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kBoxWidth = 40, kBoxHeight = 44, kGap = 16;  // px at 100 %
constexpr double kDotRadius = 4.5;                         // px at 100 %, of the sign for a digit

/// Keeps the first six digits of the text. A shorter text is acceptable too: the sign-in page answers it with a sentence.
class SixDigits : public QValidator {
 public:
  using QValidator::QValidator;
  State validate(QString& text, int& cursor) const override {
    QString digits;
    for (const QChar c : text) {
      if (c.isDigit() && digits.size() < PinField::kDigits) digits += QChar(u'0' + c.digitValue());
    }
    if (digits.size() != text.size()) cursor = static_cast<int>(digits.size());
    text = digits;
    return Acceptable;
  }
};

}  // namespace

PinField::PinField(QWidget* parent) : QLineEdit(parent) {
  setProperty("kind", u"pin"_qs);
  setLayoutDirection(Qt::LeftToRight);
  setEchoMode(QLineEdit::Password);
  setInputMethodHints(Qt::ImhDigitsOnly | Qt::ImhSensitiveData);
  setValidator(new SixDigits(this));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(this, &QLineEdit::textEdited, this, [this] { refused_ = false; });
  connect(this, &QLineEdit::textChanged, this, [this](const QString& digits) {
    update();
    if (digits.size() == kDigits) Q_EMIT completed();
  });
  connect(this, &QLineEdit::selectionChanged, this, qOverload<>(&QWidget::update));
}

void PinField::show_refused() {
  refused_ = true;
  update();
}

QSize PinField::sizeHint() const { return {px(kDigits * kBoxWidth + (kDigits - 1) * kGap), px(kBoxHeight)}; }

void PinField::paintEvent(QPaintEvent*) {
  const Tokens& t = tokens();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto typed = static_cast<int>(text().size());
  const int next = hasFocus() && !hasSelectedText() ? std::min(cursorPosition(), kDigits - 1) : -1;
  for (int i = 0; i < kDigits; ++i) {
    const QRectF box(i * px(kBoxWidth + kGap), 0, px(kBoxWidth), px(kBoxHeight));
    const double frame = i == next ? px(2.0) : 1.0, inset = frame / 2;  // on whole pixels
    painter.setPen(QPen(refused_ ? t.bad : i == next ? t.accent : t.border, frame));
    painter.setBrush(i < typed && hasSelectedText() ? t.accent_soft : t.surface);
    painter.drawRoundedRect(box.adjusted(inset, inset, -inset, -inset), px(4.0), px(4.0));
    if (i >= typed) continue;
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.text);
    painter.drawEllipse(box.center(), px(kDotRadius), px(kDotRadius));
  }
}

void PinField::mousePressEvent(QMouseEvent* event) {
  // The hidden text of QLineEdit does not lie under the boxes, so a click means the end of what is typed.
  event->accept();
  deselect();
  setCursorPosition(static_cast<int>(text().size()));
}

}  // namespace cusp::ui
