#include "ui/instructor/import_page.h"

#include <QApplication>
#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QThreadPool>
#include <QUrl>
#include <algorithm>
#include <cmath>

#include "scenarios/import/worker.h"
#include "ui/app/import_words.h"
#include "ui/app/sentences.h"
#include "ui/instructor/import_forms.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp {
namespace {

constexpr double kDefaultVoxelMm = 0.1;
constexpr double kSmallMm = 2.0, kLargeMm = 250.0;  // below and above, no tooth and no jaw: the unit is asked again

/// One of the import's own answers, told on the window's thread while the page is still there.
template <class Answer>
void answer_to(const QPointer<ImportPage>& page, const std::shared_ptr<std::stop_source>& work, Answer answer) {
  QMetaObject::invokeMethod(
      qApp,
      [page, work, answer] {
        if (page && !work->stop_requested()) answer();
      },
      Qt::QueuedConnection);
}

QStringList local_files(const QMimeData* data) {
  QStringList out;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) out << url.toLocalFile();
  return out;
}

}  // namespace

ImportPage::ImportPage(const Ports& ports, std::filesystem::path database, QWidget* parent)
    : QWidget(parent), ports_(ports), database_(std::move(database)) {
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Import a specimen"));
  setAcceptDrops(true);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* outer = nullptr;
  whole->addWidget(make_scroll_page(&outer));
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(12));
  QPushButton* back = make_button(tr("Library"), ButtonKind::quiet, u"chevron_left"_qs, QKeySequence(Qt::ALT | Qt::Key_Left));
  outer->addWidget(back, 0, Qt::AlignLeft);
  outer->addWidget(new PageHead(tr("Import a specimen")));
  band_ = new Band;
  outer->addWidget(band_);
  files_card_ = new Card(tr("Files"));
  build_files(files_card_->body());
  outer->addWidget(files_card_);
  parts_card_ = new Card(tr("What it is made of"));
  about_ = make_label({}, TextRole::body, false, "text2");
  about_->setWordWrap(true);
  parts_card_->body()->addWidget(about_);
  outer->addWidget(parts_card_);
  size_card_ = new Card(tr("Size"));
  build_size(size_card_->body());
  outer->addWidget(size_card_);
  outer->addStretch();
  connect(back, &QPushButton::clicked, this, &ImportPage::back_wanted);
  show_files();
  setFocusProxy(pick_);
}

ImportPage::~ImportPage() {
  if (work_) work_->request_stop();
}

void ImportPage::build_files(QVBoxLayout* body) {
  auto* row = new QHBoxLayout;
  row->setSpacing(px(12));
  names_ = make_label({}, TextRole::body, false, "text2");
  names_->setWordWrap(true);
  row->addWidget(names_, 1);
  clear_ = make_button(tr("Begin anew"), ButtonKind::quiet);
  row->addWidget(clear_, 0, Qt::AlignTop);
  pick_ = make_button(tr("Choose a file…"), ButtonKind::standard, u"import"_qs, QKeySequence::Open);
  row->addWidget(pick_, 0, Qt::AlignTop);
  body->addLayout(row);
  busy_ = new Busy;
  body->addWidget(busy_);
  connect(pick_, &QPushButton::clicked, this, [this] {
    ports_.pick_file(this,
                     {tr("Choose a file"), {},
                      tr("Meshes and volumes (*.stl *.obj *.ply *.3ds *.nrrd *.mha *.mhd *.nii *.nii.gz *.hdr *.binvox *.dcm *.ima);;All files (*)"),
                      false},
                     [this](const QString& path) { open_file(path); });
  });
  connect(clear_, &QPushButton::clicked, this, [this] {
    band_->clear();
    files_.clear();
    forget_forms();
    show_files();
  });
  connect(busy_, &Busy::cancelled, this, [this] {
    end_work();
    if (!mesh_form_ && !volume_form_) files_.clear();
    show_files();
    band_->show_message(Band::Kind::info, tr("Importing was stopped."), tr("Nothing was kept."));
  });
}

