#include "ui/device/trim_form.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "ui/device/panel_card.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr double kMmPerM = 1000.0;
constexpr std::array<std::uint8_t, 4> kClutches = {falcon::status::kForward, falcon::status::kMinus, falcon::status::kPlus, 0};
// What a step changed: steps of one field one after another are one.
enum Field { kCentre, kScale, kClutch, kGain, kAll };
const QString kNoPlace = QStringLiteral("–");

std::optional<falcon::Workspace> workspace_of(const FalconTrim& trim) {
  return falcon::Workspace::from({.centre_m = trim.centre_m, .scale = trim.scale});
}

QString millimetres(double mm) { return format({std::round(mm * 10) / 10 + 0.0, {}, QStringLiteral("mm"), 1}); }

}  // namespace

FalconTrim trim_of(const FalconProfile& profile) {
  return {profile.centre_m, profile.scale, profile.clutch, profile.calibration.force_gain};
}

void put_trim(const FalconTrim& trim, FalconProfile& profile) {
  profile.centre_m = trim.centre_m;
  profile.scale = trim.scale;
  profile.clutch = trim.clutch;
  profile.calibration.force_gain = trim.force_gain;
}

struct TrimForm::Inner {
  FalconTrim trim;
  std::vector<FalconTrim> before;
  int last_field = kAll;
  std::optional<falcon::Workspace> workspace;
  Vec3 grip_m = falcon::kMiddleM;

  std::array<NumberField*, 3> centre{};
  QPushButton *here, *undo, *reset;
  NumberField *scale, *gain;
  QComboBox* clutch;
  QLabel* place;
  Chip* held;
};

TrimForm::TrimForm(QWidget* parent) : QWidget(parent), inner_(std::make_unique<Inner>()) {
  Inner& in = *inner_;
  QVBoxLayout* column = make_column(this, 12);
  make_place(column);
  make_start(column);
  make_ratios(column);
  QLabel* note = make_label(tr("Force: 2 N asked for and 1.6 N on a spring scale are 125 %. Measure it before a change, and run the "
                               "self-test again after it."),
                            TextRole::caption, Weight::regular, "text2");
  note->setWordWrap(true);
  column->addWidget(note);
  auto* acts = new QHBoxLayout;
  acts->setSpacing(px(8));
  in.undo = make_button(tr("Undo"), ButtonKind::standard, QStringLiteral("undo"), QKeySequence::Undo);
  in.reset = make_button(tr("The usual values"), ButtonKind::quiet);
  acts->addWidget(in.undo);
  acts->addWidget(in.reset);
  acts->addStretch(1);
  column->addLayout(acts);

  connect_fields();
  connect(in.undo, &QPushButton::clicked, this, &TrimForm::undo);
  connect(in.reset, &QPushButton::clicked, this, &TrimForm::reset);
  set_trim({});
}

void TrimForm::make_place(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* live = new QHBoxLayout;
  live->setSpacing(px(12));
  live->addWidget(make_label(tr("Bur, from where an attempt begins"), TextRole::body, Weight::regular, "text2"));
  in.place = make_label(QStringLiteral("–"), TextRole::body, Weight::bold);
  in.place->setAccessibleDescription(tr("Bur, from where an attempt begins"));
  live->addWidget(in.place);
  in.held = new Chip(tr("held by the clutch"), Chip::Kind::accent);
  in.held->hide();
  live->addWidget(in.held);
  live->addStretch(1);
  column->addLayout(live);
}

void TrimForm::make_start(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* start = new QHBoxLayout;
  start->setSpacing(px(12));
  column->addWidget(make_label(tr("Where the grip stands when an attempt begins, from the middle of its travel:"), TextRole::body, Weight::regular, "text2"));
  const QString ways[] = {tr("Right"), tr("Up"), tr("Nearer")};
  for (std::size_t i = 0; i < in.centre.size(); ++i) {
    auto* box = new NumberField;
    box->setRange(-kMmPerM * kMostCentreShiftM, kMmPerM * kMostCentreShiftM);
    box->setDecimals(0);
    box->setSuffix(QStringLiteral("\u00A0mm"));
    in.centre[i] = box;
    start->addWidget(labelled(ways[i], box), 1);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, i](double mm) {
      FalconTrim wanted = inner_->trim;
      const int axis = static_cast<int>(i);
      wanted.centre_m[axis] = falcon::kMiddleM[axis] + mm / kMmPerM;
      set(wanted, kCentre);
    });
  }
  in.here = make_button(tr("As it stands now"), ButtonKind::standard, QStringLiteral("target"));
  start->addWidget(in.here, 0, Qt::AlignBottom);
  column->addLayout(start);
}

