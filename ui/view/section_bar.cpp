#include "ui/view/section_bar.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QSignalBlocker>
#include <QSlider>
#include <QThreadPool>
#include <algorithm>
#include <cmath>
#include <mutex>

#include "scenarios/shapes/target.h"
#include "scenarios/teeth/landmarks.h"
#include "ui/render/target_look.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kSidePx = 12;                                // at 100 %
constexpr double kLeastPictureMm = 24.0, kMmPerPx = 0.05;  // scenery stands beside a single tooth
constexpr double kMostPicturePx = 1200.0;                  // of either side: a jaw is drawn coarser
constexpr double kBelowTopMm = 6.0;                        // the picture's middle, which then holds crown and cervix
constexpr double kPitch = 0.35;                       // radians: the plane and a little of the floor beyond it
constexpr double kTurnsOver = 0.1;                    // sine of the angle by which a camera passes the plane before the picture turns
constexpr double kAtWallMm = 0.8;                     // from the middle: a wall, which the plane then meets at right angles [M]
constexpr double kThroughMiddleMm = 0.05;             // half a step of the slider

}  // namespace

/// The look of a cut's target, made where it is first drawn: leaves of voxels take longer than a frame.
class SectionBar::CutLook {
 public:
  const TargetLook& of(const Cut& cut) {
    std::call_once(made_, [&] { look_.emplace(cut.target, cut.leeway, cut.volume->specimen_ptr()); });
    return *look_;
  }

 private:
  std::once_flag made_;
  std::optional<TargetLook> look_;
};

namespace {

/// A target at its top; nullopt for an empty one.
std::optional<Vec3> middle_of(const TargetShape& shape) {
  return shape.empty() ? std::nullopt : std::optional(Vec3(0.5 * (shape.low() + shape.high()), shape.top_mm()));
}

SectionImage picture_of(const SectionBar::Cut& cut, const TargetLook& look, const SectionPlane& plane, glm::dvec2 size_mm) {
  SectionSettings settings;
  settings.plane = plane;
  settings.mm_per_px = std::max(kMmPerPx, std::max(size_mm.x, size_mm.y) / kMostPicturePx);
  settings.width = static_cast<int>(std::ceil(size_mm.x / settings.mm_per_px));
  settings.height = static_cast<int>(std::ceil(size_mm.y / settings.mm_per_px));
  settings.scenery = cut.scenery;
  look.put_into(settings);
  if (cut.ideal) {
    settings.ghost = cut.ideal;
    settings.target = {};
  }
  return draw_section(*cut.volume, settings);
}

}  // namespace

