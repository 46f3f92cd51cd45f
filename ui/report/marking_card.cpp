#include "ui/report/marking_card.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <algorithm>

#include "ui/text/failure_text.h"
#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kTextHeight = 60, kRemarkShown = 60;  // px at 100 %; characters
constexpr int kOpenHeight = 900;  // px at 100 %, of the window: a lower one keeps its room for the criteria

QWidget* row_of(std::initializer_list<QWidget*> parts) {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(8));
  for (QWidget* part : parts) row->addWidget(part, qobject_cast<QComboBox*>(part) || qobject_cast<QLabel*>(part) ? 1 : 0);
  return box;
}

std::pair<int, std::vector<Uuid>> changes_in(const EffectiveGrade& grade) {
  std::pair<int, std::vector<Uuid>> out{grade.stored.number, {}};
  for (const SignedStatement& s : grade.overrides) out.second.push_back(s.id);
  return out;
}

/// What is chosen stays so while the list has it: a reason that is written concerns it.
void refill(QComboBox& list, const std::function<void(QComboBox& list)>& fill) {
  const QVariant chosen = list.currentData();
  list.clear();
  fill(list);
  if (chosen.isValid()) list.setCurrentIndex(std::max(0, list.findData(chosen)));
}

QString short_text(const Remark& remark) {
  QString text = remark.what.isEmpty() ? remark.text : remark.what;
  text.replace(u'\n', u' ');
  if (text.size() > kRemarkShown) text = text.left(kRemarkShown - 1) + u'…';
  return text;
}

}  // namespace

MarkingCard::MarkingCard(Store& store, const Actor& actor, const ReportData& report, const Ports& ports, QWidget* parent)
    : Card(MarkingCard::tr("Marking"), {}, parent), store_(store), actor_(actor), ports_(ports), session_(report.result.session), target_(report.result.scenario.target), tissue_names_(tissue_names_of(report.result)) {
  setAccessibleName(tr("Marking"));
  band_ = new Band;
  body()->addWidget(band_);
  make_fold();
  auto* inside = new QVBoxLayout(content_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(px(8));
  text_ = new QPlainTextEdit;
  text_->setPlaceholderText(tr("A comment, or the reason for a change"));
  text_->setAccessibleName(tr("Comment or reason"));
  text_->setFixedHeight(px(kTextHeight));
  text_->setTabChangesFocus(true);
  inside->addWidget(text_);
  at_place_ = new QCheckBox(tr("at the place of the chosen criterion"));
  QPushButton* add = make_button(tr("Add comment"), ButtonKind::standard, u"comment"_qs);
  auto* row = new QHBoxLayout;
  row->addWidget(add);
  row->addWidget(at_place_, 1);
  inside->addLayout(row);
  connect(add, &QPushButton::clicked, this, &MarkingCard::comment);
  const bool examines = may(actor.role, Action::grade_again);
  if (examines && report.of_reader) {
    QLabel* own = make_label(tr("This is your own attempt: another examiner marks and releases it."), TextRole::body, Weight::regular, "text2");
    own->setWordWrap(true);
    inside->addWidget(own);
  }
  if (examines && !report.of_reader) {
    inside->addWidget(make_points());
    inside->addWidget(make_result());
  }
  inside->addWidget(make_taking_back());
  set_criterion(nullptr);
  show_data(report);
}

/// A button at the head shows or hides the rest.
void MarkingCard::make_fold() {
  content_ = new QWidget;
  body()->addWidget(content_);
  fold_ = make_button(tr("Mark this attempt"), ButtonKind::quiet, u"chevron_down"_qs);
  fold_->setCheckable(true);
  fold_->setToolTip(tr("Comment, change points, confirm or release"));
  head()->addWidget(fold_);
  connect(fold_, &QPushButton::toggled, this, [this](bool on) {
    show_content(on ? Content::shown : Content::hidden);
  });
  connect(fold_, &QPushButton::clicked, this, [this] { chosen_ = true; });
  show_content(Content::hidden);
}

void MarkingCard::show_content(Content content) {
  const bool on = content == Content::shown;
  content_->setVisible(on);
  body()->setContentsMargins(px(16), px(on ? 16 : 6), px(16), px(on ? 16 : 6));
  fold_->setIcon(icon(on ? u"chevron_up"_qs : u"chevron_down"_qs));
}

void MarkingCard::showEvent(QShowEvent* event) {
  Card::showEvent(event);
  if (!chosen_) fold_->setChecked(window()->height() >= px(kOpenHeight));
}

QWidget* MarkingCard::make_points() {
  points_label_ = make_label({});
  points_label_->setWordWrap(true);
  points_ = new NumberField;
  points_->setDecimals(1);
  points_->setFixedWidth(px(88));
  change_ = make_button(tr("Change points"));
  connect(change_, &QPushButton::clicked, this, &MarkingCard::change_points);
  events_ = new QComboBox;
  events_->setAccessibleName(tr("Critical event"));
  strike_ = make_button(tr("Does not count"));
  connect(strike_, &QPushButton::clicked, this, &MarkingCard::strike);
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(8));
  column->addWidget(row_of({points_label_, points_, change_}));
  events_row_ = row_of({events_, strike_});
  column->addWidget(events_row_);
  return box;
}

