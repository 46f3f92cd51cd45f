#include "ui/instructor/import_preview.h"

#include <QApplication>
#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QThreadPool>
#include <algorithm>
#include <cmath>

#include "engine/volume/cut_volume.h"
#include "engine/volume/volume.h"
#include "scenarios/import/quarter_turn.h"
#include "ui/modules.h"
#include "ui/render/patch_feed.h"
#include "ui/text/import_text.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr double kPitch = 0.45;        // radians: shows the front and the occlusal surface
constexpr double kArrowShare = 0.16;   // of the specimen's longest side
constexpr double kRoom = 0.3;          // of the specimen's height, about it
constexpr int kViewWidth = 420, kViewHeight = 340;

/// An arrow above the specimen that points up.
std::vector<OverlayLine> up_arrow(Vec3 low, Vec3 high) {
  const double length = kArrowShare * std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const Vec3 foot(0.5 * (low.x + high.x), 0.5 * (low.y + high.y), high.z + 0.3 * length);
  const Vec3 tip = foot + Vec3(0, 0, length);
  const auto line = [](std::initializer_list<Vec3> points) {
    OverlayLine out;
    for (const Vec3& p : points) out.points_mm.emplace_back(p);
    return out;
  };
  const double side = 0.25 * length;
  return {line({foot, tip}), line({tip - Vec3(side, 0, side), tip, tip - Vec3(-side, 0, side)})};
}

bool warns(RemarkCode code) {
  return code == RemarkCode::shell_capped || code == RemarkCode::parts_overlap || code == RemarkCode::sides_assumed || code == RemarkCode::inside_out;
}

}  // namespace

ImportedSpecimen imported_specimen(VoxelVolume volume) {
  ImportedSpecimen out;
  const auto specimen = Specimen::build(volume, Reading::banded);
  out.mm3 = specimen_solid(*specimen).mm3;
  const Grid& grid = volume.grid;
  out.low_mm = Vec3(1e300);
  out.high_mm = Vec3(-1e300);
  IVec3 v;
  std::size_t i = 0;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x, ++i) {
        if (volume.s[i] < kHalf) continue;
        out.low_mm = glm::min(out.low_mm, grid.centre_mm(v) - 0.5 * grid.voxel_mm);
        out.high_mm = glm::max(out.high_mm, grid.centre_mm(v) + 0.5 * grid.voxel_mm);
      }
  out.patches = std::make_shared<PatchFeed>(FeedSettings{});
  out.patches->build_all(Volume(specimen));
  out.volume = std::make_shared<const VoxelVolume>(std::move(volume));
  return out;
}

ImportPreview::ImportPreview(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(24));
  view_ = new ToothView;
  view_->setAccessibleName(tr("The imported specimen"));
  view_->set_left_turns(true);
  view_->setFixedSize(px(kViewWidth), px(kViewHeight));
  row->addWidget(view_, 0, Qt::AlignTop);
  auto* column = new QVBoxLayout;
  column->setSpacing(px(12));
  row->addLayout(column, 1);
  QLabel* hint = make_label(tr("The arrow points to where the bur comes from: the chewing surface has to look that way. "
                               "A turn by these buttons is kept; the mouse only moves the view."), TextRole::body, Weight::regular, "text2");
  hint->setWordWrap(true);
  column->addWidget(hint);
  turns_ = new QWidget;
  auto* grid = new QGridLayout(turns_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(px(8));
  const struct {
    QString name;
    int axis, quarters;
  } kTurns[] = {{tr("Tip back"), 0, 1},     {tr("Tip forward"), 0, -1}, {tr("Tip left"), 1, 1},
                {tr("Tip right"), 1, -1}, {tr("Turn left"), 2, -1},   {tr("Turn right"), 2, 1}};
  int n = 0;
  for (const auto& [name, axis, quarters] : kTurns) {
    QPushButton* button = make_button(name);
    button->setToolTip(tr("A quarter turn of the specimen about %1").arg(QStringLiteral("xyz")[axis]));
    connect(button, &QPushButton::clicked, this, [this, axis, quarters] { turn(axis, quarters); });
    grid->addWidget(button, n / 2, n % 2);
    ++n;
  }
  column->addWidget(turns_, 0, Qt::AlignLeft);
  facts_ = make_label({}, TextRole::body, Weight::bold);
  warnings_ = make_label({}, TextRole::body, Weight::regular, "look");
  notes_ = make_label({}, TextRole::body, Weight::regular, "text2");
  for (QLabel* label : {facts_, warnings_, notes_}) {
    label->setWordWrap(true);
    column->addWidget(label);
  }
  column->addStretch();
}

void ImportPreview::show_specimen(ImportedSpecimen made, const std::vector<ImportRemark>& remarks) {
  made_ = std::move(made);
  std::vector<ImportRemark> notes;
  QStringList warnings;
  for (const ImportRemark& remark : remarks) {
    if (remark.code == RemarkCode::size_odd) continue;  // ImportSize asks about it
    if (warns(remark.code)) warnings << describe(remark);
    else notes.push_back(remark);
  }
  warnings_->setText(warnings.join(u'\n'));
  warnings_->setVisible(!warnings.isEmpty());
  const QStringList lines = describe(notes);
  notes_->setText(lines.join(u'\n'));
  notes_->setVisible(!lines.isEmpty());
  show_made();
}

void ImportPreview::clear() {
  made_ = {};
  view_->set_feed(nullptr);
  view_->set_lines({});
}

void ImportPreview::show_made() {
  QStringList parts;
  for (std::size_t code = 1; code < kTissueCodes; ++code)
    if (made_.mm3[code] > 0.0)
      parts << QStringLiteral("%1 %2").arg(tissue_name(static_cast<Tissue>(code), made_.volume->names),
                                           format_value({.value = made_.mm3[code], .unit = QStringLiteral("mm³"), .decimals = 1}));
  facts_->setText(size_text(size_mm(), u"mm"_qs) + u'\n' + parts.join(QStringLiteral(" · ")));
  // Space above for the arrow.
  const Vec3 size = size_mm(), middle = 0.5 * (made_.low_mm + made_.high_mm) + Vec3(0, 0, kRoom * 0.25 * size.z);
  Camera camera = Camera::about(middle, (0.5 + kRoom / 4) * std::max(std::hypot(size.x, size.y), (1.0 + kRoom) * size.z));
  camera.set_angles(0.0, kPitch);
  view_->set_camera(camera);
  view_->set_lines(up_arrow(made_.low_mm, made_.high_mm));
  view_->set_feed(made_.patches);
  for (QPushButton* button : turns_->findChildren<QPushButton*>()) button->setEnabled(true);
}

void ImportPreview::turn(int axis, int quarters) {
  if (turning_ || !made_.volume) return;
  turning_ = true;
  // The pressed button stays enabled, as with ButtonWait: a disabled one loses the focus.
  for (QPushButton* button : turns_->findChildren<QPushButton*>()) button->setEnabled(button == window()->focusWidget());
  Q_EMIT turning_changed();
  QThreadPool::globalInstance()->start([self = QPointer<ImportPreview>(this), from = made_.volume, axis, quarters] {
    auto made = std::make_shared<ImportedSpecimen>(imported_specimen(quarter_turned(*from, axis, quarters)));
    QMetaObject::invokeMethod(
        qApp,
        [self, made, from] {
          if (!self) return;
          self->turning_ = false;
          if (self->made_.volume == from) {  // else another specimen replaced it
            self->made_ = std::move(*made);
            self->show_made();
          }
          Q_EMIT self->turning_changed();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace cusp::ui
