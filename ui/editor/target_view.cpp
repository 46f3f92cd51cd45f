#include "ui/editor/target_view.h"

#include <QApplication>
#include <QLabel>
#include <QPointer>
#include <QThreadPool>
#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/landmarks/landmarks.h"
#include "ui/editor/depth_arrow.h"
#include "ui/editor/handle_knob.h"
#include "ui/editor/landmark_handles.h"
#include "ui/editor/part_handles.h"
#include "ui/editor/target_preview.h"
#include "ui/view/section_bar.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr double kFirstPitch = 1.2;                  // radians: nearly from above, with the floor's depth in view
constexpr int kCarveDelayMs = 200;                         // pause before the cavity is carved
constexpr int kLeastWidth = 230;                           // px at 100 %: beside both panels in 1280 px at 150 %
constexpr int kLeastHeight = 120;                          // px at 100 %: the page's bands keep room in 800 px at 200 %
constexpr int kShort = 320;                                // px at 100 %: a lower view shows the legend or the section

QString handle_mm(double value) { return format({value, {}, QStringLiteral("mm"), 2}); }

}  // namespace

TargetView::TargetView(EditorModel& model, QWidget* parent)
    : QWidget(parent), model_(model), view_(new ToothView(this)), shown_(model.scenario().target) {
  setMinimumSize(px(kLeastWidth), px(kLeastHeight));
  view_->set_left_turns(true);
  make_tools();
  make_legend();
  arrow_ = new DepthArrow(this);
  for (QLabel** tag : {&depth_tag_, &width_tag_, &mark_tag_}) {
    *tag = make_label({}, TextRole::caption, Weight::bold);
    (*tag)->setParent(this);
    set_kind(*tag, "pin");
    (*tag)->setAttribute(Qt::WA_TransparentForMouseEvents);
    (*tag)->setAutoFillBackground(true);
    (*tag)->hide();
  }
  hint_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  hint_->setParent(this);
  set_kind(hint_, "tag");

  rest_.setSingleShot(true);
  rest_.setInterval(kCarveDelayMs);
  connect(&rest_, &QTimer::timeout, this, [this] {
    mesh_wanted_ = true;
    run_next();
  });
  connect(view_, &ToothView::camera_changed, this, &TargetView::place_all);
  connect(&model_, &EditorModel::changed, this, &TargetView::follow_model);
  connect(&model_, &EditorModel::part_chosen, this, &TargetView::place_all);
  connect(&model_, &EditorModel::landmark_chosen, this, &TargetView::place_all);
  connect(view_, &ToothView::feed_shown, this, &TargetView::place_all);  // what it hides of the landmarks is known
}

TargetView::~TargetView() { qDeleteAll(knobs_); }  // one that loses the focus places the others

void TargetView::set_specimen(std::shared_ptr<const GrownSpecimen> grown) {
  const bool there = grown != nullptr;
  // The camera stays while carious lesions or neighbours change.
  const auto same = [](const SpecimenSource& a, const SpecimenSource& b) {
    return a.generator == b.generator && a.fdi == b.fdi && a.volume == b.volume && a.around.empty() == b.around.empty();
  };
  const bool turn = there && (!looked_at_ || !same(*looked_at_, grown->source));
  grown_ = std::move(grown);
  if (!there) {
    target_lines_.clear();
    view_->set_lines({});
    view_->set_scenery(nullptr);
    preview_.reset();
    place_all();
    return;
  }
  looked_at_ = grown_->source;
  if (turn) look_at_target();
  show_scenery();
  shown_ = model_.scenario().target;
  shown_leeway_ = model_.scenario().leeway;
  mesh_wanted_ = true;
  run_next();
  place_all();
}

void TargetView::show_scenery() {
  const SpecimenSource& source = grown_->source;
  scenery_.reset();
  if (std::ranges::find(source.around, "jaw") == source.around.end()) return view_->set_scenery(nullptr);
  QThreadPool::globalInstance()->start([source, self = QPointer<TargetView>(this)] {
    auto scenery = scenery_of(source);
    QMetaObject::invokeMethod(
        qApp,
        [self, source, scenery] {
          if (!self || !self->grown_ || self->grown_->source != source) return;
          self->scenery_ = scenery;
          self->view_->set_scenery(scenery);
          self->cut_section();
        },
        Qt::QueuedConnection);
  });
}

void TargetView::look_at_target() {
  const SpecimenFacts& f = grown_->facts;
  const TargetShape shape(model_.scenario().target);
  const Vec3 size = f.high_mm - f.low_mm;
  Vec3 centre = (f.low_mm + f.high_mm) / 2.0;
  centre.z = std::clamp(shape.top_mm() - 1.0, f.low_mm.z, f.high_mm.z);  // the crown
  Camera camera = Camera::about(centre, 0.5 * std::hypot(size.x, size.y));
  camera.set_preset(PresetView::working);
  camera.set_angles(camera.yaw(), kFirstPitch);
  view_->set_camera(camera);
}

