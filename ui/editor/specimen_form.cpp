#include "ui/editor/specimen_form.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <filesystem>
#include <optional>

#include "scenarios/format/ranges.h"
#include "scenarios/format/validate.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/nrrd_image.h"
#include "scenarios/specimens/taken_codes.h"
#include "scenarios/teeth/tooth.h"
#include "storage/base/files.h"
#include "ui/editor/form_parts.h"
#include "ui/editor/free_name.h"
#include "ui/editor/landmarks_form.h"
#include "ui/editor/specimen_grower.h"
#include "ui/editor/tooth_form.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr double kMostSeed = 999999;  // six digits
constexpr double kDefaultVoxelMm = 0.1;
constexpr int kDefaultTooth = 36;

QString quadrant_name(int fdi) {
  switch (fdi / 10) {
    case 1: return SpecimenForm::tr("%1, upper right").arg(fdi);
    case 2: return SpecimenForm::tr("%1, upper left").arg(fdi);
    case 3: return SpecimenForm::tr("%1, lower left").arg(fdi);
    default: return SpecimenForm::tr("%1, lower right").arg(fdi);
  }
}

QWidget* rows_group(QVBoxLayout** column) {
  auto* box = new QWidget;
  *column = new QVBoxLayout(box);
  (*column)->setContentsMargins(0, 0, 0, 0);
  (*column)->setSpacing(px(6));
  return box;
}

/// The file's name as an exercise may hold it: of no other folder or drive, and not hidden.
std::string name_beside_the_draft(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  std::ranges::replace_if(name, [](char c) { return c == ':' || c == '\\' || static_cast<unsigned char>(c) < 0x20; }, '_');
  name.erase(0, std::min(name.find_first_not_of('.'), name.size()));
  return name.empty() ? "volume.nrrd" : name;
}

/// Usual figures, but those of the author where the tissue was there. The paper's block has the paper's, and a code without a key means
/// another tissue in a grown tooth than in a file.
std::vector<ScenarioTissue> tissues_of_file(const std::vector<Tissue>& tissues, const Scenario& before) {
  const bool from_file = before.specimen.generator.empty();
  std::vector<ScenarioTissue> out = usual_tissues(tissues);
  for (ScenarioTissue& t : out) {
    const bool means_the_same = from_file || (before.specimen.grown_fdi() != 0 && index_of(t.tissue) < kTissueKeys.size());
    const auto kept = std::ranges::find(before.tissues, t.tissue, &ScenarioTissue::tissue);
    if (means_the_same && kept != before.tissues.end()) t = *kept;
  }
  return out;
}

/// A box that the panel's width limits, not its longest entry.
void shrinks(QComboBox& box) {
  box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box.setMinimumContentsLength(8);
}

}  // namespace

QString fineness_refusal(double voxel_mm) {
  if (stated_voxel_mm(voxel_mm)) return {};
  const NumberRange& edge = *range_of("/specimen/voxel_mm");
  int decimals = 3;
  const auto mm = [&decimals](double value) { return format({value, {}, QStringLiteral("mm"), decimals}); };
  while (decimals < 6 && (mm(voxel_mm) == mm(edge.least) || mm(voxel_mm) == mm(edge.most))) ++decimals;
  return SpecimenForm::tr("The fineness of this volume is %1; an exercise takes %2 to %3.").arg(mm(voxel_mm), mm(edge.least), mm(edge.most));
}

QString specimen_name(const SpecimenSource& source) {
  if (source.generator == "tooth") return quadrant_name(source.fdi);
  if (source.generator == "block") return SpecimenForm::tr("Practice block");
  if (source.generator == "layered-block") return SpecimenForm::tr("Block of two materials");
  if (source.generator == "paper-block") return SpecimenForm::tr("Block of three materials");
  return QFileInfo(QString::fromStdString(source.volume)).fileName();
}

void add_teeth(QComboBox& box) {
  for (const int quadrant : {1, 2, 3, 4}) {
    for (int n = 1; n <= 8; ++n) box.addItem(quadrant_name(10 * quadrant + n), 10 * quadrant + n);
  }
  shrinks(box);
}

