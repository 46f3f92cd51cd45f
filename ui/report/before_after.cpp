#include "ui/report/before_after.h"

#include <QCoreApplication>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QThreadPool>

#include "ui/render/target_look.h"
#include "ui/report/pinned_tooth.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kLine = 1, kNameSide = 12;  // px at 100 %: between the teeth; of a name from the corner

}  // namespace

BeforeAfter::BeforeAfter(PinnedTooth* after, std::shared_ptr<const Volume> volume, const Scenario& scenario, QWidget* parent)
    : QWidget(parent), after_(after), before_name_(make_name(tr("Before"))), after_name_(make_name(tr("After"))), volume_(std::move(volume)), scenario_(scenario) {
  after_->setParent(this);
  connect(after_->view(), &ToothView::camera_changed, this, [this] {
    if (before_ != nullptr) before_->set_camera(after_->view()->camera());
  });
  connect(after_, &PinnedTooth::scenery_came, this, [this] {
    if (before_ != nullptr) before_->set_scenery(after_->scenery());
  });
}

QFrame* BeforeAfter::make_name(const QString& text) {
  auto* card = new QFrame(this);
  card->setProperty("kind", u"card"_qs);
  card->setAutoFillBackground(true);
  auto* row = new QHBoxLayout(card);
  row->setContentsMargins(px(12), px(4), px(12), px(4));
  row->addWidget(make_label(text, TextRole::body, Weight::bold));
  card->adjustSize();
  card->hide();
  return card;
}

void BeforeAfter::show_teeth(Shown shown) {
  if (!volume_ || shown == shown_) return;
  shown_ = shown;
  if (before_ == nullptr) make_before();
  before_->setVisible(shown == Shown::both);
  // Its card would cover half of a half.
  after_->show_pin(shown == Shown::both ? PinnedTooth::Pin::hidden : PinnedTooth::Pin::shown);
  place_all();
}

void BeforeAfter::make_before() {
  before_ = new ToothView(this);
  before_->lower();  // the page's tools stand over it
  before_->setAccessibleName(tr("The tooth before this attempt"));
  before_->set_left_turns(true);
  before_->set_target_shown(false);
  before_->set_camera(after_->view()->camera());
  before_->set_scenery(after_->scenery());
  connect(before_, &ToothView::camera_changed, this, [this] { after_->view()->set_camera(before_->camera()); });
  QThreadPool::globalInstance()->start([self = QPointer(this), specimen = volume_->specimen_ptr(), target = scenario_.target, leeway = scenario_.leeway] {
    auto mesh = std::make_shared<WholeMesh>(PatchFeed::build_mesh(Volume(specimen), TargetLook(target, leeway, specimen).feed()));
    QMetaObject::invokeMethod(qApp, [self, mesh] {
      if (!self) return;
      self->before_->show_mesh(std::move(*mesh));
      self->before_->set_camera(self->after_->view()->camera());
      self->before_shown_ = true;
    }, Qt::QueuedConnection);
  });
}

void BeforeAfter::place_all() {
  const bool both = shown_ == Shown::both;
  const int half = (width() - px(kLine)) / 2;
  // What came first stands where reading begins.
  const bool mirrored = isRightToLeft();
  const QRect first(mirrored ? width() - half : 0, 0, half, height()), second(mirrored ? 0 : width() - half, 0, half, height());
  after_->setGeometry(both ? second : rect());
  if (before_ != nullptr) before_->setGeometry(first);
  for (QFrame* name : {before_name_, after_name_}) {
    const QRect& of = name == before_name_ ? first : second;
    name->move(of.left() + px(kNameSide), of.bottom() - name->height() - px(kNameSide));
    name->setVisible(both);
    name->raise();
  }
}

void BeforeAfter::resizeEvent(QResizeEvent*) { place_all(); }

}  // namespace cusp::ui