SectionBar::SectionBar(ToothView& view, QWidget* parent) : QFrame(parent), view_(view) {
  setAccessibleName(tr("Section"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(kSidePx), px(8), px(kSidePx), px(8));
  column->setSpacing(px(6));
  head_ = new QHBoxLayout;
  head_->setSpacing(px(4));
  ways_ = new Segments({tr("Mesiodistal"), tr("Buccolingual")});  // of a tooth: the longer names
  ways_->setAccessibleName(tr("Way of the section"));
  ways_->choose(static_cast<int>(way_));
  head_->addWidget(ways_);
  place_ = make_label({}, TextRole::body, Weight::bold);
  place_->setAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
  head_->addWidget(place_, 1);
  column->addLayout(head_);
  auto* row = new QHBoxLayout;
  row->setSpacing(px(8));
  low_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  high_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setLayoutDirection(Qt::LeftToRight);  // a tooth is not mirrored
  slider_->setPageStep(5);
  slider_->setAccessibleName(tr("Place of the section"));
  row->addWidget(low_);
  row->addWidget(slider_, 1);
  row->addWidget(high_);
  column->addLayout(row);
  connect(ways_, &Segments::changed, this, [this](int index) { choose(static_cast<Way>(index)); });
  connect(slider_, &QSlider::valueChanged, this, [this](int steps) {
    const double to = glm::dot(middle_mm_, across()) + kStepMm * steps;
    through_mm_ += (to - glm::dot(through_mm_, across())) * across();
    show_place();
    draw();
  });
  connect(&view_, &ToothView::camera_changed, this, &SectionBar::follow_camera);
  set_tooth(0);
  hide();
}

void SectionBar::set_tooth(int fdi) {
  fdi_ = mesial_x(fdi) == 0 ? 0 : fdi;
  const QString ways[] = {fdi_ == 0 ? tr("Lengthwise") : tr("Mesiodistal"), fdi_ == 0 ? tr("Crosswise") : tr("Buccolingual")};
  for (int i = 0; i < 2; ++i) {
    ways_->button(i)->setText(ways[i]);
    ways_->button(i)->setAccessibleName(ways[i]);
  }
  show_place();
}

/// The frame's axis that the plane moves along.
Vec3 SectionBar::across() const { return way_ == Way::mesiodistal ? Vec3(0, 1, 0) : Vec3(1, 0, 0); }

void SectionBar::show_cut(Cut cut) {
  const bool other_tooth = !cut_.volume || cut.volume->specimen_ptr() != cut_.volume->specimen_ptr();
  const bool other_target = cut.target != cut_.target;
  if (other_tooth || other_target || cut.leeway != cut_.leeway) look_ = std::make_shared<CutLook>();
  cut_ = std::move(cut);
  if (other_tooth || other_target) measure();
  if (other_tooth && open_) {  // the view was turned to the new tooth
    before_ = view_.camera();
    face();
  }
  draw();
}

/// Middle and reach of the slider. Leaves of voxels are found with the first picture.
void SectionBar::measure() {
  const Grid& grid = cut_.volume->grid();
  low_mm_ = grid.centre_mm(IVec3(0));
  high_mm_ = grid.centre_mm(grid.size - IVec3(1));
  centre_on(middle_of(TargetShape(cut_.target)).value_or(Vec3(0.5 * (low_mm_.x + high_mm_.x), 0.5 * (low_mm_.y + high_mm_.y), high_mm_.z)));
}

/// A plane that was moved stays where it is, within the tooth.
void SectionBar::centre_on(Vec3 middle_mm) {
  const bool moved = through_mm_ != middle_mm_;
  middle_mm_ = glm::clamp(middle_mm, low_mm_, high_mm_);  // a half-space has no end
  through_mm_ = moved ? glm::clamp(through_mm_, low_mm_, high_mm_) : middle_mm_;
  fit_slider();
}

void SectionBar::fit_slider() {
  const QSignalBlocker quiet(slider_);
  const double middle = glm::dot(middle_mm_, across());
  slider_->setRange(static_cast<int>(std::floor((glm::dot(low_mm_, across()) - middle) / kStepMm)),
                    static_cast<int>(std::ceil((glm::dot(high_mm_, across()) - middle) / kStepMm)));
  slider_->setValue(static_cast<int>(std::lround(place_mm() / kStepMm)));
  show_place();
}

double SectionBar::place_mm() const { return glm::dot(through_mm_ - middle_mm_, across()); }

SectionPlane SectionBar::plane() const {
  const Vec3 along = way_ == Way::mesiodistal ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  Vec3 centre = middle_mm_ + place_mm() * across();
  centre.z -= kBelowTopMm;
  return {centre, facing_ * along, {0, 0, 1}};
}

glm::dvec2 SectionBar::picture_mm() const {
  const SectionPlane at = plane();
  const Vec3 reach = glm::max(at.centre_mm - low_mm_, high_mm_ - at.centre_mm);
  return glm::max(2.0 * glm::dvec2(glm::dot(reach, glm::abs(at.right)), reach.z), glm::dvec2(kLeastPictureMm));
}

void SectionBar::open() {
  if (open_) return;
  open_ = true;
  before_ = view_.camera();
  face();
  show();
  draw();
}

void SectionBar::close() {
  if (!open_) return;
  open_ = false;
  hide();
  view_.set_cutaway(std::nullopt);
  view_.set_camera(*before_);
}

void SectionBar::tab_after(QWidget* before) {
  for (QWidget* stop : {static_cast<QWidget*>(ways_->button(0)), static_cast<QWidget*>(ways_->button(1)), static_cast<QWidget*>(slider_)}) {
    QWidget::setTabOrder(before, stop);
    before = stop;
  }
}

void SectionBar::choose(Way way) {
  ways_->choose(static_cast<int>(way));
  if (way == way_) return;
  way_ = way;
  fit_slider();
  face();
  draw();
}

void SectionBar::go_through(Vec3 mm) {
  through_mm_ = mm;
  const Vec3 from_middle = glm::abs(mm - middle_mm_);
  if (std::max(from_middle.x, from_middle.y) > kAtWallMm) choose(from_middle.x > from_middle.y ? Way::mesiodistal : Way::buccolingual);
  fit_slider();
  draw();
}

/// Turns the view to the side of the plane that the viewer is nearer to.
void SectionBar::face() {
  if (!open_) return;
  Camera camera = view_.camera();
  camera.set_preset(way_ == Way::mesiodistal ? PresetView::buccal : PresetView::distal, mesial_x(fdi_));
  camera.set_angles(camera.yaw(), kPitch);
  camera.set_centre(middle_mm_);
  view_.set_camera(camera);
  follow_camera();
}

void SectionBar::follow_camera() {
  if (!open_) return;
  const Vec3 along = way_ == Way::mesiodistal ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const double right = glm::dot(view_.camera().right(), along);
  if (std::abs(right) < kTurnsOver || (right > 0) == (facing_ > 0)) return;
  facing_ = right > 0 ? 1.0 : -1.0;
  draw();
}

void SectionBar::show_place() {
  const bool to_buccal = way_ == Way::mesiodistal;
  const QString oral = fdi_ < 30 ? tr("palatal") : tr("lingual");
  const QString of_x = mesial_x(fdi_) > 0 ? tr("mesial") : tr("distal"), against_x = mesial_x(fdi_) > 0 ? tr("distal") : tr("mesial");
  const QString high = fdi_ == 0 ? QString() : to_buccal ? tr("buccal") : of_x;
  const QString low = fdi_ == 0 ? QString() : to_buccal ? oral : against_x;
  const double mm = place_mm();
  const QString amount = format({fdi_ == 0 ? mm : std::abs(mm), {}, QStringLiteral("mm"), 1});
  //: Where a section goes; %1 is a length, %2 a side of the tooth.
  const QString side = fdi_ == 0 ? amount : tr("%1 %2").arg(amount, mm > 0 ? high : low);
  place_->setText(std::abs(mm) < kThroughMiddleMm ? tr("Through the middle") : side);
  slider_->setAccessibleDescription(place_->text());
  low_->setText(low);
  high_->setText(high);
  low_->setVisible(fdi_ != 0);
  high_->setVisible(fdi_ != 0);
  fit_head();
  Q_EMIT moved();
}

void SectionBar::fit_head() {
  const int inside = width() - 2 * px(kSidePx);
  const bool beside = ways_->minimumSizeHint().width() + px(kSidePx) + place_->sizeHint().width() <= inside;
  head_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  place_->setAlignment((beside ? Qt::AlignTrailing : Qt::AlignLeading) | Qt::AlignVCenter);
}

void SectionBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit_head();
}

/// One picture at a time: a drag asks for the newest alone.
void SectionBar::draw() {
  if (!open_ || !cut_.volume) return;
  if (drawing_) {
    stale_ = true;
    return;
  }
  drawing_ = true;
  stale_ = false;
  QThreadPool::globalInstance()->start([self = QPointer(this), cut = cut_, look = look_, plane = plane(), size_mm = picture_mm()] {
    auto image = std::make_shared<SectionImage>(picture_of(cut, look->of(cut), plane, size_mm));
    QMetaObject::invokeMethod(qApp, [self, image, look, target_mm = middle_of(look->of(cut).shape())] {
      if (self) self->take(std::move(*image), look, target_mm);
    }, Qt::QueuedConnection);
  });
}

void SectionBar::take(SectionImage image, const std::shared_ptr<CutLook>& of, const std::optional<Vec3>& target_mm) {
  drawing_ = false;
  if (of == look_ && target_mm && needs_voxels(cut_.target) && glm::clamp(*target_mm, low_mm_, high_mm_) != middle_mm_) {
    centre_on(*target_mm);
    face();
    return draw();
  }
  if (open_) view_.set_cutaway(std::move(image));
  if (stale_) return draw();
  Q_EMIT shown();
}

}  // namespace cusp::ui