QWidget* MarkingCard::make_result() {
  confirm_ = make_button(tr("Confirm the result"), ButtonKind::standard, u"check"_qs);
  release_ = make_button(tr("Release to the student"), ButtonKind::standard, u"eye"_qs);
  connect(confirm_, &QPushButton::clicked, this,
          [this] { if (still_stands()) finish(store_.statements.confirm(actor_, session_, read_), tr("The result is confirmed as it stands."), Text::kept); });
  connect(release_, &QPushButton::clicked, this,
          [this] { if (still_stands()) finish(store_.statements.release(actor_, session_), tr("The student can read the result now."), Text::kept); });
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(8));
  row->addWidget(confirm_);
  row->addWidget(release_);
  row->addStretch();
  return box;
}

QWidget* MarkingCard::make_taking_back() {
  remarks_ = new QComboBox;
  remarks_->setAccessibleName(tr("What was said"));
  remarks_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  take_back_ = make_button(tr("Take back"), ButtonKind::erase);
  connect(take_back_, &QPushButton::clicked, this, &MarkingCard::take_back);
  remarks_row_ = row_of({remarks_, take_back_});
  return remarks_row_;
}

void MarkingCard::set_criterion(const CriterionGrade* criterion) {
  // Each statement has the report read anew: points that are typed and not stated yet stay.
  const bool typed = points_ != nullptr && criterion != nullptr && criterion->id == criterion_ &&
                     format_points(points_->value()) != format_points(shown_.points);
  criterion_ = criterion ? criterion->id : std::string();
  place_mm_ = criterion ? criterion->measure.where_mm : std::nullopt;
  points_now_ = criterion ? criterion->points : 0;
  points_most_ = criterion ? criterion->points_max : 0;
  const auto in_table = in_table_.find(criterion_);
  shown_ = in_table == in_table_.end() ? ScaledPoints{} : in_table->second;
  at_place_->setEnabled(place_mm_.has_value());
  if (!place_mm_) at_place_->setChecked(false);
  if (points_ == nullptr) return;
  for (QWidget* part : {static_cast<QWidget*>(points_), static_cast<QWidget*>(change_)}) part->setEnabled(points_most_ > 0);
  if (criterion == nullptr) {
    points_label_->setText(tr("Choose a criterion to change its points."));
    return;
  }
  const QString name = metric_name(criterion->id, &target_, tissue_names_);
  points_label_->setText(points_most_ > 0 ? tr("%1, of %2").arg(name, format_points(shown_.points_max)) : tr("%1: no points to change").arg(name));
  points_->setRange(0, shown_.points_max);
  points_->setAccessibleName(tr("Points of %1").arg(name));
  if (!typed) points_->show_value(shown_.points);
}

void MarkingCard::show_data(const ReportData& report) {
  refill(*remarks_, [&report](QComboBox& list) {
    for (const Remark& remark : report.remarks) {
      if (!remark.id.is_nil()) list.addItem(short_text(remark), QString::fromStdString(remark.id.text()));
    }
  });
  remarks_row_->setVisible(remarks_->count() > 0);
  const bool assessed = report.kind == SessionKind::assessment;
  set_aside(!assessed ? QString() : report.released ? tr("released") : tr("withheld from the student"));
  if (points_ == nullptr || !report.counts) return;
  seen_ = changes_in(*report.counts);
  read_ = shown_hash(report.counts->grade);
  scale_ = score_per_point(report.counts->stored.grade);
  in_table_.clear();
  const std::vector<ScaledPoints> scaled = scaled_points(report.result.grade);
  for (std::size_t i = 0; i < scaled.size(); ++i) in_table_[report.result.grade.criteria[i].id] = scaled[i];
  refill(*events_, [&report](QComboBox& list) {
    for (const std::string& event : report.counts->grade.critical) list.addItem(critical_name(event), QString::fromStdString(event));
  });
  events_row_->setVisible(events_->count() > 0);
  confirm_->setVisible(assessed || !report.counts->grade.passed);
  confirm_->setEnabled(!report.counts->confirmation);
  release_->setVisible(assessed && may(actor_.role, Action::assign));
  release_->setEnabled(!report.released && !report.counts->needs_confirmation());
  release_->setToolTip(report.counts->needs_confirmation() ? tr("A failed result is confirmed first") : QString());
}

