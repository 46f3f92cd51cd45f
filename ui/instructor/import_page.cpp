#include "ui/instructor/import_page.h"

#include <QApplication>
#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QThreadPool>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/volume/specimen.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/worker.h"
#include "scenarios/library/library.h"
#include "ui/app/sentences.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/specimen_grower.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp {
namespace {

constexpr double kDefaultVoxelMm = 0.1;
constexpr std::array kTissues = {Tissue::enamel,          Tissue::dentine, Tissue::carious_dentine, Tissue::cementum,
                                 Tissue::pulp,            Tissue::bone,    Tissue::gingiva,         Tissue::amalgam,
                                 Tissue::composite,       Tissue::plastic};

QString lengths(Vec3 size, const QString& unit) {
  return isolate(QStringLiteral("%1 × %2 × %3").arg(format_number(size.x, 1), format_number(size.y, 1), format_number(size.z, 1)) +
                 (unit.isEmpty() ? QString() : QChar(0x00A0) + unit));
}

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

}  // namespace

Result<EditorStart, ImportFailure> exercise_on(const VoxelVolume& volume, const std::string& name,
                                               const std::filesystem::path& database) {
  const auto pattern = load_builtin("channel-1");
  const SpecimenFacts facts = facts_of(volume);
  EditorStart start;
  Scenario& s = start.draft;
  if (pattern) s = *pattern;
  s.id = ScenarioId::make();
  s.key.clear();
  s.title = {{"en", name}};
  s.briefing = {{"en", pattern ? pattern->briefing.at("en") : name}};
  s.specimen = {};
  s.specimen.volume = "specimen.nrrd";
  s.specimen.voxel_mm = volume.grid.voxel_mm;
  s.tissues = usual_tissues(facts.tissues);
  if (std::ranges::find(facts.tissues, Tissue::pulp) != facts.tissues.end()) {
    s.protected_tissues = {Tissue::pulp};
    s.rubric.critical = {"pulp_exposure"};
  }
  const auto tidy = [](double mm) { return std::round(mm * 100) / 100; };
  const Vec3 middle = (facts.low_mm + facts.high_mm) / 2.0;
  const auto specimen = Specimen::build(volume, Reading::banded);
  s.target.top_mm = tidy(height_at(*specimen, middle.x, middle.y).value_or(facts.high_mm.z));
  // A third of the length and of the height at most, so that the first target lies inside whatever was brought.
  const double reach = std::min(std::abs(s.target.paths[0][0].x), (facts.high_mm.x - facts.low_mm.x) / 6);
  s.target.paths = {{{tidy(middle.x - reach), tidy(middle.y), 0}, {tidy(middle.x + reach), tidy(middle.y), 0}}};
  settle_on_floor(s.target);
  const std::filesystem::path folder = drafts_folder(database, s.id);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(ImportError::io, folder.string(), error.message());
  if (auto written = write_nrrd(volume, folder / s.specimen.volume); !written) return std::unexpected(written.error());
  start.folder = folder.string();
  return start;
}