void ImportPage::build_size(QVBoxLayout* body) {
  auto* numbers = new QHBoxLayout;
  numbers->setSpacing(px(16));
  const auto number = [&](double least, double most, double value, int decimals) {
    auto* box = new QDoubleSpinBox;
    box->setLocale(QLocale());
    box->setDecimals(decimals);
    box->setRange(least, most);
    box->setValue(value);
    box->setSingleStep(value / 10);
    box->setSuffix(QChar(0x00A0) + QStringLiteral("mm"));
    box->setFixedWidth(px(140));
    return box;
  };
  unit_ = new QComboBox;
  const QStringList names = {tr("Millimetre"), tr("Centimetre"), tr("Metre"), tr("Inch"), tr("Micrometre")};
  for (std::size_t i = 0; i < kUsualUnitsMm.size(); ++i) unit_->addItem(names[static_cast<qsizetype>(i)], kUsualUnitsMm[i]);
  unit_->addItem(tr("Another"), 0.0);
  other_unit_ = number(0.0001, 1000, 1, 4);
  voxel_ = number(0.02, 5, kDefaultVoxelMm, 3);
  up_ = new QComboBox;
  for (const std::string_view key : kUpAxisKeys) up_->addItem(QString::fromLatin1(key.data(), static_cast<int>(key.size())));
  up_->setMinimumWidth(px(80));
  unit_field_ = labelled(tr("One unit of the file is"), unit_);
  other_field_ = labelled(tr("Its length"), other_unit_);
  for (QWidget* field : {unit_field_, other_field_, labelled(tr("Fineness"), voxel_), labelled(tr("Chewing surface looks to"), up_)})
    numbers->addWidget(field);
  numbers->addStretch();
  body->addLayout(numbers);
  size_ = make_label({}, TextRole::body, true);
  size_->setWordWrap(true);
  body->addWidget(size_);
  unit_hint_ = make_label({}, TextRole::body, false, "look");
  unit_hint_->setWordWrap(true);
  body->addWidget(unit_hint_);
  import_ = make_large_button(tr("Make a specimen"), ButtonKind::primary);
  body->addWidget(import_, 0, Qt::AlignLeft);
  connect(unit_, &QComboBox::currentIndexChanged, this, &ImportPage::show_size);
  connect(other_unit_, &QDoubleSpinBox::valueChanged, this, &ImportPage::show_size);
  connect(voxel_, &QDoubleSpinBox::valueChanged, this, &ImportPage::show_size);
  connect(import_, &QPushButton::clicked, this, [this] {
    if (kept_) Q_EMIT edit_wanted(*kept_);
    else run();
  });
}

void ImportPage::dragEnterEvent(QDragEnterEvent* event) {
  if (work_ || local_files(event->mimeData()).isEmpty()) return;
  set_kind(files_card_, "drop");
  event->acceptProposedAction();
}

void ImportPage::dragLeaveEvent(QDragLeaveEvent*) { set_kind(files_card_, "card"); }

void ImportPage::dropEvent(QDropEvent* event) {
  set_kind(files_card_, "card");
  const QStringList paths = local_files(event->mimeData());
  if (work_ || paths.isEmpty()) return;
  event->acceptProposedAction();
  open_files(paths);
}

void ImportPage::begin_work(const QString& what) {
  if (work_) work_->request_stop();
  work_ = std::make_shared<std::stop_source>();
  band_->clear();
  busy_->start(what, true);
  show_files();
}

void ImportPage::end_work() {
  if (work_) work_->request_stop();
  work_.reset();
  busy_->finish();
  show_files();
}

void ImportPage::tell_failure(const ImportFailure& failure) {
  const Told told = tell(failure);
  band_->show_message(Band::Kind::bad, told.what, told.more);
}

void ImportPage::forget_forms() {
  kept_.reset();
  image_.reset();
  for (QWidget* form : {static_cast<QWidget*>(mesh_form_), static_cast<QWidget*>(volume_form_)})
    if (form) form->deleteLater();
  mesh_form_ = nullptr;
  volume_form_ = nullptr;
}

void ImportPage::show_files() {
  const bool idle = !work_, shown = mesh_form_ || volume_form_;
  QStringList names;
  for (const auto& file : files_) names << isolate(QString::fromStdString(file.filename().string()));
  names_->setText(names.isEmpty() ? tr("Drop files here, or choose them: closed meshes (STL, OBJ, PLY, 3DS; several are put together), "
                                       "volumes (NRRD, MetaImage, NIfTI, binvox) or a slice of a CT (DICOM).")
                                  : names.join(QStringLiteral(", ")));
  pick_->setText(mesh_form_ ? tr("Add a file…") : tr("Choose a file…"));
  pick_->setEnabled(idle);
  clear_->setVisible(!files_.empty());
  clear_->setEnabled(idle);
  parts_card_->setVisible(shown);
  size_card_->setVisible(shown);
  parts_card_->setEnabled(idle);
  show_size();
}

