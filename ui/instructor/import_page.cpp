#include "ui/instructor/import_page.h"

#include <QApplication>
#include <QBoxLayout>
#include <QFileInfo>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QThreadPool>
#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/import/limits.h"
#include "scenarios/import/size_question.h"
#include "scenarios/import/up_axis.h"
#include "scenarios/import/worker.h"
#include "scenarios/specimens/taken_codes.h"
#include "ui/editor/specimen_form.h"
#include "ui/instructor/import_drop.h"
#include "ui/instructor/import_forms.h"
#include "ui/instructor/import_preview.h"
#include "ui/instructor/import_size.h"
#include "ui/instructor/size_picture.h"
#include "ui/modules.h"
#include "ui/text/import_text.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/bar_top.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

/// Calls `answer` on the GUI thread if the page still exists and `work` is not cancelled.
template <class Answer>
void answer_to(const QPointer<ImportPage>& page, const std::shared_ptr<std::stop_source>& work, Answer answer) {
  QMetaObject::invokeMethod(
      qApp,
      [page, work, answer] {
        if (page && !work->stop_requested()) answer();
      },
      Qt::QueuedConnection);
}

/// A stated unit can be wrong too. A whole volume may be longer than a jaw, but its voxels are a scanner's.
bool no_scan_of_a_tooth(Vec3 size_mm, Vec3 spacing_mm) {
  return std::min({spacing_mm.x, spacing_mm.y, spacing_mm.z}) > VolumeLimits{}.max_voxel_mm ||
         std::max({size_mm.x, size_mm.y, size_mm.z}) < kLeastBelievedMm;
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
  whole->setSpacing(0);
  const BarTop top = make_bar_top();
  QPushButton* back = add_way_back(top, tr("Library"));
  top.row->addWidget(make_label(tr("Import a specimen"), TextRole::section, Weight::bold));
  top.row->addStretch();
  whole->addWidget(top.bar);
  QVBoxLayout* outer = nullptr;
  whole->addWidget(make_scroll_page(&outer), 1);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(12));
  band_ = new Band;
  outer->addWidget(band_);
  drop_card_ = new ImportDrop;
  first_pick_ = drop_card_->button();
  connect(drop_card_, &ImportDrop::choose, this, &ImportPage::pick_files);
  outer->addWidget(drop_card_, 1);
  files_card_ = new Card(tr("Files"));
  build_files(files_card_->body());
  outer->addWidget(files_card_);
  parts_card_ = new Card(tr("What it is made of"));
  about_ = make_label({}, TextRole::body, Weight::regular, "text2");
  about_->setWordWrap(true);
  parts_card_->body()->addWidget(about_);
  outer->addWidget(parts_card_);
  size_card_ = new Card(tr("Size"));
  size_ = new ImportSize;
  auto* beside = new QHBoxLayout;
  beside->setSpacing(px(24));
  auto* form = new QVBoxLayout;
  form->setSpacing(px(16));
  form->addWidget(size_);
  size_picture_ = new SizePicture;
  import_ = make_large_button(tr("Make a specimen"), ButtonKind::primary);
  import_->setObjectName(u"make"_qs);
  form->addWidget(import_, 0, Qt::AlignLeft);
  form->addStretch();
  beside->addLayout(form, 1);
  beside->addWidget(size_picture_, 0, Qt::AlignTop);
  size_card_->body()->addLayout(beside);
  outer->addWidget(size_card_);
  made_card_ = new Card(tr("The specimen, before it is kept"));
  build_made(made_card_->body());
  outer->addWidget(made_card_);
  connect(import_, &QPushButton::clicked, this, &ImportPage::run);
  connect(size_, &ImportSize::changed, this, &ImportPage::forget_made);
  connect(size_, &ImportSize::confirmed, this, &ImportPage::show_size);
  outer->addStretch();
  connect(back, &QPushButton::clicked, this, &ImportPage::leave);
  show_files();
  setFocusProxy(first_pick_);
}

ImportPage::~ImportPage() {
  if (work_) work_->request_stop();
}