SpecimenForm::SpecimenForm(EditorModel& model, const Ports& ports, QWidget* parent)
    : QWidget(parent), model_(model), ports_(ports) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(12), px(12), px(12), px(12));
  column->setSpacing(px(8));
  column->addWidget(make_label(tr("Change the tooth"), TextRole::section, Weight::bold));
  band_ = new Band;
  column->addWidget(band_);
  kind_ = new QComboBox;
  for (const char* key : {"tooth", "block", "layered-block", "paper-block", ""}) {
    SpecimenSource s;
    s.generator = key;
    const QString name = s.generator == "tooth" ? tr("Tooth") : s.generator.empty() ? tr("From a file") : specimen_name(s);
    kind_->addItem(name, QString::fromLatin1(key));
  }
  shrinks(*kind_);
  column->addWidget(labelled(tr("Kind"), kind_));
  make_rows(*column);
  auto* buttons = new QHBoxLayout;
  use_ = make_button(tr("Use it"), ButtonKind::standard, u"check"_qs);
  QPushButton* leave = make_button(tr("Back"), ButtonKind::quiet);
  buttons->addWidget(use_);
  buttons->addWidget(leave);
  buttons->addStretch();
  column->addLayout(buttons);
  column->addStretch();
  connect(kind_, &QComboBox::currentIndexChanged, this, &SpecimenForm::fit);
  connect(tooth_, &QComboBox::activated, this, &SpecimenForm::change_tooth);
  connect(use_, &QPushButton::clicked, this, &SpecimenForm::use);
  connect(leave, &QPushButton::clicked, this, &SpecimenForm::done);
  connect(&model_, &EditorModel::specimen_changed, this, &SpecimenForm::follow_model);
  follow_model();
}

void SpecimenForm::make_rows(QVBoxLayout& column) {
  QVBoxLayout* rows = nullptr;
  tooth_rows_ = rows_group(&rows);
  tooth_ = new QComboBox;
  add_teeth(*tooth_);
  rows->addWidget(labelled(tr("Tooth"), tooth_));
  seed_ = new NumberBox(model_, tr("Variation"), {}, 0, kMostSeed, 1, 0, [this](double seed) {
    if (!tooth_stands()) return true;  // the button takes it with the rest
    SpecimenSource source = model_.scenario().specimen;
    source.seed = static_cast<std::uint64_t>(seed);
    return model_.set_tooth(source, u"seed"_qs);
  });
  seed_->setToolTip(tr("Another number grows another tooth of its kind; 0 is the average"));
  seed_->setSpecialValueText(tr("average"));
  add_row(rows, tr("Variation"), seed_);
  column.addWidget(tooth_rows_);
  grown_rows_ = rows_group(&rows);
  voxel_ = new NumberBox(model_, tr("Fineness"), u"mm"_qs, kMinToothVoxelMm, kMaxToothVoxelMm, 0.01, 3, [this](double mm) {
    if (!tooth_stands()) return true;
    SpecimenSource source = model_.scenario().specimen;
    source.voxel_mm = mm;
    return model_.set_tooth(source, u"voxel"_qs);
  });
  add_row(rows, tr("Fineness"), voxel_);
  column.addWidget(grown_rows_);
  details_ = new ToothForm(model_);
  column.addWidget(details_);
  file_rows_ = rows_group(&rows);
  file_ = make_label({}, TextRole::body, Weight::regular, "text2");
  file_->setWordWrap(true);
  rows->addWidget(file_);
  QPushButton* choose = make_button(tr("Choose a volume…"), ButtonKind::standard, u"import"_qs);
  rows->addWidget(choose);
  connect(choose, &QPushButton::clicked, this, &SpecimenForm::pick);
  column.addWidget(file_rows_);
  landmarks_ = new LandmarksForm(model_);
  column.addWidget(landmarks_);
}

void SpecimenForm::follow_model() {
  const SpecimenSource& s = model_.scenario().specimen;
  const QSignalBlocker quiet(kind_);
  kind_->setCurrentIndex(std::max(kind_->findData(QString::fromStdString(s.generator)), 0));
  tooth_->setCurrentIndex(tooth_->findData(s.fdi > 0 ? s.fdi : kDefaultTooth));
  seed_->show_value(static_cast<double>(s.seed));
  voxel_->show_value(s.generator.empty() ? kDefaultVoxelMm : s.voxel_mm);
  file_->setText(s.volume.empty() ? tr("No file chosen yet.") : isolate(breakable(QString::fromStdString(s.volume), kWholeInPanel)));
  fit();
}

void SpecimenForm::fit() {
  const QString kind = kind_->currentData().toString();
  tooth_rows_->setVisible(kind == u"tooth");
  grown_rows_->setVisible(kind == u"tooth" || kind == u"block" || kind == u"layered-block");
  file_rows_->setVisible(kind.isEmpty());
  landmarks_->setVisible(file_stands());
  details_->setVisible(tooth_stands());
  use_->setVisible(!kind.isEmpty() && !tooth_stands());
}

bool SpecimenForm::tooth_stands() const {
  return model_.scenario().specimen.generator == "tooth" && kind_->currentData().toString() == u"tooth";
}

