#include "ui/app/quick_start.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <algorithm>

#include "ui/text/language.h"
#include "ui/widgets/bar_top.h"
#include "ui/widgets/parts.h"

// Q_INIT_RESOURCE declares a function, which has to be a global one.
static void load_quick_start() { Q_INIT_RESOURCE(quick_start); }

namespace cusp::ui {
namespace {

constexpr int kPictureWidth = 352, kPictureHeight = 220;  // px at 100 %; the files hold 640 x 400
constexpr int kCardWidth = 400;                           // px at 100 %, with its margins and a gap
constexpr int kMostColumns = 3;

/// A picture of quick_start/THEME-LANGUAGE/, in English where there is none of the language.
QPixmap picture_of(const QString& file) {
  const QString path = u":/cusp/quick_start/%1-%2/%3.png"_qs, theme = tokens().dark ? u"dark"_qs : u"light"_qs;
  const QPixmap own(path.arg(theme, current_language(), file));
  return own.isNull() ? QPixmap(path.arg(theme, u"en"_qs, file)) : own;
}

/// Named after what it shows.
QLabel* make_picture(const QString& file, const QString& shows) {
  auto* label = new QLabel;
  QPixmap picture = picture_of(file);
  const qreal scale = label->devicePixelRatioF();
  picture = picture.scaled(QSize(px(kPictureWidth), px(kPictureHeight)) * scale, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  QPainter painter(&picture);
  painter.setPen(tokens().line);
  painter.drawRect(picture.rect().adjusted(0, 0, -1, -1));  // a white screen on a white card
  painter.end();
  picture.setDevicePixelRatio(scale);
  label->setPixmap(picture);
  label->setAccessibleName(shows);
  return label;
}

}  // namespace

QuickStart::QuickStart(QWidget* parent) : QWidget(parent) {
  load_quick_start();
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(0);
  const BarTop top = make_bar_top();
  QPushButton* back = add_way_back(top, tr("To the program"));
  connect(back, &QPushButton::clicked, this, &QuickStart::back_wanted);
  let_escape_go_back(back);
  top.row->addWidget(make_label(tr("Quick start"), TextRole::section, Weight::bold));
  top.row->addStretch();
  outer->addWidget(top.bar);
  QVBoxLayout* body = nullptr;
  QWidget* area = make_scroll_page(&body);
  area->setFocusPolicy(Qt::StrongFocus);  // its keys scroll: no control stands inside
  area->setAccessibleName(tr("Quick start"));
  outer->addWidget(area, 1);
  body->addWidget(new PageHead(tr("Five steps to the first report")));
  body->addWidget(make_label(tr("You find this page again under Help"), TextRole::body, Weight::regular, "text2"));
  grid_ = new QGridLayout;
  grid_->setSpacing(px(16));
  body->addLayout(grid_);
  body->addStretch();
  make_cards();
  setFocusProxy(back);
}

void QuickStart::make_cards() {
  const struct {
    QString file, title, does;
  } steps[] = {
      {u"people"_qs, tr("1. Make people"), tr("Under People, add students and instructors one by one, or import a list.")},
      {u"assign"_qs, tr("2. Assign an exercise"), tr("An instructor puts students together under Cohorts and assigns them an exercise.")},
      {u"drill"_qs, tr("3. Drill"), tr("A student signs in with number and PIN, starts the exercise and cuts with mouse or device.")},
      {u"report"_qs, tr("4. Read the report"), tr("Finish ends the attempt; the report shows the points and where each was lost.")},
      {u"backup"_qs, tr("5. Back up"), tr("Under Station, choose a folder on another disk: a backup a day goes there by itself.")},
  };
  for (const auto& step : steps) {
    auto* card = new Card(step.title);
    card->body()->addWidget(make_picture(step.file, step.title), 0, Qt::AlignLeading);
    QLabel* text = make_label(step.does);
    text->setWordWrap(true);
    card->body()->addWidget(text);
    card->body()->addStretch();
    cards_ += card;
  }
}

void QuickStart::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int columns = std::clamp(width() / px(kCardWidth), 1, kMostColumns);
  for (int i = 0; i < cards_.size(); ++i) grid_->addWidget(cards_[i], i / columns, i % columns);
}

}  // namespace cusp::ui