void TrimForm::make_ratios(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* rest = new QHBoxLayout;
  rest->setSpacing(px(12));
  in.scale = new NumberField;
  in.scale->setDecimals(0);
  in.scale->setRange(static_cast<int>(100 * falcon::Workspace::kMinScale), static_cast<int>(100 * falcon::Workspace::kMaxScale));
  in.scale->setSingleStep(5);
  in.scale->setSuffix(QStringLiteral("\u00A0%"));
  rest->addWidget(labelled(tr("Of the hand's way"), in.scale), 1);
  in.gain = new NumberField;
  in.gain->setDecimals(0);
  in.gain->setRange(static_cast<int>(100 * kLeastForceGain), static_cast<int>(100 * kMostForceGain));
  in.gain->setSingleStep(5);
  in.gain->setSuffix(QStringLiteral("\u00A0%"));
  rest->addWidget(labelled(tr("Force: asked over felt"), in.gain), 1);
  in.clutch = new QComboBox;
  in.clutch->addItem(tr("Top button"));
  in.clutch->addItem(tr("Left button, which then changes no bur"));
  in.clutch->addItem(tr("Right button, which then changes no bur"));
  in.clutch->addItem(tr("None"));
  rest->addWidget(labelled(tr("Clutch: the grip moves, the bur stays"), in.clutch), 2);
  column->addLayout(rest);
}

void TrimForm::connect_fields() {
  Inner& in = *inner_;
  connect(in.here, &QPushButton::clicked, this, [this] {
    FalconTrim wanted = inner_->trim;
    for (int i = 0; i < 3; ++i) {
      // In whole millimetres, as the fields show it, and no further out than they let.
      const double mm = std::round(kMmPerM * (inner_->grip_m[i] - falcon::kMiddleM[i]));
      wanted.centre_m[i] = falcon::kMiddleM[i] + std::clamp(mm / kMmPerM, -kMostCentreShiftM, kMostCentreShiftM);
    }
    inner_->last_field = kAll;  // a step of its own
    set(wanted, kCentre);
    inner_->last_field = kAll;
  });
  connect(in.scale, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
    FalconTrim wanted = inner_->trim;
    wanted.scale = percent / 100.0;
    set(wanted, kScale);
  });
  connect(in.gain, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
    FalconTrim wanted = inner_->trim;
    wanted.force_gain = percent / 100.0;
    set(wanted, kGain);
  });
  connect(in.clutch, &QComboBox::activated, this, [this](int index) {
    FalconTrim wanted = inner_->trim;
    wanted.clutch = kClutches[static_cast<std::size_t>(index)];
    set(wanted, kClutch);
  });
}

TrimForm::~TrimForm() = default;

void TrimForm::set_trim(const FalconTrim& trim) {
  inner_->trim = trim;
  inner_->before.clear();
  inner_->last_field = kAll;
  fill();
}

const FalconTrim& TrimForm::trim() const { return inner_->trim; }

void TrimForm::set(const FalconTrim& trim, int field) {
  Inner& in = *inner_;
  if (trim == in.trim) return;
  if (field == kAll || field != in.last_field) in.before.push_back(in.trim);
  in.last_field = field;
  in.trim = trim;
  fill();
  Q_EMIT changed(in.trim);
}

void TrimForm::undo() {
  Inner& in = *inner_;
  if (in.before.empty()) return;
  in.trim = in.before.back();
  in.before.pop_back();
  in.last_field = kAll;
  fill();
  Q_EMIT changed(in.trim);
}

void TrimForm::reset() { set({}, kAll); }

void TrimForm::fill() {
  Inner& in = *inner_;
  const FalconTrim& trim = in.trim;
  for (std::size_t i = 0; i < in.centre.size(); ++i) {
    const int axis = static_cast<int>(i);
    in.centre[i]->show_value(kMmPerM * (trim.centre_m[axis] - falcon::kMiddleM[axis]));
  }
  const QSignalBlocker quiet(in.clutch);
  in.scale->show_value(std::round(100 * trim.scale));
  in.gain->show_value(std::round(100 * trim.force_gain));
  const auto clutch = std::find(kClutches.begin(), kClutches.end(), trim.clutch);
  in.clutch->setCurrentIndex(static_cast<int>(clutch == kClutches.end() ? 0 : clutch - kClutches.begin()));
  in.undo->setEnabled(!in.before.empty());
  in.reset->setEnabled(trim != FalconTrim{});
  in.workspace = workspace_of(trim);
}

void TrimForm::show_grip(const FalconView& view) {
  Inner& in = *inner_;
  in.here->setEnabled(true);
  QString place = kNoPlace;
  bool held = false;
  if (in.workspace) {
    in.grip_m = view.grip_m;
    // As the driver does it.
    if ((view.session.buttons & in.trim.clutch) != 0) {
      in.workspace->hold(view.grip_m);
    } else {
      in.workspace->release(view.grip_m);
    }
    held = in.workspace->held();
    const Vec3 at = in.workspace->specimen_mm(view.grip_m);
    //: Three lengths: right, up and towards the user.
    place = tr("right %1, up %2, nearer %3").arg(millimetres(at.x), millimetres(at.z), millimetres(-at.y));
  }
  if (in.place->text() != place) in.place->setText(place);
  in.held->setVisible(held);
}

void TrimForm::hide_grip() {
  inner_->here->setEnabled(false);
  inner_->place->setText(kNoPlace);
  inner_->held->hide();
}

}  // namespace cusp::ui