bool SpecimenForm::file_stands() const {
  return model_.takes_landmarks() && !model_.scenario().specimen.volume.empty() && kind_->currentData().toString().isEmpty();
}

void SpecimenForm::change_tooth() {
  if (!tooth_stands()) return;
  SpecimenSource source = model_.scenario().specimen;
  source.fdi = tooth_->currentData().toInt();
  keep_possible_lesions(source);
  model_.end_gesture();
  model_.set_tooth(source, u"fdi"_qs);
  model_.end_gesture();
}

void SpecimenForm::use() {
  SpecimenSource source;
  source.generator = kind_->currentData().toString().toStdString();
  source.voxel_mm = voxel_->value();
  if (source.generator == "paper-block") {
    // The paper's grid; the exercise states the voxel size.
    source.voxel_mm = 10.0 / 128.0;
  } else if (source.generator == "tooth") {
    source.fdi = tooth_->currentData().toInt();
    source.seed = static_cast<std::uint64_t>(seed_->value());
  }
  take(source, usual_tissues(source.generator));
}

void SpecimenForm::pick() {
  ports_.pick_file(this, {tr("Choose a volume"), {}, tr("Volumes (*.nrrd)"), false}, [this](const QString& path) { copy_beside(path.toStdString()); });
}

void SpecimenForm::copy_beside(const std::filesystem::path& from) {
  const auto volume = read_nrrd(from);
  const auto refusal = volume ? refuse_taken_codes(*volume, from.filename().string()) : std::optional(volume.error());
  if (refusal) {
    const Message message = describe(*refusal);
    band_->show_message(Band::Kind::bad, message.what, message.more);
    return;
  }
  if (const QString refused = fineness_refusal(volume->grid.voxel_mm); !refused.isEmpty()) {
    band_->show_message(Band::Kind::bad, refused,
                        nrrd_is_specimen(from) ? tr("Nothing was changed. Make it anew from its scan or its surfaces.")
                                               : tr("Nothing was changed. The import in the library makes it coarser or finer."));
    return;
  }
  // A new name: an earlier step of undo may mean a file of the old one.
  const std::filesystem::path folder = model_.folder();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::string wanted = name_beside_the_draft(from);
  std::optional<ImportFailure> unwritten;  // a writer of volumes has another list of causes
  const auto write = [&](const std::filesystem::path& file) -> Stored<void> {
    const auto written = write_nrrd(*volume, file);
    if (written) return {};
    unwritten = written.error();
    unwritten->where = wanted;
    return fail(StorageError::io, file.string());
  };
  const auto name = error ? Stored<std::string>(std::unexpected(failure_from(error, folder)))
                          : write_under_free_name(folder, wanted, {nullptr, write});
  if (!name) {
    const Message message = unwritten ? describe(*unwritten) : describe(name.error());
    band_->show_message(Band::Kind::bad, message.what, message.more);
    return;
  }
  SpecimenSource source;
  source.volume = *name;
  source.voxel_mm = *stated_voxel_mm(volume->grid.voxel_mm);
  const SpecimenFacts facts = facts_of(*volume);
  put_on(source, facts.tissues, model_.landmarks_on(facts));
}

void SpecimenForm::put_on(const SpecimenSource& source, const std::vector<Tissue>& tissues, const SpecimenLandmarks& kept) {
  const std::vector<ScenarioTissue> figures = tissues_of_file(tissues, model_.scenario());
  if (kept.marks.empty()) return take(source, figures);
  const auto count = [](const SpecimenLandmarks& of) { return QLocale().toString(static_cast<qulonglong>(of.marks.size())); };
  //: %1, %2: numbers of landmarks
  const QString more = tr("%1 of %2 lie on the new volume. Keep them if it shows the same tooth in the same place.").arg(count(kept), count(model_.landmarks()));
  const Question question{.what = tr("Keep the landmarks?"), .more = more, .act = tr("Keep them"), .stay = tr("Leave them out")};
  ports_.ask(this, question, [self = QPointer(this), source, figures, kept](bool keeps) {
    if (!self) return;
    SpecimenSource marked = source;
    if (keeps) marked.landmarks = kept;
    self->take(marked, figures);
  });
}

void SpecimenForm::take(const SpecimenSource& source, const std::vector<ScenarioTissue>& tissues) {
  if (!model_.set_specimen(source, tissues)) {
    band_->show_message(Band::Kind::bad, tr("This tooth cannot be used."), tr("Nothing was changed."));
    return;
  }
  band_->clear();
  Q_EMIT done();
}

}  // namespace cusp::ui
