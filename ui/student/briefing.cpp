#include "ui/student/briefing.h"

#include <QBoxLayout>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>

#include "scenarios/format/keys.h"
#include "scenarios/grading/maxima.h"
#include "ui/modules.h"
#include "ui/render/opengl_allowed.h"
#include "ui/replay/reference_page.h"
#include "ui/text/bur_text.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/bar_top.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

QString depth_text(double mm) {
  const bool tenths = std::abs(mm * 10 - std::round(mm * 10)) < 1e-6;
  return format({mm, std::nullopt, u"mm"_qs, tenths ? 1 : 2});
}

bool asks_for_depth(const Scenario& s) {
  return std::ranges::any_of(s.rubric.criteria, [](const Criterion& c) { return scenarios::split_metric(c.metric).metric.starts_with("depth_"); });
}

/// Of the first outline, from whose plane depth is measured; of several targets with different depths one line for each. Empty: none is
/// asked for. The outline about a lesion is the way to it, and the lesion's end is the floor.
QString required_depth_text(const Scenario& s) {
  const auto outlines = outlines_of(s.target);
  if (outlines.empty() || (needs_voxels(s.target) && !asks_for_depth(s))) return {};
  QStringList lines;
  bool same = true;
  for (const Region* target : named_targets(s.target)) {
    const auto own = outlines_of(*target);
    if (own.empty()) continue;
    lines += Briefing::tr("%1: %2", "a target, its depth").arg(target_title(target->name, &s.target), depth_text(own.front()->depth_mm));
    same = same && own.front()->depth_mm == outlines.front()->depth_mm;
  }
  return same ? depth_text(outlines.front()->depth_mm) : lines.join(u'\n');
}

/// Of floor and sides, and a line for each face that has another.
QString tolerance_text(const Leeway& leeway) {
  const auto length = [](double mm) { return format({mm, std::nullopt, u"mm"_qs, 2}); };
  QStringList lines{Briefing::tr("%1 at the floor, %2 at the sides").arg(length(leeway.floor_mm), length(leeway.side_mm))};
  for (const auto& [face, mm] : leeway.faces) {
    const QString name = face_name(key_of(face));
    lines += mm > 0.0 ? Briefing::tr("%1: %2").arg(name, length(mm)) : Briefing::tr("%1: none", "tolerance").arg(name);
  }
  return lines.join(u'\n');
}

/// What an attempt is to spare: "Neighbour enamel: cut at most 0.2 mm deep".
QString protected_text(const Protected& part, const TissueNames& own) {
  const std::optional<Tissue> tissue = whole_tissue(part);
  const QString name = tissue ? tissue_name(*tissue, own) : Briefing::tr("A part of the specimen");
  switch (part.severity) {
    case Damage::removal: return name;
    case Damage::touch: return Briefing::tr("%1: not to be laid bare").arg(name);
    case Damage::depth: return Briefing::tr("%1: cut at most %2 deep").arg(name, depth_text(part.depth_mm));
  }
  return name;
}

}  // namespace

QString burs_text(const Scenario& scenario) {
  QStringList parts;
  for (const Bur& bur : scenario.instruments) {
    // A line breaks between burs, not within one.
    parts += bur_text(bur).replace(u' ', QChar::Nbsp);
  }
  //: Between the burs of a list, each of which has commas of its own.
  return parts.join(Briefing::tr("; "));
}

QLabel* make_limit_note(const QString& text) {
  QLabel* note = make_label(text, TextRole::body, Weight::bold, "look");
  note->setWordWrap(true);
  return note;
}

void show_covering(QLabel* label, const QImage& image, double radius) {
  const qreal ratio = label->devicePixelRatioF();
  const QSize size = label->size() * ratio;
  if (size.isEmpty()) return;
  QImage scaled;
  if (image.isNull()) {
    // The picture is not drawn yet: the colour behind the tooth.
    scaled = QImage(size, QImage::Format_RGB32);
    scaled.fill(tokens().view_middle);
  } else {
    scaled = image.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  }
  QPixmap out(size);
  out.fill(Qt::transparent);
  QPainter painter(&out);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath clip;
  clip.addRoundedRect(QRectF(QPointF(), size), radius * ratio, radius * ratio);
  painter.setClipPath(clip);
  painter.drawImage((size.width() - scaled.width()) / 2, (size.height() - scaled.height()) / 2, scaled);
  painter.end();
  out.setDevicePixelRatio(ratio);
  label->setPixmap(out);
}

