#include "ui/report/pinned_tooth.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPointer>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "scenarios/landmarks/landmarks.h"
#include "scenarios/metrics/evidence_patch.h"
#include "ui/render/target_look.h"
#include "ui/view/compass.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

/// Ring round the pinned place; lets the mouse through.
class Ring : public QWidget {
 public:
  explicit Ring(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFixedSize(px(22), px(22));
    setMask(QRegion(rect(), QRegion::Ellipse) - QRegion(rect().adjusted(px(6), px(6), -px(6), -px(6)), QRegion::Ellipse));
    hide();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.fillRect(rect(), ToothColours::get().casing);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(QPen(ToothColours::get().map[2], px(2)));
    p.drawEllipse(QRectF(rect()).adjusted(px(3), px(3), -px(3), -px(3)));
  }
};

constexpr int kClear = 36;  // px at 100 % between a place and its card, at least
constexpr int kHead = 64;   // px at 100 %: below the buttons at the view's head
constexpr double kLegendEndMm = 0.5;  // deviation at either end of the legend
constexpr int kWideLegend = 190;  // px at 100 %: a shorter bar has numbers at its ends and its middle alone
constexpr int kToothMargin = 12;  // px at 100 % between the tooth and the edge of the view, where there is room
constexpr qsizetype kCardText = 160, kCardLines = 6;  // characters and lines of a card, which stands before the tooth

/// Of a longer text its beginning: the remarks have the whole.
QString card_text(const QString& whole) {
  const QString text = whole.trimmed();
  if (text.size() <= kCardText && text.count(u'\n') < kCardLines) return text;
  QString out = text.section(u'\n', 0, kCardLines - 1).left(kCardText - 1).trimmed();
  if (!out.isEmpty() && out.back().isHighSurrogate()) out.chop(1);
  return out + u'…';
}

}  // namespace

/// Line from the ring to its card; a mask shapes it, as the ring.
class PinLeader : public QWidget {
 public:
  explicit PinLeader(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
  }
  void span(QPointF from, QPointF to) {
    const int width = px(4);
    const QRect box = QRectF(from, to).normalized().toAlignedRect().adjusted(-width, -width, width, width);
    setGeometry(box);
    line_ = QLineF(from - box.topLeft(), to - box.topLeft());
    QPainterPath path(line_.p1());
    path.lineTo(line_.p2());
    QPainterPathStroker stroker;
    stroker.setWidth(width);
    setMask(QRegion(stroker.createStroke(path).toFillPolygon().toPolygon()));
    update();
  }
  const QLineF& line() const { return line_; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.fillRect(rect(), ToothColours::get().casing);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(QPen(ToothColours::get().map[2], px(2)));
    p.drawLine(line_);
  }

 private:
  QLineF line_;
};

/// The patches of an attempt's measures, made when the first of them is asked for. Any thread.
class PatchSource {
 public:
  PatchSource(std::shared_ptr<const Volume> volume, const Scenario& scenario) : volume_(std::move(volume)), scenario_(scenario) {}
  /// The number of a wish; older ones are given up.
  int wish() const { return ++newest_; }
  bool is_newest(int wished) const { return wished == newest_; }
  struct Found {
    SurfaceMarks marks;
    std::optional<Vec3> shown_mm;  // of the pinned place
  };
  /// nullopt: another patch was wished for meanwhile.
  std::optional<Found> find(const std::string& metric, const std::optional<Vec3>& place_mm, int wished) const {
    const std::lock_guard lock(mutex_);
    if (!is_newest(wished)) return std::nullopt;
    if (!patches_) {
      patches_.emplace(std::make_shared<const Reference>(scenario_, volume_->specimen_ptr()), volume_);
    }
    const EvidencePatch patch = patches_->of(metric);
    Found out{marks_of(patch), {}};
    if (place_mm) out.shown_mm = shown_place(metric, patch, *place_mm);
    return out;
  }