void ImportPage::build_files(QVBoxLayout* body) {
  auto* row = new QHBoxLayout;
  row->setSpacing(px(12));
  names_ = make_label({}, TextRole::body, Weight::regular, "text2");
  names_->setWordWrap(true);
  row->addWidget(names_, 1);
  clear_ = make_button(tr("Begin anew"), ButtonKind::quiet);
  row->addWidget(clear_, 0, Qt::AlignTop);
  pick_ = make_button(tr("Choose a file…"), ButtonKind::standard, u"import"_qs, QKeySequence::Open);
  row->addWidget(pick_, 0, Qt::AlignTop);
  body->addLayout(row);
  busy_ = new Busy;
  body->addWidget(busy_);
  connect(pick_, &QPushButton::clicked, this, &ImportPage::pick_files);
  connect(clear_, &QPushButton::clicked, this, [this] {
    band_->clear();
    files_.clear();
    forget_forms();
    show_files();
    first_pick_->setFocus();
  });
  connect(busy_, &Busy::shown, busy_, &Busy::focus_cancel);  // all else but the way back is off meanwhile
  connect(busy_, &Busy::cancelled, this, [this] {
    take_back_files();
    end_look();
    band_->show_message(Band::Kind::info, tr("Importing was stopped."), tr("Nothing was kept."));
  });
}

void ImportPage::build_made(QVBoxLayout* body) {
  preview_ = new ImportPreview;
  body->addWidget(preview_);
  keep_ = make_large_button(tr("Keep it and make an exercise"), ButtonKind::primary);
  body->addWidget(keep_, 0, Qt::AlignLeft);
  connect(keep_, &QPushButton::clicked, this, &ImportPage::keep);
  connect(preview_, &ImportPreview::turning_changed, this, &ImportPage::show_size);
}

void ImportPage::begin_work(const QString& what) {
  if (work_) work_->request_stop();
  work_ = std::make_shared<std::stop_source>();
  band_->clear();
  busy_->start(what, Busy::Cancel::offered);
  show_files();
}

void ImportPage::end_work() {
  if (work_) work_->request_stop();
  work_.reset();
  busy_->finish();
  show_files();
}

/// The button that was pressed was off meanwhile: Qt hands the focus to the way back, where Enter would leave the page.
void ImportPage::end_look() {
  end_work();
  (files_.empty() ? first_pick_ : pick_)->setFocus(Qt::OtherFocusReason);
}

void ImportPage::show_failure(const ImportFailure& failure) {
  const Message message = describe(failure);
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

void ImportPage::show_apart(const ImportFailure& failure) {
  if (failure.code != ImportError::unknown_format) return show_failure(failure);
  band_->show_message(Band::Kind::bad, tr("These files are not opened together."),
                      tr("%1 does not go with the others. Surfaces go together, and slices of one CT. Choose any other file alone, and of a header with its data the header.")
                          .arg(isolate(QString::fromStdString(failure.where))));
}

void ImportPage::forget_forms() {
  preview_->clear();
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
  names_->setText(names.join(QStringLiteral(", ")));
  drop_card_->setVisible(idle && files_.empty());
  files_card_->setVisible(!idle || !files_.empty());
  const QString pick = mesh_form_ ? tr("Add a file…") : tr("Choose a file…");
  pick_->setText(u' ' + pick);  // as make_button: the style leaves no space after the sign
  pick_->setAccessibleName(pick);
  for (QPushButton* button : {pick_, first_pick_}) {
    button->setShortcut(QKeySequence::Open);  // a new text takes the shortcut away; a hidden button has none
    button->setEnabled(idle);
  }
  clear_->setVisible(!files_.empty());
  clear_->setEnabled(idle);
  parts_card_->setVisible(shown);
  size_card_->setVisible(shown);
  parts_card_->setEnabled(idle);
  size_->setEnabled(idle);
  show_size();
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
    const bool several = files.size() > 1;
    answer_to(self, work, [self, seen, several] {
      if (!*seen) self->take_back_files();
      self->end_look();
      if (!*seen) return several ? self->show_apart(seen->error()) : self->show_failure(seen->error());
      self->show_look(std::move(**seen));
    });
  });
}