Briefing::Briefing(const Exercise& exercise, ThumbnailCache& pictures, const std::filesystem::path& folder,
                   std::shared_ptr<ToothCache> teeth, const QString& refusal, QWidget* parent)
    : QWidget(parent),
      exercise_(exercise),
      pictures_(pictures),
      folder_(folder),
      refusal_(refusal),
      teeth_(opengl_allowed() ? std::move(teeth) : nullptr),
      stack_(new QStackedWidget) {
  if (teeth_) ahead_.emplace(teeth_, ToothWish{exercise.scenario, folder, Guidance::full, nullptr});
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(stack_);
  stack_->addWidget(make_briefing());
  setFocusProxy(start_->isEnabled() ? start_ : back_);
  connect(&pictures_, &ThumbnailCache::ready, this, &Briefing::show_picture);
  show_picture();
}

QWidget* Briefing::make_briefing() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_bar());
  QVBoxLayout* body = nullptr;
  column->addWidget(make_scroll_page(&body), 1);
  auto* row = new QHBoxLayout;
  row->setSpacing(px(24));
  body->addLayout(row);
  picture_ = new QLabel;
  picture_->setFixedSize(px(400), px(330));
  picture_->setAccessibleName(tr("The tooth with its target"));
  row->addWidget(picture_, 0, Qt::AlignTop);
  auto* text = new QVBoxLayout;
  text->setSpacing(px(8));
  row->addLayout(text, 1);
  fill_text(*text);
  body->addWidget(make_points());
  body->addWidget(make_keys());
  body->addStretch();
  return page;
}

void Briefing::show_uncounted(const QString& text) {
  uncounted_->setText(text);
  uncounted_->setVisible(!text.isEmpty());
}

void Briefing::watch_reference() {
  auto* page = new ReferencePage(teeth_, ToothWish{exercise_.scenario, folder_, Guidance::full, nullptr}, local(exercise_.scenario.title));
  stack_->setCurrentIndex(stack_->addWidget(page));
  page->setFocus();
  connect(page, &ReferencePage::back_wanted, this, [this, page] {
    stack_->setCurrentIndex(0);
    stack_->removeWidget(page);
    page->deleteLater();
    watch_->setFocus();
  });
  Q_EMIT reference_opened(page);
}

QWidget* Briefing::make_bar() {
  const auto [bar, row] = make_bar_top();
  back_ = add_way_back({bar, row}, tr("Back"));
  connect(back_, &QPushButton::clicked, this, &Briefing::back_wanted);
  let_escape_go_back(back_);
  add_title({bar, row}, local(exercise_.scenario.title));
  return bar;
}

void Briefing::fill_text(QVBoxLayout& text) {
  const Scenario& s = exercise_.scenario;
  for (QLabel* label : {make_label(local(s.title), TextRole::page_title, Weight::bold), make_label(briefing_text(s))}) {
    label->setWordWrap(true);
    text.addWidget(label);
  }
  text.addSpacing(px(8));
  add_facts(text);
  text.addSpacing(px(16));
  if (!refusal_.isEmpty()) text.addWidget(make_limit_note(refusal_));
  uncounted_ = make_limit_note({});
  uncounted_->hide();
  text.addWidget(uncounted_);
  auto* acts = new QHBoxLayout;
  start_ = make_large_button(tr("Start"), ButtonKind::primary, u"play"_qs);
  start_->setDefault(true);
  acts->addWidget(start_);
  start_->setEnabled(opengl_allowed() && refusal_.isEmpty());
  const QString enter = refusal_.isEmpty() ? tr("Enter starts") : QString();
  QLabel* hint = make_label(opengl_allowed() ? enter : ToothView::pictures_off(), TextRole::caption, Weight::regular, "text3");
  hint->setWordWrap(true);
  if (teeth_ && refusal_.isEmpty() && ReferencePage::offered(s)) {
    watch_ = make_large_button(tr("Watch the ideal preparation"), ButtonKind::standard, u"eye"_qs);
    watch_->setToolTip(tr("It is cut before your eyes in half a minute"));
    connect(watch_, &QPushButton::clicked, this, &Briefing::watch_reference);
    acts->addWidget(watch_);
  }
  acts->addWidget(hint, 1);
  text.addLayout(acts);
  text.addStretch();
  connect(start_, &QPushButton::clicked, this, [this] { Q_EMIT start_wanted(exercise_); });
}