ImportPage::ImportPage(const Ports& ports, std::filesystem::path database, QWidget* parent)
    : QWidget(parent), ports_(ports), database_(std::move(database)) {
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Import a specimen"));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(12));
  auto* head = new PageHead(tr("Import a specimen"));
  QPushButton* back = make_button(tr("Library"), ButtonKind::quiet, u"chevron_left"_qs, QKeySequence(Qt::ALT | Qt::Key_Left));
  outer->addWidget(back, 0, Qt::AlignLeft);
  outer->addWidget(head);
  band_ = new Band;
  outer->addWidget(band_);
  card_ = new Card(tr("File"));
  auto* row = new QHBoxLayout;
  name_ = make_label(tr("Closed meshes (OBJ, STL, PLY) or a volume (NRRD)."), TextRole::body, false, "text2");
  name_->setWordWrap(true);
  row->addWidget(name_, 1);
  pick_ = make_button(tr("Choose a file…"), ButtonKind::standard, u"import"_qs, QKeySequence::Open);
  row->addWidget(pick_);
  card_->body()->addLayout(row);
  grid_ = new QGridLayout;
  grid_->setHorizontalSpacing(px(16));
  grid_->setVerticalSpacing(px(6));
  card_->body()->addLayout(grid_);
  auto* numbers = new QHBoxLayout;
  numbers->setSpacing(px(16));
  const auto number = [&](const QString& name, double least, double most, double value, int decimals) {
    auto* box = new QDoubleSpinBox;
    box->setLocale(QLocale());
    box->setDecimals(decimals);
    box->setRange(least, most);
    box->setValue(value);
    box->setSingleStep(value / 10);
    box->setSuffix(QChar(0x00A0) + QStringLiteral("mm"));
    box->setFixedWidth(px(140));
    numbers->addWidget(labelled(name, box));
    return box;
  };
  unit_ = number(tr("One unit of the file is"), 0.0001, 1000, 1, 4);
  voxel_ = number(tr("Fineness"), 0.03, 1, kDefaultVoxelMm, 3);
  up_ = new QComboBox;
  for (const std::string_view key : kUpAxisKeys) up_->addItem(QString::fromLatin1(key.data(), static_cast<int>(key.size())));
  up_->setFixedWidth(px(100));
  numbers->addWidget(labelled(tr("Chewing surface looks to"), up_));
  numbers->addStretch();
  card_->body()->addLayout(numbers);
  size_ = make_label({}, TextRole::body, true);
  size_->setWordWrap(true);
  card_->body()->addWidget(size_);
  import_ = make_large_button(tr("Make a specimen"), ButtonKind::primary);
  card_->body()->addWidget(import_, 0, Qt::AlignLeft);
  busy_ = new Busy;
  card_->body()->addWidget(busy_);
  outer->addWidget(card_);
  outer->addStretch();
  connect(back, &QPushButton::clicked, this, &ImportPage::back_wanted);
  connect(pick_, &QPushButton::clicked, this, [this] {
    ports_.pick_file(this, {tr("Choose a file"), {}, tr("Meshes and volumes (*.obj *.stl *.ply *.nrrd)"), false},
                     [this](const QString& path) { open_file(path); });
  });
  connect(unit_, &QDoubleSpinBox::valueChanged, this, &ImportPage::show_size);
  connect(import_, &QPushButton::clicked, this, &ImportPage::run);
  connect(busy_, &Busy::cancelled, this, [this] {
    end_work();
    band_->show_message(Band::Kind::info, tr("Importing was stopped."), tr("Nothing was kept."));
  });
  show_size();
  setFocusProxy(pick_);
}

ImportPage::~ImportPage() {
  if (work_) work_->request_stop();
}

void ImportPage::begin_work(const QString& what) {
  if (work_) work_->request_stop();
  work_ = std::make_shared<std::stop_source>();
  band_->clear();
  busy_->start(what, true);
  pick_->setEnabled(false);
  import_->setEnabled(false);
}

void ImportPage::end_work() {
  if (work_) work_->request_stop();
  work_.reset();
  busy_->finish();
  pick_->setEnabled(true);
  show_size();
}

void ImportPage::tell_failure(const ImportFailure& failure) {
  const Told told = tell(failure);
  band_->show_message(Band::Kind::bad, told.what, told.more);
}

void ImportPage::open_file(const QString& path) {
  file_ = path.toStdString();
  name_->setText(isolate(QFileInfo(path).fileName()));
  show_meshes({});
  begin_work(tr("Reading the file"));
  const QPointer<ImportPage> self(this);
  if (path.endsWith(u".nrrd", Qt::CaseInsensitive)) {
    QThreadPool::globalInstance()->start([self, work = work_, file = file_] {
      auto volume = std::make_shared<Result<VoxelVolume, ImportFailure>>(read_nrrd(file));
      answer_to(self, work, [self, volume] {
        self->end_work();
        if (*volume) {
          self->keep(**volume);
        } else {
          self->tell_failure(volume->error());
        }
      });
    });
    return;
  }
#ifdef CUSP_IMPORT
  QThreadPool::globalInstance()->start([self, work = work_, file = file_] {
    const auto meshes = list_meshes_in_child(file, {}, work->get_token());
    answer_to(self, work, [self, meshes] {
      self->end_work();
      if (meshes) {
        self->show_meshes(*meshes);
      } else {
        self->tell_failure(meshes.error());
      }
    });
  });
#else
  end_work();
  tell_failure({ImportError::unknown_format, file_.filename().string(), {}});
#endif
}