bool MarkingCard::has_points() const {
  if (points_ == nullptr || criterion_.empty()) return false;
  points_->interpretText();  // a shortcut leaves the focus in the field
  return format_points(points_->value()) != format_points(shown_.points);
}

QString MarkingCard::written() const { return text_->toPlainText(); }

void MarkingCard::write(const QString& text) {
  text_->setPlainText(text);
  chosen_ = true;
  fold_->setChecked(true);
}

QString MarkingCard::reason() const { return text_->toPlainText().trimmed(); }

void MarkingCard::finish(const Stored<SignedStatement>& result, const QString& done, Text text) {
  if (!result) {
    const Message message = describe(result.error());
    band_->show_message(Band::Kind::bad, message.what, message.more);
    return;
  }
  seen_.reset();  // until the report is read anew
  read_.reset();
  if (text == Text::used) text_->clear();
  band_->show_message(Band::Kind::good, done, {});
  Q_EMIT stated();
}

bool MarkingCard::still_stands() {
  const auto now = store_.history.details(actor_, session_);
  if (!seen_ || !now || !now->grade || changes_in(*now->grade) == *seen_) return true;
  band_->show_message(Band::Kind::look, tr("The result was changed at another desk meanwhile."),
                      tr("The report shows it as it counts now. Nothing was stated."));
  Q_EMIT stated();
  return false;
}

void MarkingCard::comment() {
  if (reason().isEmpty()) {
    band_->show_message(Band::Kind::look, tr("The comment is empty."), tr("Write it below."));
    return text_->setFocus();
  }
  CommentPlace at;
  if (at_place_->isChecked()) at.place_mm = place_mm_;
  finish(store_.statements.comment(actor_, session_, reason().toStdString(), at), tr("The comment is kept."));
}

void MarkingCard::change_points() {
  points_->interpretText();  // a button that a screen reader presses leaves the focus in the field
  // The field rounds its maximum, which stands for full points.
  const double given = points_->value() >= points_->maximum() ? points_most_ : std::min(points_->value() / scale_, points_most_);
  if (format_points(points_->value()) == format_points(shown_.points) || given == points_now_) {
    band_->show_message(Band::Kind::look, tr("These are the points that count already."), tr("Type other points."));
    return points_->setFocus();
  }
  if (reason().isEmpty()) {
    band_->show_message(Band::Kind::look, tr("A change needs a reason."), tr("Write it below; the student reads it."));
    return text_->setFocus();
  }
  if (!still_stands()) return;
  const auto done = store_.statements.override_points(actor_, session_, criterion_, given, reason().toStdString(), read_);
  if (done) shown_.points = points_->value();  // until the report is read anew
  finish(done, tr("The points are changed. The measured grade is kept beside them."));
}

void MarkingCard::strike() {
  if (reason().isEmpty()) {
    band_->show_message(Band::Kind::look, tr("A change needs a reason."), tr("Write it below; the student reads it."));
    return text_->setFocus();
  }
  if (!still_stands()) return;
  finish(store_.statements.override_critical(actor_, session_, events_->currentData().toString().toStdString(),
                                             reason().toStdString(), read_),
         tr("The critical event no longer counts."));
}

void MarkingCard::take_back() {
  const auto statement = Uuid::parse(remarks_->currentData().toString().toStdString());
  if (!statement) return;
  if (reason().isEmpty()) {
    band_->show_message(Band::Kind::look, tr("Taking back needs a reason."), tr("Write the reason below."));
    return text_->setFocus();
  }
  finish(store_.statements.withdraw(actor_, session_, *statement, reason().toStdString()),
         tr("It is taken back. Both stay in the records."));
}

}  // namespace cusp::ui
