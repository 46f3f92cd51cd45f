#include "ui/instructor/import_forms.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QIcon>
#include <QLabel>
#include <QPixmap>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/instructor/slice_view.h"
#include "ui/render/colours.h"
#include "ui/text/import_text.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr std::array kTissues = {Tissue::enamel, Tissue::carious_enamel, Tissue::dentine, Tissue::carious_dentine,
                                 Tissue::cementum, Tissue::pulp, Tissue::bone, Tissue::gingiva, Tissue::ligament,
                                 Tissue::amalgam, Tissue::composite, Tissue::plastic};
constexpr int kNothing = -1;         // the range of grey is left out
constexpr int kNotUsed = 0;
constexpr std::size_t kRanges = 4;   // dentine, enamel, metal and one spare
constexpr double kGreySteps = 200.0;  // of a field between the least and the most value of a file
constexpr double kMendMm = 1.0;      // a scanner's gaps are smaller, a jaw's open base is far wider

QPixmap swatch(QColor colour) {
  QPixmap out(px(14), px(14));
  out.fill(colour);
  return out;
}

/// What a mesh is most likely made of, by its name; kNotUsed: the name says nothing. Longer words first: a "carious dentine" is no dentine.
int likely_tissue(const std::string& name) {
  struct Word {
    const char* part;
    Tissue tissue;
  };
  constexpr Word kWords[] = {{"cari", Tissue::carious_dentine}, {"kari", Tissue::carious_dentine}, {"enamel", Tissue::enamel}, {"schmelz", Tissue::enamel},
                             {"dentin", Tissue::dentine},       {"cement", Tissue::cementum},      {"zement", Tissue::cementum}, {"pulp", Tissue::pulp},
                             {"bone", Tissue::bone},            {"knochen", Tissue::bone},         {"gingiva", Tissue::gingiva}, {"gum", Tissue::gingiva},
                             {"zahnfleisch", Tissue::gingiva},  {"ligament", Tissue::ligament},    {"amalgam", Tissue::amalgam}, {"composite", Tissue::composite},
                             {"komposit", Tissue::composite},   {"plastic", Tissue::plastic},      {"typodont", Tissue::plastic}};
  const QString lower = QString::fromStdString(name).toLower();
  for (const Word& word : kWords)
    if (lower.contains(QLatin1StringView(word.part))) return static_cast<int>(word.tissue);
  return kNotUsed;
}

}  // namespace

QComboBox* make_tissue_box(const QString& none, const QString& name) {
  auto* out = new QComboBox;
  out->setAccessibleName(name);
  out->addItem(none, kNotUsed);
  for (const Tissue t : kTissues) {
    const Colour c = tissue_colours()[index_of(t)];
    out->addItem(QIcon(swatch(QColor::fromRgbF(c.r, c.g, c.b))), tissue_name(t), static_cast<int>(t));
  }
  return out;
}

MeshForm::MeshForm(std::vector<MeshInfo> meshes, QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(10));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(px(16));
  grid->setVerticalSpacing(px(8));
  grid->setColumnStretch(4, 1);  // the tissue stands beside its mesh
  const bool several = meshes.size() > 1;
  int line = 0;
  for (MeshInfo& info : meshes) {
    const QString name = QString::fromStdString(info.name);
    QLabel* title = make_label(isolate(name), TextRole::body, Weight::bold);
    title->setWordWrap(true);
    QLabel* size = make_label({}, TextRole::body, Weight::regular, "text2");
    const bool sound = info.closed && info.oriented;
    QLabel* state = make_label({}, TextRole::body, Weight::regular, sound ? "good" : "look");
    state->setWordWrap(true);
    QComboBox* tissue = make_tissue_box(tr("Leave out"), tr("What %1 is made of").arg(name));
    // A lone mesh without a telling name is a crown's surface.
    const int named = likely_tissue(info.name);
    const int likely = several || named != kNotUsed ? named : static_cast<int>(Tissue::enamel);
    grid->addWidget(title, line, 0, Qt::AlignVCenter);
    grid->addWidget(size, line, 1, Qt::AlignVCenter);
    grid->addWidget(state, line, 2, Qt::AlignVCenter);
    grid->addWidget(tissue, line, 3, Qt::AlignVCenter);
    connect(tissue, &QComboBox::currentIndexChanged, this, [this, n = rows_.size()] {
      Row& row = rows_[n];
      if (row.usable) row.wanted = row.tissue->currentData().toInt();
      Q_EMIT changed();
    });
    rows_.push_back({std::move(info), size, state, tissue, likely, likely});
    ++line;
  }
  column->addLayout(grid);
  if (several) add_precedence(*column);
  add_mending(*column);  // a closed mesh needs it too: a tooth can be inside out beside another, or there twice
  show_states();
}