void ImportPage::open_files(const QStringList& paths) {
  std::vector<std::filesystem::path> chosen;
  for (const QString& path : paths) chosen.emplace_back(path.toStdString());
  const bool meshes = std::ranges::all_of(chosen, [](const auto& f) { return file_kind(f) == FileKind::mesh; });
  if (meshes && mesh_form_) {
    for (auto& file : chosen)
      if (std::ranges::find(files_, file) == files_.end()) files_.push_back(std::move(file));
  } else {
    files_ = std::move(chosen);
  }
  forget_forms();
  look();
}

void ImportPage::look() {
  begin_work(tr("Reading the file"));
  QThreadPool::globalInstance()->start([files = files_, work = work_, self = QPointer<ImportPage>(this)] {
    const auto progress = [&](double share) {
      answer_to(self, work, [self, share] {
        self->busy_->set_progress(share, QLocale().toString(qRound(100 * share)) + QChar(0x00A0) + u'%');
      });
    };
    auto seen = std::make_shared<Result<FileLook, ImportFailure>>(look_in_child(files, {}, progress, work->get_token()));
    answer_to(self, work, [self, seen] {
      self->end_work();
      if (*seen) return self->show_look(std::move(**seen));
      self->files_.clear();
      self->show_files();
      self->tell_failure(seen->error());
    });
  });
}

void ImportPage::show_look(FileLook look) {
  forget_forms();
  about_->setVisible(look.image.has_value());
  if (look.image) {
    image_ = look.image;
    const ImageInfo& i = *image_;
    QString text = tr("%1 × %2 × %3 voxels of %4.").arg(i.size.x).arg(i.size.y).arg(i.size.z).arg(size_text(i.spacing_mm, u"mm"_qs, 3));
    if (i.slices > 0) text += u' ' + tr("%n slice(s) of a CT, in the order of their places.", nullptr, static_cast<int>(i.slices));
    if (i.series > 1) text += u' ' + tr("The largest of %n series was taken.", nullptr, static_cast<int>(i.series));
    if (i.slices > 0) text += u' ' + tr("Nothing about the patient is read.");
    about_->setText(text);
    volume_form_ = new VolumeForm(i, std::make_shared<ImagePreview>(std::move(look.preview)));
    parts_card_->body()->addWidget(volume_form_);
    connect(volume_form_, &VolumeForm::changed, this, &ImportPage::show_size);
    const double least = std::min({i.spacing_mm.x, i.spacing_mm.y, i.spacing_mm.z});
    voxel_->setValue(std::clamp(least, voxel_->minimum(), voxel_->maximum()));
    unit_->setCurrentIndex(0);
  } else {
    mesh_form_ = new MeshForm(std::move(look.meshes));
    parts_card_->body()->addWidget(mesh_form_);
    connect(mesh_form_, &MeshForm::changed, this, &ImportPage::show_size);
    const Vec3 size = mesh_form_->size();
    unit_->setCurrentIndex(unit_->findData(guessed_unit_mm(std::max({size.x, size.y, size.z}))));
  }
  show_files();
}

bool ImportPage::asks_unit() const { return mesh_form_ || (image_ && !image_->spacing_known); }

double ImportPage::unit_mm() const {
  if (!asks_unit()) return 1.0;
  const double usual = unit_->currentData().toDouble();
  return usual > 0.0 ? usual : other_unit_->value();
}

