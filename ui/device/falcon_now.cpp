#include "ui/device/falcon_now.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/device/panel_card.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr double kSlowAnswers = 950.0;
constexpr std::array<std::uint8_t, 4> kButtons = {falcon::status::kMinus, falcon::status::kForward, falcon::status::kCentre,
                                                  falcon::status::kPlus};

void set_text(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
}

}  // namespace

FalconNow::FalconNow(QWidget* parent) : QWidget(parent) {
  QVBoxLayout* column = make_column(this, 8);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(px(16));
  grid->setVerticalSpacing(px(8));
  int line = 0;
  const auto fact = [&](const QString& title) {
    QLabel* value = make_label(QStringLiteral("–"), TextRole::body, Weight::bold);
    value->setAccessibleDescription(title);
    grid->addWidget(make_label(title, TextRole::body, Weight::regular, "text2"), line, 0);
    grid->addWidget(value, line++, 1);
    return value;
  };
  rate_ = fact(tr("Answers a second"));
  late_ = fact(tr("Late: half of them, one in a hundred, the latest"));
  lost_ = fact(tr("Silences and lost answers"));
  grant_ = fact(tr("Priority"));
  grid->setColumnStretch(1, 1);
  column->addLayout(grid);
  auto* pads = new QHBoxLayout;
  pads->setSpacing(px(8));
  pads->addWidget(make_label(tr("Buttons"), TextRole::body, Weight::regular, "text2"));
  for (Chip*& button : buttons_) {
    button = new Chip;
    pads->addWidget(button);
  }
  pads->addStretch();
  column->addLayout(pads);
  auto* lights = new QHBoxLayout;
  lights->setSpacing(px(8));
  lights->addWidget(make_label(tr("Light"), TextRole::body, Weight::regular, "text2"));
  const std::pair<QString, std::uint8_t> colours[] = {{tr("Red"), falcon::control::kRed},
                                                      {tr("Green"), falcon::control::kGreen},
                                                      {tr("Blue"), falcon::control::kBlue}};
  for (const auto& [colour, bits] : colours) {
    QPushButton* light = make_button(colour, ButtonKind::quiet);
    connect(light, &QPushButton::clicked, this, [this, led = bits] { Q_EMIT light_wanted(led); });
    lights->addWidget(light);
  }
  lights->addStretch();
  column->addLayout(lights);
  show_bench({});
}

void FalconNow::show_bench(const BenchView& v) {
  if (v.phase == BenchPhase::running) {
    set_text(rate_, v.answers_per_s > 0 ? format_number(v.answers_per_s, 0) : QStringLiteral("–"));
    set_ink(rate_, v.answers_per_s > 0 && v.answers_per_s < kSlowAnswers ? "look" : "");
    const auto us = [](double value) { return format({value, {}, QStringLiteral("µs"), 0}); };
    set_text(late_, us(v.late_p50_us) + QStringLiteral(" · ") + us(v.late_p99_us) + QStringLiteral(" · ") + us(v.late_max_us));
    set_text(lost_, format_number(static_cast<double>(v.silences), 0) + QStringLiteral(" · ") +
                        format_number(static_cast<double>(v.lost_answers), 0));
    set_text(grant_, v.grant.realtime() ? tr("Before everything else") : tr("As any program: others may delay it"));
    set_ink(grant_, v.grant.realtime() ? "" : "look");
  }
  const QString names[] = {tr("Left"), tr("Top"), tr("Middle"), tr("Right")};
  for (std::size_t i = 0; i < buttons_.size(); ++i)
    buttons_[i]->set(names[i], (v.falcon.session.buttons & kButtons[i]) != 0 ? Chip::Kind::accent : Chip::Kind::plain);
}

}  // namespace cusp::ui
