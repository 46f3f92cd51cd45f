#include "ui/app/help_page.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

void add_keys(Card* card, const QVector<std::pair<QStringList, QString>>& keys) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(px(16));
  grid->setVerticalSpacing(px(8));
  int line = 0;
  for (const auto& [caps, what] : keys) {
    auto* row = new QHBoxLayout;
    row->setSpacing(px(4));
    for (const QString& cap : caps) row->addWidget(make_key_cap(cap), 0, Qt::AlignVCenter);
    row->addStretch();
    grid->addLayout(row, line, 0);
    QLabel* text = make_label(what, TextRole::body, Weight::regular, "text2");
    text->setWordWrap(true);
    grid->addWidget(text, line++, 1);
  }
  grid->setColumnMinimumWidth(0, px(150));
  grid->setColumnStretch(1, 1);
  card->body()->addLayout(grid);
}

void add_line(Card* card, QLabel* line) {
  line->setWordWrap(true);
  card->body()->addWidget(line);
}

}  // namespace

HelpPage::HelpPage(Role role, QWidget* parent) : QWidget(parent) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* body = nullptr;
  QWidget* area = make_scroll_page(&body);
  area->setFocusPolicy(Qt::StrongFocus);  // its keys scroll: a student's page has no control inside
  area->setAccessibleName(tr("Help"));
  outer->addWidget(area);
  setFocusProxy(area);
  auto* head = new PageHead(tr("Help"));
  body->addWidget(head);
  if (role != Role::student) {
    QPushButton* quick = make_button(tr("Quick start in five pictures"), ButtonKind::standard, u"play"_qs);
    head->buttons()->addWidget(quick);
    connect(quick, &QPushButton::clicked, this, &HelpPage::quick_start_wanted);
  }

  auto* attempt = new Card(tr("An attempt, from start to report"));
  for (const QString& line :
       {tr("1. Choose an exercise and read its briefing: what to remove, how deep, and what earns points."),
        tr("2. Slide the bur over the tooth with the mouse or the arrow keys. Push with the wheel or Page Down. The bar at "
           "the right shows the force, the bar at the left the depth."),
        tr("3. Hold Space or the left button to cut. The target is the solid line, the tolerance zone round it the dashed one."),
        tr("4. Finish ends the attempt and grades it. The report shows what was measured, how well it is known, and what to do "
           "next time."),
        role == Role::student ? tr("5. Every attempt stays under My results. An attempt that broke off is kept up to its last second.")
                              : tr("5. Every attempt stays under Performance. An attempt that broke off is kept up to its last second.")}) {
    add_line(attempt, make_label(line));
  }
  body->addWidget(attempt);

  body->addLayout(make_keys());

  auto* marking = new Card(tr("How it is marked"));
  for (const QString& line :
       {tr("Target removed: how much of the required cavity is cut. Not removed: what remains of it."),
        tr("Over-cut: what is removed outside the target. Within the tolerance zone it costs little, beyond it much."),
        tr("± shows how well a figure is known. If an edge of the marking is nearer than that, the report shows it."),
        tr("Time earns points only in an exercise whose briefing lists it under What earns points.")}) {
    add_line(marking, make_label(line, TextRole::body, Weight::regular, "text2"));
  }
  body->addWidget(marking);
  body->addStretch();
}

/// Every key: anywhere, and while drilling.
QHBoxLayout* HelpPage::make_keys() {
  auto* row = new QHBoxLayout;
  row->setSpacing(px(16));
  const QString ctrl = tr("Ctrl");
  auto* everywhere = new Card(tr("Keys everywhere"));
  add_keys(everywhere, {{{u"F1"_qs}, tr("this page")},
                        {{u"F6"_qs}, tr("next pane")},
                        {{ctrl, u"K"_qs}, tr("go to any page or exercise")},
                        {{u"Alt"_qs, u"←"_qs}, tr("back")},
                        {{u"Esc"_qs}, tr("out of what is open")},
                        {{ctrl, u"F"_qs}, tr("find an exercise by its name")},
                        {{ctrl, u"T"_qs}, tr("a chart as its table, and back")},
                        {{tr("Enter")}, tr("opens the chosen row")}});
  everywhere->body()->addStretch();
  row->addWidget(everywhere, 1);
  auto* drilling = new Card(tr("Keys while drilling"));
  add_keys(drilling, {{{u"←"_qs, u"→"_qs, u"↑"_qs, u"↓"_qs}, tr("slide the bur")},
                      {{tr("Page Up"), tr("Page Down")}, tr("push less, push more")},
                      {{ctrl, u"↑"_qs}, tr("turn the handpiece, where the exercise lets it; Home: back")},
                      {{tr("Space")}, tr("cut while held")},
                      {{u"H"_qs}, tr("hold the depth, let it go (mouse)")},
                      {{u"1"_qs, u"…"_qs, u"6"_qs}, tr("views of the tooth, target and handpiece")},
                      {{u"I"_qs, u"J"_qs, u"K"_qs, u"L"_qs}, tr("move the mirror; with Shift: tilt it; U, O: nearer, away")},
                      {{u"["_qs, u"]"_qs}, tr("previous bur, next bur")},
                      {{u"P"_qs}, tr("pause and resume")},
                      {{ctrl, u"P"_qs}, tr("hide the panel at the right, show it")},
                      {{ctrl, tr("Space")}, tr("have the values read aloud (screen reader)")},
                      {{u"W"_qs}, tr("coolant on and off, where the exercise has it")},
                      {{u"M"_qs}, tr("drilling sound on and off, likewise")},
                      {{ctrl, tr("Return")}, tr("finish (asks)")}});
  drilling->body()->addStretch();
  row->addWidget(drilling, 1);
  return row;
}

}  // namespace cusp::ui
