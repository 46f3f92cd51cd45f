// The report's cards beside the criteria: remarks, what to do next time, and the best attempt before.

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <memory>

#include "ui/report/against_before.h"
#include "ui/report/pinned_tooth.h"
#include "ui/report/report_page.h"
#include "ui/text/failure_text.h"
#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr std::size_t kReasonsShown = 3;

}  // namespace

QWidget* ReportPage::make_remarks() {
  if (data_.remarks.empty()) return nullptr;
  auto* card = new Card(tr("Remarks"), data_.released ? QString() : tr("not released yet"));
  card->setAccessibleName(tr("Remarks"));
  for (const Remark& remark : data_.remarks) {
    auto* line = new QHBoxLayout;
    line->setSpacing(px(8));
    QString html = u"<b>%1</b>, %2"_qs.arg(remark.who.toHtmlEscaped(), format_date_time(remark.when));
    for (const QString& part : {remark.what, remark.text}) {
      if (!part.isEmpty()) html += u"<br>"_qs + part.toHtmlEscaped().replace(u'\n', u"<br>"_qs);
    }
    QLabel* label = make_label(html, TextRole::body, Weight::regular, remark.superseded ? "text3" : "");
    label->setTextFormat(Qt::RichText);
    label->setWordWrap(true);
    line->addWidget(label, 1);
    if (remark.place_mm) {
      QPushButton* place = make_button(tr("Show the place"), ButtonKind::quiet, u"eye"_qs);
      place->setAccessibleDescription(remark.text.isEmpty() ? remark.what : remark.text);  // the buttons have one name
      connect(place, &QPushButton::clicked, this, [this, remark] { tooth_->pin(remark.place_mm, remark.who, remark.text); });
      line->addWidget(place, 0, Qt::AlignTop);
    }
    card->body()->addLayout(line);
  }
  return card;
}

QWidget* ReportPage::make_unread() {
  auto* band = new Band(head_);
  band->show_message(Band::Kind::bad, tr("This report is not whole: parts of the records could not be read."),
                     tr("Remarks, changed points or an earlier result may be missing. %1").arg(describe(*data_.unread).line()));
  return band;
}

QWidget* ReportPage::make_next_time() {
  auto* card = new Card(tr("Next time"));
  std::vector<Advice> all = next_time(data_);
  const QString counted = counted_text(data_.result.grade, data_.result.scenario.rubric);
  if (all.empty() && counted.isEmpty()) {
    QLabel* label = make_label(no_advice_text(data_), TextRole::body, Weight::regular, "text2");
    label->setWordWrap(true);
    card->body()->addWidget(label);
  }
  if (all.size() > kReasonsShown) all.resize(kReasonsShown);
  for (const Advice& advice : all) {
    auto* line = new QHBoxLayout;
    line->setSpacing(px(8));
    auto* sign = new QLabel;
    sign->setPixmap(icon_pixmap(advice.grave ? u"cross"_qs : u"warning"_qs, advice.grave ? Ink::bad : Ink::look, 16, devicePixelRatioF()));
    line->addWidget(sign, 0, Qt::AlignTop);
    auto* text = new QVBoxLayout;
    text->setSpacing(0);
    QLabel* head = make_label(advice.head, TextRole::body, Weight::bold);
    head->setWordWrap(true);
    text->addWidget(head);
    for (const QString& sentence : {advice.why, advice.what_to_do}) {
      if (sentence.isEmpty()) continue;
      QLabel* label = make_label(sentence, TextRole::body, Weight::regular, "text2");
      label->setWordWrap(true);
      text->addWidget(label);
    }
    line->addLayout(text, 1);
    card->body()->addLayout(line);
  }
  if (!counted.isEmpty()) {
    auto* line = new QHBoxLayout;
    line->setSpacing(px(8));
    auto* sign = new QLabel;
    sign->setPixmap(icon_pixmap(u"minus"_qs, Ink::text2, 16, devicePixelRatioF()));
    line->addWidget(sign, 0, Qt::AlignTop);
    QLabel* label = make_label(counted, TextRole::body, Weight::regular, "text2");
    label->setWordWrap(true);
    line->addWidget(label, 1);
    card->body()->addLayout(line);
  }
  card->body()->addStretch();
  return card;
}

QWidget* ReportPage::make_against() {
  auto* card = new Card(tr("Against the best before"));
  const auto say = [card](const QString& why) {
    QLabel* label = make_label(why, TextRole::body, Weight::regular, "text2");
    label->setWordWrap(true);
    card->body()->addWidget(label);
    card->body()->addStretch();
    return card;
  };
  if (!data_.before) {
    return say(data_.alone          ? tr("An appeal pack holds one attempt alone.")
               : !data_.before_read ? tr("It could not be read whether a result came before.")
               : data_.attempt == 0 ? tr("Nothing of this attempt is kept, so it is compared with no other.")
                                    : tr("No result with this device came before. From the next one on this compares the two."));
  }
  auto* legend = new QHBoxLayout;
  legend->setSpacing(px(6));
  const auto dot = [&](const QString& sign_name, Ink ink, const QString& text) {
    auto* sign = new QLabel;
    sign->setPixmap(icon_pixmap(sign_name, ink, 12, devicePixelRatioF()));
    legend->addWidget(sign);
    legend->addWidget(make_label(text, TextRole::caption, Weight::regular, "text2"));
    legend->addSpacing(px(6));
  };
  dot(u"circle"_qs, Ink::text2, tr("%1, %2").arg(format_day(data_.before_when), format_points(data_.before->score)));
  dot(u"dot"_qs, Ink::accent, tr("this attempt, %1").arg(format_points(data_.result.grade.score)));
  legend->addStretch();
  card->body()->addLayout(legend);
  auto against = std::make_unique<AgainstBefore>(data_.result.grade, *data_.before, &data_.result.scenario.target, tissue_names_of(data_.result));
  if (against->rows().isEmpty()) return say(tr("That attempt was marked by other criteria: only the points of the two compare."));
  card->body()->addWidget(against_ = against.release());
  card->body()->addStretch();
  return card;
}

}  // namespace cusp::ui