void TargetView::follow_model() {
  const Scenario& s = model_.scenario();
  if (grown_ && (!(s.target == shown_) || !(s.leeway == shown_leeway_))) {
    shown_ = s.target;
    shown_leeway_ = s.leeway;
    lines_wanted_ = true;
    rest_.start();
    run_next();
    cut_section();
  }
  section_->set_tooth(sided_fdi(s.specimen));
  follow_landmarks();
  place_all();
}

void TargetView::run_next() {
  if (working_ || !grown_ || (!lines_wanted_ && !mesh_wanted_)) return;
  working_ = true;
  const bool mesh = mesh_wanted_ && !lines_wanted_;
  if (mesh) mesh_wanted_ = false;
  lines_wanted_ = false;
  PreviewWish wish{grown_->whole, model_.scenario().target, model_.scenario().leeway, carved_ && !shows_landmarks()};
  QThreadPool::globalInstance()->start([wish, mesh, self = QPointer<TargetView>(this)] {
    auto made = std::make_shared<TargetPreview>();
    if (mesh) {
      *made = make_preview(wish);
    } else {
      made->lines = preview_lines(wish);
    }
    QMetaObject::invokeMethod(
        qApp,
        [self, made, whole = wish.whole] {
          if (!self) return;
          self->working_ = false;
          // The answer is out of date if another tooth came first.
          if (self->grown_ && self->grown_->whole == whole) {
            self->target_lines_ = made->lines;
            self->show_lines();
            if (made->patches) {
              self->view_->set_feed(made->patches);
              self->preview_ = made->shown;
              self->cut_section();
            }
          }
          self->run_next();
        },
        Qt::QueuedConnection);
  });
}

void TargetView::apply(const TargetHandle& handle, const Outline& from, Vec3 to) {
  const Outline t = moved(from, handle, to);
  switch (handle.kind) {
    case TargetHandle::Kind::depth: model_.set_depth_mm(t.depth_mm); break;
    case TargetHandle::Kind::width: model_.set_width_mm(t.width_mm); break;
    case TargetHandle::Kind::size_x:
    case TargetHandle::Kind::size_y: model_.set_box_size_mm(t.box_size_mm.x, t.box_size_mm.y); break;
    case TargetHandle::Kind::point:
      model_.set_outline(t, u"handle/%1/%2"_qs.arg(handle.path).arg(handle.point));
      break;
    default: break;
  }
}

std::optional<Vec3> TargetView::on_plane(QPointF at) const {
  const Ray ray = view_->ray(at);
  if (std::abs(ray.along.z) < 1e-3) return std::nullopt;  // the ray is parallel to the plane
  const double t = (model_.outline().top_mm - ray.from_mm.z) / ray.along.z;
  if (t < 0) return std::nullopt;
  return ray.from_mm + t * ray.along;
}

void TargetView::place_all() {
  view_->setGeometry(rect());
  view_->lower();
  fit_tools();
  tools_->move(px(12), px(12));
  legend_->setVisible(!section_->is_open() || height() >= px(kShort));
  legend_->adjustSize();
  // Beside the tools, or below them in a narrow window.
  const bool beside = tools_->geometry().right() + px(12) + legend_->width() <= width() - px(12);
  legend_->move(width() - legend_->width() - px(12), beside ? px(12) : tools_->geometry().bottom() + px(8));
  write_hint();
  hint_->setVisible(!present_handles().empty() && !section_->is_open());  // a narrow view has room for one of them
  hint_->setWordWrap(hint_->fontMetrics().horizontalAdvance(hint_->text()) > width() - px(48));
  hint_->setFixedWidth(hint_->wordWrap() ? std::max(0, width() - px(24)) : hint_->sizeHint().width());
  hint_->adjustSize();
  place_section();
  hint_->move(px(12), height() - hint_->height() - px(12));
  if (centre_) {
    centre_->adjustSize();
    // Below a tooth with handles, else in the middle.
    const int y = grown_ ? hint_->y() - centre_->height() - px(12) : (height() - centre_->height()) / 2;
    centre_->move((width() - centre_->width()) / 2, y);
  }
  place_handles();
  for (HandleKnob* knob : knobs_) knob->raise();
  if (centre_) centre_->raise();
}

std::vector<TargetHandle> TargetView::present_handles() {
  if (!grown_) return {};
  if (shows_landmarks()) return handles_of_landmarks(model_.landmarks(), model_.landmark());
  if (is_node(model_.chosen().kind)) return node_handles();
  return model_.has_outline() ? handles_of(model_.outline()) : handles_of_part(model_.chosen());
}