void ImportPage::show_look(FileLook look) {
  const std::unique_ptr<MeshForm> before(std::exchange(joins_, false) ? std::exchange(mesh_form_, nullptr) : nullptr);
  files_before_.reset();
  forget_forms();
  about_->setVisible(look.image.has_value());
  if (look.image) {
    image_ = look.image;
    const ImageInfo& i = *image_;
    QString text = tr("%1 × %2 × %3 voxels of %4.").arg(i.size.x).arg(i.size.y).arg(i.size.z).arg(size_text(i.spacing_mm, u"mm"_qs, 3));
    if (i.slices > 0) text += u' ' + tr("%n slice(s) of a CT, in the order of their places.", nullptr, static_cast<int>(i.slices));
    if (i.series > 1) text += u' ' + tr("Its folder holds %n series. Of a slice its own is taken, of a folder the largest.", nullptr, static_cast<int>(i.series));
    if (i.slices > 0) text += u' ' + tr("Nothing about the patient is read.");
    about_->setText(text);
    volume_form_ = new VolumeForm(i, std::make_shared<ImagePreview>(std::move(look.preview)));
    parts_card_->body()->addWidget(volume_form_);
    connect(volume_form_, &VolumeForm::changed, this, &ImportPage::forget_made);
    using Unit = ImportSize::FileSize::Unit;
    size_->begin({.unit = i.spacing_known ? Unit::stated : Unit::unknown,
                  .unit_mm = 1.0,
                  .voxel_mm = std::min({i.spacing_mm.x, i.spacing_mm.y, i.spacing_mm.z})});
  } else {
    mesh_form_ = new MeshForm(std::move(look.meshes));
    parts_card_->body()->addWidget(mesh_form_);
    connect(mesh_form_, &MeshForm::changed, this, &ImportPage::forget_made);
    const Vec3 size = mesh_form_->whole_size();
    if (before) mesh_form_->take_choices(*before);
    if (!before || !size_->chosen()) size_->begin({.unit_mm = guessed_unit_mm(std::max({size.x, size.y, size.z}))});
  }
  show_files();
}

void ImportPage::show_size() {
  made_card_->setVisible(preview_->volume() != nullptr);
  const bool own = image_ && image_->specimen;
  size_->set_changeable(!own);
  if (!mesh_form_ && !volume_form_) return;
  const double unit = size_->unit_mm();
  std::optional<double> longest;
  QString text;
  bool ready = false;
  if (mesh_form_) {
    const QSignalBlocker quiet(mesh_form_);
    mesh_form_->set_unit_mm(unit);
    const Vec3 size = mesh_form_->size() * unit;
    longest = std::max({size.x, size.y, size.z});
    ready = !mesh_form_->chosen().empty();
    text = ready ? tr("The specimen will be %1.").arg(size_text(size, u"mm"_qs))
                 : tr("With this unit the file is %1. Choose the tissue of each mesh.").arg(size_text(size, u"mm"_qs));
    if (unit != 1.0) text += u' ' + tr("If its unit were a millimetre, it would be %1.").arg(size_text(mesh_form_->size(), u"mm"_qs));
  } else {
    const QString refused = own ? fineness_refusal(image_->spacing_mm.x) : QString();  // it is taken as it stands
    ready = volume_form_->ready() && refused.isEmpty();
    const Vec3 spacing = image_->spacing_mm * unit;
    const double voxel = size_->voxel_mm();
    const bool cubes = std::ranges::all_of(std::array{spacing.x, spacing.y, spacing.z}, [&](double s) { return std::abs(s - voxel) <= 1e-3 * voxel; });
    text = tr("The volume is %1.").arg(size_text(Vec3(image_->size) * spacing, u"mm"_qs));
    if (!refused.isEmpty()) text = refused + u' ' + tr("Make the specimen anew from its scan or its surfaces.");
    if (!cubes && !own) {
      text += u' ' + tr("Its voxels of %1 are resampled to cubes of %2.")
                         .arg(size_text(spacing, u"mm"_qs, 3), format_value({.value = voxel, .unit = QStringLiteral("mm"), .decimals = 3}));
    }
  }
  const Vec3 whole = mesh_form_ ? mesh_form_->size() * unit : Vec3(image_->size) * image_->spacing_mm * unit;
  if (volume_form_ && !own && no_scan_of_a_tooth(whole, image_->spacing_mm * unit)) longest = std::max({whole.x, whole.y, whole.z});
  size_picture_->show_size(glm::abs(turned_up(whole, size_->up())));
  // Only the imported volume shows how much of it is tooth. A specimen of this program has its size.
  if (preview_->volume() && !own) {
    const Vec3 made = preview_->size_mm();
    longest = std::max({made.x, made.y, made.z});
  }
  size_->show_size(text, longest);
  import_->setEnabled(ready && !work_ && !size_->questioned() && !preview_->volume());
  keep_->setEnabled(!work_ && !size_->questioned() && !preview_->turning());
}