void ImportPage::show_meshes(std::vector<MeshInfo> meshes) {
  while (QLayoutItem* item = grid_->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  meshes_.clear();
  int line = 0;
  for (MeshInfo& info : meshes) {
    const QString name = QString::fromStdString(info.name);
    auto* tissue = new QComboBox;
    tissue->setAccessibleName(tr("What %1 is made of").arg(name));
    tissue->addItem(tr("Leave out"), 0);
    for (const Tissue t : kTissues) tissue->addItem(tissue_name(t), static_cast<int>(t));
    grid_->addWidget(make_label(name, TextRole::body, true), line, 0);
    grid_->addWidget(make_label(tr("%1 units").arg(lengths(info.high - info.low, {})), TextRole::body, false, "text2"), line, 1);
    const QString state = info.closed && info.oriented ? tr("closed") : tr("open: cannot be used");
    grid_->addWidget(make_label(state, TextRole::body, false, info.closed && info.oriented ? "good" : "look"), line, 2);
    grid_->addWidget(tissue, line, 3);
    tissue->setEnabled(info.closed && info.oriented);
    connect(tissue, &QComboBox::currentIndexChanged, this, &ImportPage::show_size);
    meshes_.push_back({std::move(info), tissue});
    ++line;
  }
  show_size();
}

std::vector<std::pair<std::string, Tissue>> ImportPage::chosen() const {
  std::vector<std::pair<std::string, Tissue>> out;
  for (const Mesh& mesh : meshes_) {
    const int code = mesh.tissue->currentData().toInt();
    if (code > 0) out.emplace_back(mesh.info.name, static_cast<Tissue>(code));
  }
  return out;
}

void ImportPage::show_size() {
  const bool any = !chosen().empty();
  import_->setEnabled(any && !work_);
  import_->setVisible(!meshes_.empty());
  if (meshes_.empty()) {
    size_->clear();
    return;
  }
  Vec3 low(1e300), high(-1e300);
  for (const Mesh& mesh : meshes_) {
    if (any && mesh.tissue->currentData().toInt() == 0) continue;
    low = glm::min(low, mesh.info.low);
    high = glm::max(high, mesh.info.high);
  }
  const Vec3 size = (high - low) * unit_->value();
  size_->setText(any ? tr("The specimen will be %1.").arg(lengths(size, u"mm"_qs))
                     : tr("With this unit the file is %1. Say what each mesh is made of.").arg(lengths(size, u"mm"_qs)));
}

void ImportPage::run() {
#ifdef CUSP_IMPORT
  MeshImport what;
  what.path = file_;
  what.unit_mm = unit_->value();
  what.voxel_mm = voxel_->value();
  what.tissues = chosen();
  what.up = static_cast<UpAxis>(up_->currentIndex());
  begin_work(tr("Making the specimen"));
  QThreadPool::globalInstance()->start([what, work = work_, self = QPointer<ImportPage>(this)] {
    const auto progress = [&](double share) {
      answer_to(self, work, [self, share] {
        self->busy_->set_progress(share, QLocale().toString(qRound(100 * share)) + QChar(0x00A0) + u'%');
      });
    };
    auto volume = std::make_shared<Result<VoxelVolume, ImportFailure>>(
        import_mesh_in_child(what, {}, progress, work->get_token()));
    answer_to(self, work, [self, volume] {
      self->end_work();
      if (*volume) {
        self->keep(**volume);
      } else {
        self->tell_failure(volume->error());
      }
    });
  });
#endif
}

void ImportPage::keep(const VoxelVolume& volume) {
  const auto start = exercise_on(volume, QFileInfo(QString::fromStdString(file_.string())).completeBaseName().toStdString(), database_);
  if (!start) return tell_failure(start.error());
  Q_EMIT edit_wanted(*start);
}

}  // namespace cusp