void TargetView::place_handles() {
  handles_ = present_handles();
  while (knobs_.size() < handles_.size()) {
    knobs_.push_back(new HandleKnob(*this, static_cast<int>(knobs_.size())));
    section_->tab_after(knobs_.back());  // it stands below the tooth
  }
  for (QLabel* tag : {depth_tag_, width_tag_, mark_tag_}) tag->hide();
  if (handles_.empty() || !model_.has_outline() || shows_landmarks()) arrow_->hide();
  for (std::size_t i = 0; i < knobs_.size(); ++i) {
    HandleKnob* knob = knobs_[i];
    const bool wanted = i < handles_.size() && is_seen(handles_[i]);
    const auto at = wanted ? view_->project(handles_[i].at_mm) : std::nullopt;
    knob->setVisible(at.has_value());
    if (!at) continue;
    const TargetHandle& h = handles_[i];
    knob->move((*at - QPointF(knob->width() / 2.0, knob->height() / 2.0)).toPoint());
    if (h.kind == TargetHandle::Kind::landmark) name_landmark_handle(*knob, h);
    else if (h.of_outline()) name_outline_handle(*knob, i, *at);
    else name_part_handle(*knob, h);
  }
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    QLabel* tag = tag_of(handles_[i]);
    if (tag && tag->isVisibleTo(this)) place_tag(tag, knobs_[i]->geometry().center());
    if (!knobs_[i]->isHidden()) name_place(*knobs_[i], handles_[i]);
  }
}

/// The label beside a handle; nullptr where it has none.
QLabel* TargetView::tag_of(const TargetHandle& handle) const {
  switch (handle.kind) {
    case TargetHandle::Kind::depth: return depth_tag_;
    case TargetHandle::Kind::width:
    case TargetHandle::Kind::size_y:
    case TargetHandle::Kind::rounding:
    case TargetHandle::Kind::growth: return width_tag_;
    case TargetHandle::Kind::landmark: return is_chosen(handle) ? mark_tag_ : nullptr;
    default: return nullptr;
  }
}

void TargetView::name_outline_handle(HandleKnob& knob, std::size_t i, QPointF at) {
  const Outline& t = model_.outline();
  const TargetHandle& h = handles_[i];
  QLabel* tag = tag_of(h);
  QString name, value;
  switch (h.kind) {
    case TargetHandle::Kind::point:
      name = t.shape == "box" ? tr("Middle of the box") : tr("Point %1").arg(i + 1);
      value = tr("%1 across, %2 along").arg(handle_mm(h.at_mm.y), handle_mm(h.at_mm.x));
      break;
    case TargetHandle::Kind::width:
    case TargetHandle::Kind::size_y:
      name = tr("Width");
      value = handle_mm(h.kind == TargetHandle::Kind::width ? t.width_mm : t.box_size_mm.y);
      tag->setText(tr("%1 wide").arg(value));
      break;
    case TargetHandle::Kind::size_x:
      name = tr("Length");
      value = handle_mm(t.box_size_mm.x);
      break;
    case TargetHandle::Kind::depth:
      name = tr("Depth");
      value = handle_mm(t.depth_mm);
      tag->setText(tr("%1 deep").arg(value));
      if (const auto top = view_->project({h.at_mm.x, h.at_mm.y, t.top_mm})) arrow_->span(at, *top);
      break;
    default: break;
  }
  knob.set_handle(h, name, value);
  if (tag) show_tag(*tag);
}

void TargetView::show_tag(QLabel& tag) {
  tag.adjustSize();
  tag.show();
  tag.raise();
}

void TargetView::place_tag(QLabel* tag, QPoint at) {
  // The nearest free place around the handle, below it first.
  static constexpr std::array<QPointF, 6> kWays = {
      QPointF(-0.8, 0.6), QPointF(0.8, 0.6), QPointF(0, 1), QPointF(-1, -0.3), QPointF(1, -0.3), QPointF(0, -1)};
  const auto free = [&](const QRect& place) {
    if (!rect().contains(place)) return false;
    for (const QWidget* other : std::initializer_list<QWidget*>{depth_tag_, width_tag_, mark_tag_, tools_, legend_}) {
      if (other != tag && other->isVisibleTo(this) && other->geometry().intersects(place)) return false;
    }
    return std::ranges::none_of(knobs_, [&](const HandleKnob* knob) {
      return knob->isVisibleTo(this) && knob->geometry().intersects(place);
    });
  };
  for (int far = px(24); far <= px(160); far += px(8)) {
    for (const QPointF& way : kWays) {
      QRect place(QPoint(), tag->size());
      const QPointF reach(way.x() * (far + tag->width() / 2.0), way.y() * (far + tag->height() / 2.0));
      place.moveCenter((QPointF(at) + reach).toPoint());
      if (!free(place)) continue;
      tag->move(place.topLeft());
      return;
    }
  }
  tag->move(at + QPoint(px(18), px(18)));
}

void TargetView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_all();
}

}  // namespace cusp::ui
