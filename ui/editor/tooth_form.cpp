#include "ui/editor/tooth_form.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <functional>

#include "scenarios/format/keys.h"
#include "scenarios/teeth/caries.h"
#include "ui/editor/form_parts.h"
#include "ui/modules.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr std::size_t kMostLesions = 4;  // most lesions of one tooth
constexpr double kLeastSizeMm = 0.4, kMostLesionSizeMm = 5.0, kMostLesionDepthMm = 4.0;

Lesion::Kind kind_of(const std::string& key) {
  return key == "proximal" ? Lesion::Kind::proximal : key == "root" ? Lesion::Kind::root : Lesion::Kind::fissure;
}

/// A change of the lesion with this number, if the tooth has it.
std::function<void(SpecimenSource&)> on_lesion(std::size_t index, std::function<void(LesionSource&)> act) {
  return [index, act = std::move(act)](SpecimenSource& s) {
    if (index < s.lesions.size()) act(s.lesions[index]);
  };
}

QString site_name(const std::string& kind, const std::string& site) {
  if (kind == "fissure") {
    if (site == "central") return ToothForm::tr("Central pit");
    if (site == "mesial") return ToothForm::tr("Mesial pit");
    if (site == "distal") return ToothForm::tr("Distal pit");
  } else {
    if (site == "mesial") return ToothForm::tr("Mesial");
    if (site == "distal") return ToothForm::tr("Distal");
    if (site == "buccal") return ToothForm::tr("Buccal");
    if (site == "lingual") return ToothForm::tr("Lingual");
  }
  return QString::fromStdString(site);
}

bool stands_round(const SpecimenSource& source, std::string_view key) {
  return std::ranges::find(source.around, key) != source.around.end();
}

/// Keys in the order of the format: equal choices give equal exercises.
void add_around(SpecimenSource& source, std::string_view key) {
  if (!stands_round(source, key)) source.around.emplace_back(key);
  std::ranges::sort(source.around, {}, [](const std::string& k) { return std::ranges::find(kAroundKeys, k) - kAroundKeys.begin(); });
}

}  // namespace

void keep_possible_lesions(SpecimenSource& source) {
  std::erase_if(source.lesions, [&](const LesionSource& lesion) {
    const auto sites = lesion_sites(source.fdi, kind_of(lesion.kind));
    return std::ranges::find(sites, lesion.site) == sites.end();
  });
}

ToothForm::ToothForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(6));
  const auto box = [&](QBoxLayout* to, const QString& text) {
    auto* out = new QCheckBox(text);
    to->addWidget(out);
    return out;
  };
  plastic_ = box(column, tr("Plastic, as a training model"));
  connect(plastic_, &QCheckBox::toggled, this, [this](bool on) {
    edit_at_once(u"plastic"_qs, [on](SpecimenSource& s) {
      s.typodont = on;
      if (on) s.lesions.clear();
    });
  });
  column->addSpacing(px(4));
  add_section(column, tr("Round the tooth"));
  neighbours_ = box(column, tr("Neighbouring teeth"));
  gums_ = box(column, tr("Gums"));
  bone_ = box(column, tr("Bone"));
  jaw_ = box(column, tr("The rest of the jaw"));
  jaw_->setToolTip(tr("To look at: only the tooth, its neighbours and what lies about them can be drilled"));
  const std::pair<QCheckBox*, const char*> around[] = {{neighbours_, "neighbours"}, {gums_, "gingiva"}, {bone_, "bone"}, {jaw_, "jaw"}};
  for (const auto& [check, key] : around) connect(check, &QCheckBox::toggled, this, [this, key](bool on) { on ? surround_with(key) : take_away(key); });
  column->addSpacing(px(4));
  lesions_ = new QWidget;
  auto* inside = new QVBoxLayout(lesions_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(px(6));
  add_section(inside, tr("Carious lesions"));
  list_ = new QVBoxLayout;
  list_->setSpacing(px(6));
  inside->addLayout(list_);
  add_ = make_button(tr("Add a carious lesion"), ButtonKind::standard, u"plus"_qs);
  inside->addWidget(add_, 0, Qt::AlignLeft);
  column->addWidget(lesions_);
  QLabel* note = make_label(tr("How caries spreads, and how gums and bone lie, is general knowledge, not verified."), TextRole::caption,
                            Weight::regular, "text2");
  note->setWordWrap(true);
  column->addWidget(note);
  connect(add_, &QPushButton::clicked, this, &ToothForm::add_lesion);
  connect(&model_, &EditorModel::changed, this, &ToothForm::follow_model);
  follow_model();
}