void MeshForm::add_mending(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  mend_ = new QCheckBox(tr("Mend: join, turn and close holes up to"));
  mend_->setChecked(true);
  width_ = new NumberField;
  width_->setLocale(QLocale());
  width_->setRange(0.0, 100.0);
  width_->setValue(kMendMm);
  width_->setSuffix(QChar(0x00A0) + QStringLiteral("mm"));
  width_->setAccessibleName(tr("Widest hole that is closed"));
  row->addWidget(mend_);
  row->addWidget(width_);
  row->addStretch();
  column.addLayout(row);
  column.addWidget(width_->note());
  connect(mend_, &QCheckBox::toggled, this, [this](bool on) {
    width_->setEnabled(on);
    show_states();
    Q_EMIT changed();
  });
  connect(width_, &QDoubleSpinBox::valueChanged, this, [this] {
    show_states();
    Q_EMIT changed();
  });
}

void MeshForm::add_precedence(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  precedence_ = new QComboBox;
  precedence_->addItem(tr("the one inside wins"));  // in the order of PartPrecedence
  precedence_->addItem(tr("the upper one of this list wins"));
  precedence_->setAccessibleName(tr("Where parts overlap"));
  row->addWidget(make_label(tr("Where parts overlap,")));
  row->addWidget(precedence_);
  row->addStretch();
  column.addLayout(row);
  connect(precedence_, &QComboBox::currentIndexChanged, this, &MeshForm::changed);
}

void MeshForm::set_unit_mm(double unit_mm) {
  unit_mm_ = unit_mm;
  show_states();
}

void MeshForm::take_choices(const MeshForm& before) {
  const QSignalBlocker quiet(this);
  mend_->setChecked(before.mend_->isChecked());
  width_->setValue(before.width_->value());
  if (before.precedence_) precedence_->setCurrentIndex(before.precedence_->currentIndex());
  for (std::size_t n = 0; n < before.rows_.size() && n < rows_.size(); ++n) {
    const Row& was = before.rows_[n];
    if (was.wanted == was.likely) continue;  // a guess, which other meshes may change
    rows_[n].wanted = was.wanted;
    if (rows_[n].usable) rows_[n].tissue->setCurrentIndex(rows_[n].tissue->findData(was.wanted));
  }
}

std::optional<double> MeshForm::mend_mm() const {
  return mend_ && mend_->isChecked() ? std::optional(width_->value()) : std::nullopt;
}

PartPrecedence MeshForm::precedence() const {
  return precedence_ ? static_cast<PartPrecedence>(precedence_->currentIndex()) : PartPrecedence::innermost;
}

void MeshForm::show_states() {
  const auto mend = mend_mm();
  for (Row& row : rows_) {
    const MeshInfo& m = row.info;
    row.size->setText(size_text((m.high - m.low) * unit_mm_, u"mm"_qs));
    bool usable = m.closed && m.oriented;
    if (usable) {
      row.state->setText(tr("closed"));
    } else if (m.closed) {
      usable = mend.has_value();
      row.state->setText(tr("wound against itself at %1").arg(place_text(m.turned_at * unit_mm_)));
    } else if (!m.gaps.empty()) {
      const MeshGap& widest = m.gaps.front();
      const double width = widest.width() * unit_mm_;
      usable = mend && m.left_open * unit_mm_ <= *mend;  // a seam of unjoined points is as wide as its mesh
      const QString mm = format_value({.value = width, .unit = QStringLiteral("mm"), .decimals = 2});
      row.state->setText(tr("%n gap(s), the widest of %1 at %2", nullptr, static_cast<int>(m.gap_count))
                             .arg(mm, place_text(widest.middle() * unit_mm_)));
    }
    row.tissue->setEnabled(usable);
    if (usable != row.usable) {
      row.usable = false;  // what is set here is nobody's choice
      row.tissue->setCurrentIndex(usable ? row.tissue->findData(row.wanted) : 0);
    }
    row.usable = usable;
    row.tissue->setToolTip(usable ? QString() : tr("An open surface cannot be made of anything: mend it first."));
  }
}