void ImportPage::forget_made() {
  preview_->clear();
  show_size();
}

void ImportPage::run() {
  begin_work(tr("Making the specimen"));
  std::function<Result<VoxelVolume, ImportFailure>(const ImportProgress&, std::stop_token, std::vector<ImportRemark>&)> job;
  if (mesh_form_) {
    MeshImport what;
    what.path = files_.front();
    what.more.assign(files_.begin() + 1, files_.end());
    what.unit_mm = size_->unit_mm();
    what.voxel_mm = size_->voxel_mm();
    what.tissues = mesh_form_->chosen();
    what.precedence = mesh_form_->precedence();
    what.mend_holes_mm = mesh_form_->mend_mm();
    what.up = size_->up();
    job = [what](const ImportProgress& p, std::stop_token stop, std::vector<ImportRemark>& r) { return import_mesh_in_child(what, {}, p, std::move(stop), &r); };
  } else {
    ImageImport what;
    what.path = files_.front();
    what.tissues = volume_form_->tissues();
    what.tissues.unit_mm = size_->unit_mm();
    what.tissues.voxel_mm = size_->voxel_mm();
    what.tissues.up = size_->up();
    job = [what](const ImportProgress& p, std::stop_token stop, std::vector<ImportRemark>& r) { return import_image_in_child(what, {}, p, std::move(stop), &r); };
  }
  preview_->clear();
  QThreadPool::globalInstance()->start([job = std::move(job), name = files_.front().filename().string(), work = work_, self = QPointer<ImportPage>(this)] {
    const auto progress = [&](double share) {
      answer_to(self, work, [self, share] {
        self->busy_->set_progress(share, QLocale().toString(qRound(100 * share)) + QChar(0x00A0) + u'%');
      });
    };
    auto remarks = std::make_shared<std::vector<ImportRemark>>();
    auto volume = job(progress, work->get_token(), *remarks);
    if (volume)
      if (auto refused = refuse_taken_codes(*volume, name)) volume = std::unexpected(std::move(*refused));
    if (!volume) {
      return answer_to(self, work, [self, failure = volume.error()] {
        self->end_work();
        self->import_->setFocus(Qt::OtherFocusReason);  // as end_look()
        self->show_failure(failure);
      });
    }
    auto made = std::make_shared<ImportedSpecimen>(imported_specimen(std::move(*volume)));
    answer_to(self, work, [self, made, remarks] {
      self->end_work();
      self->show_made(std::move(*made), *remarks);
    });
  });
}

void ImportPage::show_made(ImportedSpecimen made, const std::vector<ImportRemark>& remarks) {
  preview_->show_specimen(std::move(made), remarks);
  show_size();
  keep_->setFocus();
  // After the layout has placed the card.
  QMetaObject::invokeMethod(this, [this] { findChild<QScrollArea*>()->ensureWidgetVisible(made_card_); }, Qt::QueuedConnection);
  announce(this, tr("The specimen is made. Look at it, and keep it."));
}

void ImportPage::keep() {
  if (work_ || !preview_->volume() || preview_->turning()) return;
  // Files of a CT are often named after the patient.
  const bool ct = image_ && image_->slices > 0;
  const std::string name = ct ? tr("CT").toStdString() : QFileInfo(QString::fromStdString(files_.front().string())).completeBaseName().toStdString();
  begin_work(tr("Making the exercise"));
  QThreadPool::globalInstance()->start([volume = preview_->volume(), name, database = database_, work = work_, self = QPointer<ImportPage>(this)] {
    const auto start = std::make_shared<Result<EditorStart, ImportFailure>>(exercise_on(*volume, name, database));
    std::error_code ignored;  // a volume that stays wastes disk space only
    if (work->stop_requested() && *start) std::filesystem::remove_all((*start)->folder, ignored);
    answer_to(self, work, [self, start] {
      self->end_work();
      if (*start) return Q_EMIT self->edit_wanted(**start);
      self->keep_->setFocus(Qt::OtherFocusReason);  // as end_look()
      self->show_failure(start->error());
    });
  });
}

}  // namespace cusp::ui