bool ToothForm::edit(const QString& field, const std::function<void(SpecimenSource&)>& change) {
  SpecimenSource source = model_.scenario().specimen;
  if (source.generator != "tooth") return false;
  change(source);
  return model_.set_tooth(source, field);
}

void ToothForm::edit_at_once(const QString& field, const std::function<void(SpecimenSource&)>& change) {
  model_.end_gesture();
  edit(field, change);
  model_.end_gesture();
}

// A jaw includes the neighbours.
void ToothForm::surround_with(std::string_view key) {
  edit_at_once(u"around"_qs, [&](SpecimenSource& s) {
    add_around(s, key);
    if (key == "jaw") add_around(s, "neighbours");
  });
}

void ToothForm::take_away(std::string_view key) {
  edit_at_once(u"around"_qs, [&](SpecimenSource& s) {
    std::erase(s.around, key);
    if (key == "neighbours") std::erase(s.around, "jaw");
  });
}

void ToothForm::add_lesion() {
  edit_at_once(u"lesions"_qs, [](SpecimenSource& s) {
    // The first place without a lesion.
    for (const std::string_view kind : kLesionKeys) {
      for (const std::string& site : lesion_sites(s.fdi, kind_of(std::string(kind)))) {
        const bool taken = std::ranges::any_of(s.lesions, [&](const LesionSource& l) { return l.kind == kind && l.site == site; });
        if (taken) continue;
        LesionSource fresh;
        fresh.kind = kind;
        fresh.site = site;
        s.lesions.push_back(fresh);
        return;
      }
    }
  });
}

void ToothForm::fill_kinds(QComboBox& box, const LesionSource& lesion) const {
  box.clear();
  for (const std::string_view key : kLesionKeys) {
    const bool possible = !lesion_sites(model_.scenario().specimen.fdi, kind_of(std::string(key))).empty();
    if (!possible && key != lesion.kind) continue;  // a file may have a kind that the tooth cannot have
    const QString name = key == "fissure" ? tr("In a fissure") : key == "proximal" ? tr("Between teeth") : tr("On the root");
    box.addItem(name, QString::fromLatin1(key.data(), static_cast<qsizetype>(key.size())));
  }
}

void ToothForm::fill_sites(QComboBox& box, const LesionSource& lesion) const {
  box.clear();
  for (const std::string& site : lesion_sites(model_.scenario().specimen.fdi, kind_of(lesion.kind))) {
    box.addItem(site_name(lesion.kind, site), QString::fromStdString(site));
  }
  // A file may have another key for a fissure.
  const QString own = QString::fromStdString(lesion.site);
  if (box.findData(own) < 0) box.addItem(site_name(lesion.kind, lesion.site), own);
}

void ToothForm::add_figures(LesionRow& row, QVBoxLayout* column, std::size_t index) {
  const QString field = u"lesion/%1/"_qs.arg(index);
  const int number = static_cast<int>(index) + 1;
  // The form shows the diameter; scenario.json holds the radius.
  row.size = new NumberBox(model_, tr("Width of carious lesion %1").arg(number), u"mm"_qs, kLeastSizeMm, kMostLesionSizeMm, 0.1, 1,
                           [=, this](double mm) { return edit(field + u"size"_qs, on_lesion(index, [mm](LesionSource& l) { l.radius_mm = mm / 2; })); });
  add_row(column, tr("Width"), row.size);
  row.depth = new NumberBox(model_, tr("Depth of carious lesion %1").arg(number), u"mm"_qs, 0, kMostLesionDepthMm, 0.1, 1,
                            [=, this](double mm) { return edit(field + u"depth"_qs, on_lesion(index, [mm](LesionSource& l) { l.depth_mm = mm; })); });
  row.depth_label = add_row(column, tr("Depth"), row.depth);
  row.softness = new NumberBox(model_, tr("Softness of carious lesion %1").arg(number), u"%"_qs, 0, 100, 5, 0,
                               [=, this](double share) { return edit(field + u"soft"_qs, on_lesion(index, [share](LesionSource& l) { l.softness = share / 100; })); });
  row.softness->setToolTip(tr("How far from its middle to its rim the lesion is soft; the rest is firm"));
  add_row(column, tr("Soft"), row.softness);
}