void ImportPage::show_size() {
  unit_field_->setVisible(asks_unit());
  other_field_->setVisible(asks_unit() && unit_->currentData().toDouble() == 0.0);
  const bool own = image_ && image_->specimen;
  voxel_->setEnabled(!own && !kept_);
  up_->setEnabled(!own && !kept_);
  import_->setText(kept_ ? tr("Go on to the exercise") : tr("Make a specimen"));
  if (!mesh_form_ && !volume_form_) return;
  const double unit = unit_mm();
  Vec3 size(0.0);
  bool ready = false;
  if (mesh_form_) {
    const QSignalBlocker quiet(mesh_form_);
    mesh_form_->set_unit_mm(unit);
    size = mesh_form_->size() * unit;
    ready = !mesh_form_->chosen().empty();
    size_->setText(ready ? tr("The specimen will be %1.").arg(size_text(size, u"mm"_qs))
                         : tr("With this unit the file is %1. Say what each mesh is made of.").arg(size_text(size, u"mm"_qs)));
  } else {
    size = Vec3(image_->size) * image_->spacing_mm * unit;
    ready = volume_form_->ready();
    const Vec3 spacing = image_->spacing_mm * unit;
    const bool cubes = std::ranges::all_of(std::array{spacing.x, spacing.y, spacing.z},
                                           [&](double s) { return std::abs(s - voxel_->value()) <= 1e-3 * voxel_->value(); });
    QString text = tr("The volume is %1.").arg(size_text(size, u"mm"_qs));
    if (!cubes && !own) {
      text += u' ' + tr("Its voxels of %1 are resampled to cubes of %2.")
                         .arg(size_text(spacing, u"mm"_qs, 3), format_value({.value = voxel_->value(), .unit = QStringLiteral("mm"), .decimals = 3}));
    }
    size_->setText(text);
  }
  const double longest = std::max({size.x, size.y, size.z});
  const bool odd = asks_unit() && (longest < kSmallMm || longest > kLargeMm);
  unit_hint_->setVisible(odd);
  unit_hint_->setText(longest < kSmallMm ? tr("That is smaller than any tooth. Is the unit right?")
                                         : tr("That is larger than any jaw. Is the unit right?"));
  import_->setEnabled((ready || kept_) && !work_);
}

void ImportPage::run() {
  begin_work(tr("Making the specimen"));
  std::function<Result<VoxelVolume, ImportFailure>(const ImportProgress&, std::stop_token, std::vector<ImportRemark>&)> job;
  const auto up = static_cast<UpAxis>(up_->currentIndex());
  if (mesh_form_) {
    MeshImport what;
    what.path = files_.front();
    what.more.assign(files_.begin() + 1, files_.end());
    what.unit_mm = unit_mm();
    what.voxel_mm = voxel_->value();
    what.tissues = mesh_form_->chosen();
    what.mend_holes_mm = mesh_form_->mend_mm();
    what.up = up;
    job = [what](const ImportProgress& p, std::stop_token stop, std::vector<ImportRemark>& r) { return import_mesh_in_child(what, {}, p, std::move(stop), &r); };
  } else {
    ImageImport what;
    what.path = files_.front();
    what.tissues = volume_form_->tissues();
    what.tissues.unit_mm = unit_mm();
    what.tissues.voxel_mm = voxel_->value();
    what.tissues.up = up;
    job = [what](const ImportProgress& p, std::stop_token stop, std::vector<ImportRemark>& r) { return import_image_in_child(what, {}, p, std::move(stop), &r); };
  }
  QThreadPool::globalInstance()->start([job = std::move(job), work = work_, self = QPointer<ImportPage>(this)] {
    const auto progress = [&](double share) {
      answer_to(self, work, [self, share] {
        self->busy_->set_progress(share, QLocale().toString(qRound(100 * share)) + QChar(0x00A0) + u'%');
      });
    };
    auto remarks = std::make_shared<std::vector<ImportRemark>>();
    auto volume = std::make_shared<Result<VoxelVolume, ImportFailure>>(job(progress, work->get_token(), *remarks));
    answer_to(self, work, [self, volume, remarks] {
      self->end_work();
      if (*volume) {
        self->keep(**volume, *remarks);
      } else {
        self->tell_failure(volume->error());
      }
    });
  });
}

void ImportPage::keep(const VoxelVolume& volume, const std::vector<ImportRemark>& remarks) {
  // A CT's files are often called after the patient.
  const bool ct = image_ && image_->slices > 0;
  const std::string name = ct ? tr("CT").toStdString() : QFileInfo(QString::fromStdString(files_.front().string())).completeBaseName().toStdString();
  const auto start = exercise_on(volume, name, database_);
  if (!start) return tell_failure(start.error());
  if (remarks.empty()) return Q_EMIT edit_wanted(*start);
  kept_ = *start;
  QStringList said;
  for (const ImportRemark& remark : remarks) said << tell(remark);
  band_->show_message(Band::Kind::info, tr("The specimen is made."), said.join(u' '));
  parts_card_->setEnabled(false);
  show_size();
  import_->setFocus();
}

}  // namespace cusp
