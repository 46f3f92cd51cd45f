#include "ui/editor/publish_sheet.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <algorithm>

#include "ui/modules.h"
#include "ui/render/opengl_allowed.h"
#include "ui/text/names.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kWidth = 560, kMostListHeight = 168;  // px at 100 %; longer lists scroll
constexpr int kSide = 24, kLeastHeight = 96;        // px at 100 %; of all above the buttons
constexpr int kAroundTheText = 104;                 // px at 100 %, of margins and buttons

QLabel* line(const QString& text, const char* ink = "") {
  QLabel* label = make_label(text, TextRole::body, Weight::regular, ink);
  label->setWordWrap(true);
  return label;
}

/// Lines one below the other; they scroll if there are many.
QWidget* list_of(const QStringList& lines, const QString& name) {
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(px(12), 0, px(12), 0);
  column->setSpacing(px(4));
  for (const QString& text : lines) column->addWidget(line(text));
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setAccessibleName(name);
  area->setWidget(body);
  const int wanted = column->totalHeightForWidth(px(kWidth) - 2 * px(kSide)) + 2;
  area->setFixedHeight(std::min(wanted, px(kMostListHeight)));
  area->setFocusPolicy(wanted > px(kMostListHeight) ? Qt::StrongFocus : Qt::NoFocus);
  return area;
}

}  // namespace

PublishSheet::PublishSheet(PublishFacts facts, const QString& title, const Ports& ports, QWidget* parent)
    : QDialog(parent), facts_(std::move(facts)), ports_(ports) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Publish"));
  setAccessibleName(tr("Publish"));
  setFixedWidth(px(kWidth));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(kSide), px(kSide), px(kSide), px(kSide));
  outer->setSpacing(px(8));
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(8));
  auto* head = make_label(tr("Publish version %1 of %2?").arg(facts_.number).arg(isolate(title)), TextRole::section, Weight::bold);
  head->setWordWrap(true);
  column->addWidget(head);
  column->addWidget(line(tr("Students then drill this version. Earlier results keep the version they were made with."), "text2"));
  if (facts_.elsewhere) {
    auto* band = new Band;
    column->addWidget(band);
    band->show_message(Band::Kind::look, tr("Another window has published version %1.").arg(*facts_.since),
                       tr("Students then drill yours. Version %1 stays in the records.").arg(*facts_.since));
  }
  add_changes(*column);
  add_uses(*column);
  add_trial(*column);
  area_ = make_scrolling(body);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area_->setAccessibleName(head->text());
  outer->addWidget(area_, 1);
  add_buttons(*outer);
  fit_height();
}

/// As high as what it shows, where the screen has that much: Qt gives a dialog two thirds of the screen's height at most.
void PublishSheet::fit_height() {
  const int wanted = area_->widget()->layout()->totalHeightForWidth(px(kWidth) - 2 * px(kSide));
  const int room = most_of_screen(*this).height() - px(kAroundTheText);
  const int given = std::min(wanted, std::max(px(kLeastHeight), room));
  area_->setMinimumHeight(given);
  area_->setFocusPolicy(given < wanted ? Qt::StrongFocus : Qt::NoFocus);
}

void PublishSheet::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  fit_height();  // the theme's fonts are known only now
}

void PublishSheet::add_changes(QVBoxLayout& column) {
  column.addSpacing(px(8));
  const QString name = facts_.since ? tr("Changed since version %1").arg(*facts_.since) : tr("What changes");
  column.addWidget(make_label(name, TextRole::body, Weight::bold));
  if (!facts_.since) {
    column.addWidget(line(tr("No version of it is published now. Students find it as a new exercise.")));
  } else if (facts_.changes.isEmpty()) {
    column.addWidget(line(tr("Nothing.")));
  } else {
    column.addWidget(list_of(facts_.changes, name));
  }
}

void PublishSheet::add_uses(QVBoxLayout& column) {
  column.addSpacing(px(8));
  const QString name = tr("Open assignments of an older version");
  column.addWidget(make_label(name, TextRole::body, Weight::bold));
  if (facts_.uses.empty()) {
    column.addWidget(line(tr("None.")));
    return;
  }
  QStringList lines;
  for (const OlderUse& use : facts_.uses) {
    const QString due = use.due_utc_us ? tr("due %1").arg(format_day_time(local_time(*use.due_utc_us))) : tr("no due date");
    //: %1: a cohort, %2: practice or assessment, %3: number of a version, %4: "due Fri 4 Dec, 17:00"
    lines << tr("%1: %2, version %3, %4").arg(isolate(QString::fromStdString(use.cohort)), kind_name(use.kind), QString::number(use.version), due);
  }
  column.addWidget(list_of(lines, name));
  column.addWidget(line(tr("An assignment stays with its version. Assign version %1 to those cohorts anew.").arg(facts_.number), "text2"));
}

void PublishSheet::add_trial(QVBoxLayout& column) {
  column.addSpacing(px(8));
  auto* row = new QHBoxLayout;
  row->setSpacing(px(8));
  auto* sign = new QLabel;
  sign->setPixmap(icon_pixmap(facts_.tried ? u"check"_qs : u"warning"_qs, facts_.tried ? Ink::good : Ink::look, 18, devicePixelRatioF()));
  row->addWidget(sign);
  QString text = facts_.tried ? tr("It was tried out as it is now.") : tr("It was not tried out since it was opened or changed.");
  if (!facts_.tried && !opengl_allowed()) text += u' ' + ToothView::pictures_off();
  row->addWidget(line(text), 1);
  column.addLayout(row);
}

void PublishSheet::add_buttons(QVBoxLayout& column) {
  column.addSpacing(px(8));
  auto* row = new QHBoxLayout;
  row->addStretch();
  QPushButton* cancel = make_button(tr("Cancel"));
  cancel->setAutoDefault(false);
  row->addWidget(cancel);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  if (!facts_.tried) {
    try_ = make_button(tr("Try out"), ButtonKind::standard, u"hand"_qs);
    try_->setAutoDefault(false);
    try_->setEnabled(opengl_allowed());
    row->addWidget(try_);
    connect(try_, &QPushButton::clicked, this, [this] {
      reject();
      Q_EMIT try_out_wanted();
    });
  }
  publish_ = make_button(tr("Publish version %1").arg(facts_.number), ButtonKind::primary);
  publish_->setDefault(true);
  publish_->setFocus();
  row->addWidget(publish_);
  connect(publish_, &QPushButton::clicked, this, &PublishSheet::accept);
  column.addLayout(row);
}

void PublishSheet::accept() {
  const auto publish = [self = QPointer(this)](bool yes) {
    if (!self || !yes) return;
    self->QDialog::accept();
    Q_EMIT self->publish_wanted();
  };
  if (facts_.tried) return publish(true);
  ports_.ask(this, {tr("Publish it without trying it out?"), tr("Nobody has drilled it as it is now. Students would be the first."), tr("Publish untried")},
             publish);
}

}  // namespace cusp::ui