 private:
  std::shared_ptr<const Volume> volume_;
  Scenario scenario_;
  mutable std::atomic<int> newest_ = 0;
  mutable std::mutex mutex_;  // guards what follows
  mutable std::optional<EvidencePatches> patches_;
};

PinnedTooth::PinnedTooth(std::shared_ptr<const Volume> volume, const Scenario& scenario, QWidget* parent)
    : QWidget(parent), volume_(std::move(volume)), view_(new ToothView(this)), leader_(new PinLeader(this)), ring_(new Ring(this)),
      card_(new QLabel(this)), waiting_(new QLabel(tr("The tooth is being drawn"), this)) {
  view_->setAccessibleName(tr("The tooth after this attempt"));
  view_->set_left_turns(true);
  view_->set_target_shown(false);
  view_->set_colouring(Colouring::deviation);
  card_->setProperty("kind", u"pin"_qs);
  card_->setTextFormat(Qt::RichText);
  card_->setWordWrap(true);
  card_->setContentsMargins(px(12), px(8), px(12), px(8));
  card_->setAutoFillBackground(true);
  card_->hide();
  waiting_->setProperty("kind", u"pin"_qs);
  waiting_->setContentsMargins(px(12), px(8), px(12), px(8));
  waiting_->setAutoFillBackground(true);
  waiting_->hide();
  if (volume_) {
    QTimer::singleShot(Busy::kDelayMs, this, &PinnedTooth::show_waiting);
    build_mesh(scenario);
    patches_ = std::make_shared<const PatchSource>(volume_, scenario);
    // Growing the rest of a jaw takes seconds; the tooth is shown meanwhile.
    QThreadPool::globalInstance()->start([self = QPointer(this), source = scenario.specimen] {
      auto scenery = scenery_of(source);
      if (!scenery) return;
      QMetaObject::invokeMethod(qApp, [self, scenery] {
        if (self) self->set_scenery(scenery);
      }, Qt::QueuedConnection);
    });
  }
  connect(view_, &ToothView::camera_changed, this, &PinnedTooth::place_pin);
  compass_ = new Compass(*view_, this);
  compass_->set_tooth(sided_fdi(scenario.specimen));
}

void PinnedTooth::build_mesh(const Scenario& scenario) {
  QThreadPool::globalInstance()->start([self = QPointer(this), volume = volume_, target = scenario.target, leeway = scenario.leeway] {
    auto mesh = std::make_shared<WholeMesh>(PatchFeed::build_mesh(*volume, TargetLook(target, leeway, volume->specimen_ptr()).feed()));
    QMetaObject::invokeMethod(qApp, [self, mesh] {
      if (!self) return;
      self->view_->show_mesh(std::move(*mesh));
      self->tooth_shown_ = true;
      delete std::exchange(self->waiting_, nullptr);
      self->turn_back();
      self->face_place();
      Q_EMIT self->tooth_came();
    }, Qt::QueuedConnection);
  });
}

void PinnedTooth::show_waiting() {
  if (!waiting_) return;
  waiting_->adjustSize();
  waiting_->move((width() - waiting_->width()) / 2, (height() - waiting_->height()) / 2);
  waiting_->show();
  waiting_->raise();
}

void PinnedTooth::set_colouring(Colouring colouring) { view_->set_colouring(colouring); }

void PinnedTooth::set_scenery(std::shared_ptr<const SceneryLook> scenery) {
  for (const BakedPatch& patch : scenery->patches()) beside_.put(patch);
  scenery_ = scenery;
  view_->set_scenery(std::move(scenery));
  place_pin();
  Q_EMIT scenery_came();
}

Meshes PinnedTooth::meshes() const { return {&view_->store(), &beside_}; }

std::optional<QLineF> PinnedTooth::leader() const {
  if (!ring_shown()) return std::nullopt;
  return leader_->line().translated(leader_->pos());
}

bool PinnedTooth::ring_shown() const { return ring_->isVisibleTo(this); }