ToothForm::LesionRow ToothForm::make_row(std::size_t index) {
  LesionRow row{};
  auto* card = new QWidget;
  auto* column = new QVBoxLayout(card);
  column->setContentsMargins(0, 0, 0, px(6));
  column->setSpacing(px(4));
  const QString field = u"lesion/%1/"_qs.arg(index);
  const int number = static_cast<int>(index) + 1;
  auto* head = new QHBoxLayout;
  head->setSpacing(px(4));
  row.kind = new QComboBox;
  row.site = new QComboBox;
  for (QComboBox* box : {row.kind, row.site}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(6);
  }
  row.kind->setAccessibleName(tr("Kind of carious lesion %1").arg(number));
  row.site->setAccessibleName(tr("Place of carious lesion %1").arg(number));
  head->addWidget(row.kind, 1);
  QToolButton* remove = make_icon_button(u"minus"_qs, tr("Remove carious lesion %1").arg(number));
  remove->setFocusPolicy(Qt::StrongFocus);  // a number that is half typed goes to this lesion, not to the next one
  head->addWidget(remove);
  column->addLayout(head);
  column->addWidget(row.site);
  connect(row.kind, &QComboBox::activated, this, [this, index, field, box = row.kind](int) {
    const std::string kind = box->currentData().toString().toStdString();
    const auto sites = lesion_sites(model_.scenario().specimen.fdi, kind_of(kind));
    edit_at_once(field + u"kind"_qs, on_lesion(index, [&](LesionSource& l) {
      l.kind = kind;
      if (std::ranges::find(sites, l.site) == sites.end() && !sites.empty()) l.site = sites.front();
    }));
  });
  connect(row.site, &QComboBox::activated, this, [this, index, field, box = row.site](int) {
    edit_at_once(field + u"site"_qs, on_lesion(index, [&](LesionSource& l) { l.site = box->currentData().toString().toStdString(); }));
  });
  connect(remove, &QToolButton::clicked, this, [this, index] {
    edit_at_once(u"lesions"_qs, [index](SpecimenSource& s) {
      if (index < s.lesions.size()) s.lesions.erase(s.lesions.begin() + static_cast<std::ptrdiff_t>(index));
    });
  });
  add_figures(row, column, index);
  list_->addWidget(card);
  return row;
}

void ToothForm::follow_model() {
  const SpecimenSource& s = model_.scenario().specimen;
  const QSignalBlocker q1(plastic_), q2(neighbours_), q3(gums_), q4(bone_), q5(jaw_);
  plastic_->setChecked(s.typodont);
  neighbours_->setChecked(stands_round(s, "neighbours") || stands_round(s, "jaw"));
  gums_->setChecked(stands_round(s, "gingiva"));
  bone_->setChecked(stands_round(s, "bone"));
  jaw_->setChecked(stands_round(s, "jaw"));
  lesions_->setVisible(!s.typodont);
  add_->setEnabled(s.lesions.size() < kMostLesions);
  while (rows_.size() > s.lesions.size()) {
    // A row may be the sender of this signal, so it is deleted later.
    QLayoutItem* last = list_->takeAt(list_->count() - 1);
    last->widget()->hide();
    last->widget()->deleteLater();
    delete last;
    rows_.pop_back();
  }
  while (rows_.size() < s.lesions.size()) rows_.push_back(make_row(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const LesionSource& l = s.lesions[i];
    LesionRow& row = rows_[i];
    fill_kinds(*row.kind, l);
    fill_sites(*row.site, l);
    row.kind->setCurrentIndex(row.kind->findData(QString::fromStdString(l.kind)));
    row.site->setCurrentIndex(row.site->findData(QString::fromStdString(l.site)));
    row.size->show_value(2 * l.radius_mm);
    row.depth->show_value(l.depth_mm);
    row.softness->show_value(100 * l.softness);
    row.depth_label->setText(l.kind == "root" ? tr("Depth") : tr("Depth in dentine"));
  }
}

}  // namespace cusp::ui