std::vector<std::pair<std::string, Tissue>> MeshForm::chosen() const {
  std::vector<std::pair<std::string, Tissue>> out;
  for (const Row& row : rows_) {
    const int code = row.tissue->currentData().toInt();
    if (code > 0) out.emplace_back(row.info.name, static_cast<Tissue>(code));
  }
  return out;
}

Vec3 MeshForm::size_of(bool chosen_alone) const {
  Vec3 low(1e300), high(-1e300);
  for (const Row& row : rows_) {
    if (chosen_alone && row.tissue->currentData().toInt() == 0) continue;
    low = glm::min(low, row.info.low);
    high = glm::max(high, row.info.high);
  }
  return rows_.empty() ? Vec3(0.0) : high - low;
}
Vec3 MeshForm::size() const { return size_of(!chosen().empty()); }
Vec3 MeshForm::whole_size() const { return size_of(false); }

VolumeForm::VolumeForm(const ImageInfo& info, std::shared_ptr<const ImagePreview> preview, QWidget* parent)
    : QWidget(parent), info_(info) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(24));
  auto* column = new QVBoxLayout;
  column->setSpacing(px(10));
  row->addLayout(column, 1);
  if (info_.specimen) {
    QLabel* ready = make_label(tr("This is a specimen of Cusp’s own: it is taken as it stands."));
    ready->setWordWrap(true);
    column->addWidget(ready);
    column->addStretch();
    return;
  }
  column->addWidget(info_.kind == ImageKind::grey ? make_ranges(*preview) : make_labels());
  largest_ = new QCheckBox(tr("Only the largest component"));
  hollows_ = new QCheckBox(tr("Closed hollows are pulp"));
  for (QCheckBox* box : {largest_, hollows_}) {
    box->setChecked(info_.kind == ImageKind::grey && box == largest_);
    column->addWidget(box);
    connect(box, &QCheckBox::toggled, this, &VolumeForm::changed);
  }
  column->addStretch();
  view_ = new SliceView;
  view_->show_preview(std::move(preview), info_.kind, info_.size);
  row->addWidget(view_, 0, Qt::AlignTop);
  show_tissues();
}

QWidget* VolumeForm::make_labels() {
  auto* out = new QWidget;
  auto* grid = new QGridLayout(out);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(px(16));
  grid->setVerticalSpacing(px(6));
  grid->setColumnStretch(2, 1);
  int line = 0;
  for (const auto& [value, voxels] : info_.values) {
    const bool colours = info_.kind == ImageKind::colours;
    const QString name = colours ? QColor::fromRgb(value).name() : QLocale().toString(value);
    QComboBox* tissue = make_tissue_box(tr("Leave out"), tr("What %1 is made of").arg(name));
    // A label that is a tissue code most likely means that tissue.
    if (!colours) tissue->setCurrentIndex(std::max(0, tissue->findData(static_cast<int>(value))));
    auto* sign = new QLabel;
    if (colours) sign->setPixmap(swatch(QColor::fromRgb(value)));
    grid->addWidget(sign, line, 0);
    grid->addWidget(make_label(isolate(name), TextRole::body, Weight::bold), line, 1);
    grid->addWidget(make_label(tr("%n voxel(s)", nullptr, static_cast<int>(voxels)), TextRole::body, Weight::regular, "text2"), line, 2);
    grid->addWidget(tissue, line, 3);
    connect(tissue, &QComboBox::currentIndexChanged, this, &VolumeForm::show_tissues);
    labels_.push_back({value, tissue});
    ++line;
  }
  return out;
}