void PinnedTooth::turn_back() {
  Camera camera = view_->camera();
  if (const auto box = view_->store().bounds()) {
    // The crown fills the view.
    const Vec3 middle = 0.5 * (box->low + box->high);
    camera = Camera::about({middle.x, middle.y, box->high.z}, 0.5 * std::hypot(box->high.x - box->low.x, box->high.y - box->low.y));
  }
  camera.set_preset(PresetView::occlusal);
  view_->set_camera(camera);
  place_pin();
}

void PinnedTooth::compute_patch(const std::string& metric) {
  metric_ = metric;
  marks_ = {};
  shown_.reset();
  view_->set_marks({});
  if (!patches_) return;
  const int wished = patches_->wish();
  if (metric.empty()) return;
  QThreadPool::globalInstance()->start([self = QPointer(this), patches = patches_, metric, place = place_, wished] {
    auto answer = patches->find(metric, place, wished);
    if (!answer) return;
    auto found = std::make_shared<PatchSource::Found>(std::move(*answer));
    QMetaObject::invokeMethod(qApp, [self, found, wished] {
      if (!self || !self->patches_->is_newest(wished)) return;  // another row was chosen meanwhile
      self->marks_ = found->marks;
      self->view_->set_marks(std::move(found->marks));
      if (found->shown_mm == self->place_) return;
      self->shown_ = found->shown_mm;
      self->face_place();
    }, Qt::QueuedConnection);
  });
}

/// A section shows what lies within.
Vec3 PinnedTooth::pinned() const { return shown_ && !cut_open_ ? *shown_ : *place_; }

void PinnedTooth::pin(const std::optional<Vec3>& place_mm, const QString& what, const QString& more, const std::string& metric) {
  const bool same = metric == metric_ && place_mm == place_;
  place_ = place_mm;
  if (!same) compute_patch(metric);
  text_ = u"<b>%1</b><br>%2"_qs.arg(what.toHtmlEscaped(), card_text(more).toHtmlEscaped().replace(u'\n', u"<br>"_qs));
  face_place();
}

void PinnedTooth::show_pin(Pin pin) {
  pin_ = pin;
  place_pin();
}

void PinnedTooth::set_cut_open(bool open) {
  cut_open_ = open;
  open ? place_pin() : face_place();
}

void PinnedTooth::set_head(int height_px) {
  head_px_ = height_px;
  place_compass();
  place_pin();
}

void PinnedTooth::face_place() {
  if (place_ && tooth_shown_ && !cut_open_) {
    const Camera facing = look_at_place(view_->camera(), meshes(), pinned());
    const Camera to = keep_in_picture(facing, meshes(), pinned(), {std::max(width(), 1), std::max(height(), 1)}, px(kToothMargin));
    inside_ = !seen_from(to, meshes(), *place_);
    view_->set_camera(to);
  }
  place_pin();
}

void PinnedTooth::place_pin() {
  const bool wanted = place_ && tooth_shown_ && pin_ == Pin::shown;
  const auto at = wanted ? view_->project(pinned()) : std::nullopt;
  const bool seen = at && (cut_open_ || seen_from(view_->camera(), meshes(), pinned()));
  ring_->setVisible(seen);
  leader_->setVisible(seen);
  card_->setVisible(wanted);
  if (!wanted) return;
  const QString hidden = inside_ ? tr("This place lies below the surface.")
                                 : tr("The tooth hides this place. Turn it, or choose the row again.");
  const bool said = !seen || (shown_ && inside_ && !cut_open_);
  card_->setText(said ? text_ + u"<br><i>%1</i>"_qs.arg(hidden.toHtmlEscaped()) : text_);
  card_->setFixedWidth(px(200));
  card_->adjustSize();
  card_->raise();
  if (!at || !seen) {
    card_->move((width() - card_->width()) / 2, height() - card_->height() - px(8));
    return;
  }
  ring_->move(at->toPoint() - ring_->rect().center());
  // At the head of the view if the place lies low, else at its foot: the card covers no cavity.
  const double foot = height() - px(8) - card_->height();
  const bool below = at->y() + px(kClear) <= foot;
  const double x = std::clamp(at->x() - card_->width() / 2.0, px(8.0), std::max(px(8.0), width() - card_->width() - px(8.0)));
  card_->move(qRound(x), qRound(below ? foot : std::max(px(kHead), head_px_ + px(8))));
  const QPointF end(card_->geometry().center().x(), below ? card_->y() : card_->geometry().bottom());
  const QLineF whole(*at, end);
  leader_->span(whole.pointAt(std::min(1.0, px(11) / std::max(whole.length(), 1.0))), end);
  ring_->raise();
}