void Briefing::add_facts(QVBoxLayout& text) {
  const Scenario& s = exercise_.scenario;
  auto* facts = new QFormLayout;
  facts->setHorizontalSpacing(px(24));
  facts->setVerticalSpacing(px(4));
  facts->setLabelAlignment(Qt::AlignLeading | Qt::AlignTop);
  const auto fact = [&](const QString& name, const QString& value) {
    QLabel* label = make_label(value);
    label->setWordWrap(true);
    QLabel* head = make_label(name, TextRole::body, Weight::regular, "text2");
    head->setAlignment(Qt::AlignLeading | Qt::AlignTop);  // beside the first line of several
    facts->addRow(head, label);
  };
  if (s.level) fact(tr("Level"), level_name(*s.level));
  if (s.expected_time_s > 0) fact(tr("Expected time"), expected_time_text(s.expected_time_s));
  fact(tr("Burs"), burs_text(s));
  if (const QString depth = required_depth_text(s); !depth.isEmpty()) fact(tr("Required depth"), depth);
  fact(tr("Tolerance zone"), tolerance_text(s.leeway));
  QStringList spared;
  const TissueNames own = tissue_names_in(folder_, s);
  for (const Protected& part : s.protected_parts) spared += protected_text(part, own);
  if (!spared.isEmpty()) fact(tr("Protected"), spared.join(u'\n'));
  fact(tr("Time limit"), s.time_limit_s > 0 ? tr("%1 at most").arg(duration_text(s.time_limit_s))
                         : asks_for_time(s) ? tr("none")
                                            : tr("none; time earns no points"));
  fact(tr("Pass mark"), tr("%1 of 100").arg(format_points(s.rubric.pass)));
  if (s.self_assessment) fact(tr("Own assessment"), tr("asked for before the result"));
  QStringList critical;
  for (const std::string& key : s.rubric.critical) critical += critical_name(key);
  if (!critical.isEmpty()) fact(tr("Fails the attempt"), critical.join(u'\n'));
  text.addLayout(facts);
}

QWidget* Briefing::make_points() {
  const Scenario& s = exercise_.scenario;
  auto* points = new Card(tr("What earns points"), tr("Full points"));
  auto* table = new Table;
  auto* model = new QStandardItemModel(this);
  model->setHorizontalHeaderLabels({tr("Criterion"), tr("Full points"), tr("Points")});
  const TissueNames own = tissue_names_in(folder_, s);
  const std::vector<double> maxima = scaled_maxima(s);
  const int decimals = points_decimals(maxima);
  for (std::size_t i = 0; i < maxima.size(); ++i) {
    const Criterion& c = s.rubric.criteria[i];
    auto* weight = new QStandardItem(format_points_to(maxima[i], decimals));
    weight->setTextAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
    model->appendRow({new QStandardItem(metric_name(c.metric, &s.target, own)), new QStandardItem(wanted_text(c)), weight});
  }
  model->setHeaderData(2, Qt::Horizontal, static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter), Qt::TextAlignmentRole);
  table->setModel(model);
  table->setAccessibleName(tr("What earns points"));
  table->set_stretch_column(0);
  table->set_rows_shown(static_cast<int>(maxima.size()));  // the page scrolls, the table does not
  points->set_aside({});
  points->body()->addWidget(table);
  return points;
}

QWidget* Briefing::make_keys() {
  auto* keys = new Card(tr("With mouse and keys"));
  QLabel* how = make_label(tr("Move the mouse, or the arrow keys, to slide the bur over the tooth. Push with the wheel "
                              "or with Page Down, let up with Page Up. Hold Space, or the left button, to cut."),
                           TextRole::body, Weight::regular, "text2");
  how->setWordWrap(true);
  keys->body()->addWidget(how);
  return keys;
}

/// An attempt that lay over it has stopped what was being drawn.
void Briefing::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  show_picture();
}

void Briefing::show_picture() {
  show_covering(picture_, pictures_.picture(exercise_, folder_, ThumbnailCache::Use::card), px(8));
}

}  // namespace cusp::ui