QWidget* VolumeForm::make_ranges(const ImagePreview& preview) {
  auto* out = new QWidget;
  auto* grid = new QGridLayout(out);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(px(12));
  grid->setVerticalSpacing(px(6));
  grid->setColumnStretch(3, 1);
  const auto suggested = suggested_thresholds(preview.value);
  constexpr std::array first = {Tissue::dentine, Tissue::enamel};
  const double step = (info_.high - info_.low) / kGreySteps;
  // A µCT holds attenuations below 3, a probability ends at 1.
  const int decimals = step > 0.0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, 9) : 0;
  const double unit = std::pow(10.0, -decimals);
  for (std::size_t i = 0; i < kRanges; ++i) {
    QComboBox* tissue = make_tissue_box(tr("Not used"), tr("Tissue of range %1").arg(i + 1));
    tissue->insertItem(1, tr("Nothing: left out"), kNothing);
    auto* from = new NumberField;
    from->setLocale(QLocale());
    from->setDecimals(decimals);
    from->setRange(std::floor(info_.low / unit) * unit, (std::ceil(info_.high / unit) + 1.0) * unit);
    from->setSingleStep(std::max(1.0, std::round(step / unit)) * unit);
    from->setAccessibleName(tr("Least value of range %1").arg(i + 1));
    from->setValue(i < suggested.size() ? suggested[i] : info_.high);
    if (i < first.size()) tissue->setCurrentIndex(tissue->findData(static_cast<int>(first[i])));
    QLabel* label = make_label(tr("from"), TextRole::body, Weight::regular, "text2");
    grid->addWidget(tissue, static_cast<int>(i), 0);
    grid->addWidget(label, static_cast<int>(i), 1);
    grid->addWidget(from, static_cast<int>(i), 2);
    const auto follow = [this, tissue, from] {
      from->setEnabled(tissue->currentData().toInt() != kNotUsed);
      show_tissues();
    };
    from->setEnabled(tissue->currentData().toInt() != kNotUsed);
    connect(tissue, &QComboBox::currentIndexChanged, this, follow);
    connect(from, &QDoubleSpinBox::valueChanged, this, &VolumeForm::show_tissues);
    ranges_.push_back({tissue, from});
  }
  return out;
}

ImageTissues VolumeForm::tissues() const {
  ImageTissues out;
  for (const Label& label : labels_) {
    const int code = label.tissue->currentData().toInt();
    if (code > 0) out.labels.emplace_back(label.value, static_cast<Tissue>(code));
  }
  for (const Range& range : ranges_) {
    const int code = range.tissue->currentData().toInt();
    if (code != kNotUsed) out.thresholds.emplace_back(range.from->value(), code == kNothing ? Tissue::empty : static_cast<Tissue>(code));
  }
  std::ranges::stable_sort(out.thresholds, {}, [](const auto& t) { return t.first; });
  // Of two ranges with one first value the later row counts.
  for (std::size_t i = 1; i < out.thresholds.size();) {
    if (out.thresholds[i].first == out.thresholds[i - 1].first) out.thresholds.erase(out.thresholds.begin() + static_cast<std::ptrdiff_t>(i - 1));
    else ++i;
  }
  if (hollows_ && hollows_->isChecked()) out.hollows = Tissue::pulp;
  out.largest_component = largest_ && largest_->isChecked();
  return out;
}

bool VolumeForm::ready() const {
  if (info_.specimen) return true;
  const ImageTissues t = tissues();
  return !t.labels.empty() || std::ranges::any_of(t.thresholds, [](const auto& p) { return p.second != Tissue::empty; });
}

void VolumeForm::show_tissues() {
  if (view_) {
    const ImageTissues t = tissues();
    view_->set_tissues([t](float value) {
      if (!t.thresholds.empty()) return tissue_at(static_cast<double>(value), t.thresholds);
      for (const auto& [label, tissue] : t.labels) {
        if (value > 0.0f && static_cast<std::uint32_t>(value) == label) return tissue;
      }
      return Tissue::empty;
    });
  }
  Q_EMIT changed();
}

}  // namespace cusp::ui