/// At the right below what stands over the head.
void PinnedTooth::place_compass() { compass_->move(width() - compass_->width() - px(12), head_px_ + px(12)); }

void PinnedTooth::resizeEvent(QResizeEvent*) {
  view_->setGeometry(rect());
  place_compass();
  if (waiting_ && waiting_->isVisible()) show_waiting();
  place_pin();
}

DeviationLegend::DeviationLegend(QWidget* parent) : QWidget(parent) {
  //: %1: a depth with its unit, of both ends.
  setAccessibleName(tr("Colours: from %1 not removed, through on target, to %1 over-cut").arg(format({kLegendEndMm, std::nullopt, u"mm"_qs, 1})));
}
QSize DeviationLegend::sizeHint() const { return {px(440), px(66)}; }

void DeviationLegend::paintEvent(QPaintEvent*) {
  const Tokens& t = tokens();
  const ToothColours& c = ToothColours::get();
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setLayoutDirection(Qt::LeftToRight);
  const double w = std::min<double>(width() - px(56), px(400)), x0 = (width() - w) / 2;
  const QFont bold = font_of(TextRole::caption, Weight::bold), plain = font_of(TextRole::caption);
  const QString low = tr("Not removed"), middle = tr("on target"), high = tr("Over-cut");
  p.setFont(bold);
  p.setPen(t.text);
  const bool close = w < px(kWideLegend);
  const QRectF names = close ? QRectF(0, 0, width(), px(18)) : QRectF(x0, 0, w, px(18));
  p.drawText(names, Qt::AlignLeft | Qt::AlignVCenter, low);
  p.drawText(names, Qt::AlignRight | Qt::AlignVCenter, high);
  p.setFont(plain);
  p.setPen(t.text2);
  const QFontMetricsF ends(bold);
  const double free = w - 2 * std::max(ends.horizontalAdvance(low), ends.horizontalAdvance(high)) - px(16);
  // If the text does not fit between the two ends, the 0 below stands alone.
  if (QFontMetricsF(plain).horizontalAdvance(middle) <= free)
    p.drawText(QRectF(x0, 0, w, px(18)), Qt::AlignCenter, middle);
  const QRectF bar(x0, px(22), w, px(13));
  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  gradient.setColorAt(0.0, c.map[0]);
  gradient.setColorAt(0.2, c.map[1]);
  gradient.setColorAt(0.4, c.map[2]);
  gradient.setColorAt(0.6, c.map[2]);
  gradient.setColorAt(0.8, c.map[3]);
  gradient.setColorAt(1.0, c.map[4]);
  p.setPen(QPen(t.border, 1));
  p.setBrush(gradient);
  p.drawRoundedRect(bar, px(3), px(3));
  for (const double mm : {-kLegendEndMm, -0.3, 0.0, 0.3, kLegendEndMm}) {
    const double x = x0 + (mm + kLegendEndMm) / (2 * kLegendEndMm) * w;
    p.setPen(QPen(t.border, 1));
    p.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + px(4)));
    if (close && std::abs(mm) == 0.3) continue;  // its number would meet that of the end
    p.setPen(t.text2);
    QString text = mm == 0 ? u"0"_qs : (mm > 0 ? u"+"_qs : QString()) + format_number(mm, 1);
    if (mm == kLegendEndMm) text += QChar(0x00A0) + u"mm"_qs;
    p.drawText(QRectF(x - px(40), bar.bottom() + px(5), px(80), px(16)), Qt::AlignCenter, isolate(text));
  }
}

}  // namespace cusp::ui
