#include "ui/editor/editor_page.h"

#include <QApplication>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolButton>
#include <algorithm>

#include "ui/editor/check_messages.h"
#include "ui/editor/draft_folder.h"
#include "ui/editor/editor_page_parts.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/operator_job.h"
#include "ui/editor/shape_form.h"
#include "ui/editor/specimen_form.h"
#include "ui/editor/target_view.h"
#include "ui/editor/texts_form.h"
#include "ui/render/opengl_allowed.h"
#include "ui/text/language.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kAutosaveMs = 1500;
constexpr int kRestMs = 350;  // a spin box that is being turned does not start a specimen at every step

}  // namespace

EditorPage::EditorPage(Store& store, const Actor& actor, const Ports& ports, EditorStart start, QWidget* parent)
    : QWidget(parent),
      store_(store),
      actor_(actor),
      ports_(ports),
      kept_(start.kept),
      model_(new EditorModel(std::move(start), this)),
      held_(hold_folder(model_->folder())),
      grower_(new SpecimenGrower(this)) {
  setAccessibleName(tr("Editor"));
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  stage_ = new TargetView(*model_);
  lay_out();
  connect(model_, &EditorModel::changed, this, &EditorPage::follow_model);
  connect(model_, &EditorModel::part_chosen, this, &EditorPage::follow_model);
  // EditorModel::changed comes before the stack has the step, so the buttons follow the stack.
  connect(&model_->stack(), &QUndoStack::indexChanged, this, &EditorPage::show_undo);
  follow_grower();
  follow_reference();
  start_autosave();
  setFocusProxy(tabs_->tabBar());  // not the tabs, which hand the focus on: a page's proxy goes once it has the focus
  follow_model();
  show_undo();
  grow();
}

void EditorPage::follow_grower() {
  grow_soon_.setSingleShot(true);
  grow_soon_.setInterval(kRestMs);
  connect(&grow_soon_, &QTimer::timeout, this, &EditorPage::grow);
  connect(model_, &EditorModel::specimen_changed, this, [this] {
    if (!held_) held_ = hold_folder(model_->folder());  // the first volume of a draft makes the folder
    grower_->cancel();
    grown_.reset();  // the view keeps the last tooth; trying out and checks wait for the new one
    grow_soon_.start();
  });
  connect(grower_, &SpecimenGrower::previewed, stage_, &TargetView::set_specimen);
  connect(grower_, &SpecimenGrower::progressed, this, [this](double share) {
    if (busy_) busy_->set_progress(share, QLocale().toString(qRound(100 * share)) + QChar(0x00A0) + u'%');
  });
  connect(grower_, &SpecimenGrower::grown, this, [this](const std::shared_ptr<const GrownSpecimen>& grown) {
    busy_ = nullptr;
    stage_->set_centre(nullptr);
    grown_ = grown;
    stage_->set_specimen(grown);
    model_->set_facts(grown->facts, grown->pulp_mm, grown->whole->specimen_ptr());
    Q_EMIT ready();
  });
  connect(grower_, &SpecimenGrower::failed, this, [this](const ImportFailure& failure) {
    busy_ = nullptr;
    const Message message = describe(failure);
    stage_->set_specimen(nullptr);
    auto* state = new EmptyState(u"warning"_qs, message.what, message.more, tr("Change"), Ink::bad);
    connect(state, &EmptyState::acted, this, [this] { show_tooth_form(true); });
    stage_->set_centre(state);
    follow_model();
  });
}

/// If the program dies, only the edits since the last pause are lost; of a new exercise, nothing.
void EditorPage::start_autosave() {
  autosave_.setSingleShot(true);
  autosave_.setInterval(kAutosaveMs);
  connect(&autosave_, &QTimer::timeout, this, &EditorPage::keep);
  if (!kept_ && !model_->published()) autosave_.start();  // a new exercise: nothing else names the tooth that an import made
  connect(model_, &EditorModel::changed, this, [this] {
    autosave_.start();
    band_->clear();
  });
  connect(new QShortcut(QKeySequence::Save, this), &QShortcut::activated, this, [this] {
    take_typed();
    if (!keep()) return;
    if (!half_filled()) return band_->show_message(Band::Kind::good, tr("The draft is saved."), {});
    band_->show_message(Band::Kind::look, tr("The draft is saved without the briefing."), tr("The exercise keeps the briefing as it was. Under Texts stands why."));
  });
}

/// A field hands its typed text over when it loses the focus; a key that acts leaves the focus there.
void EditorPage::take_typed() {
  const QPointer<QWidget> field = QApplication::focusWidget();
  if (field == nullptr || !isAncestorOf(field)) return;
  field->clearFocus();
  if (field && field->isVisible()) field->setFocus();
}

EditorPage::~EditorPage() = default;

bool EditorPage::publishing() const { return publish_wait_->running() && !proving_; }

void EditorPage::show_tooth_form(bool on) {
  if (left_in_tabs()) tabs_->setCurrentWidget(left_);
  left_->setCurrentIndex(on ? 1 : 0);
  stage_->set_shown(on ? TargetView::Shows::landmarks : TargetView::Shows::target);
  if (!on) return change_->setFocus();
  forms_.fill(tooth_page_);
  const QList<QWidget*> inside = tooth_page_->findChildren<QWidget*>();
  const auto first = std::ranges::find_if(inside, [](const QWidget* w) { return w->isVisible() && (w->focusPolicy() & Qt::TabFocus); });
  if (first != inside.end()) (*first)->setFocus();
}

void EditorPage::grow() {
  grown_.reset();
  busy_ = new Busy;
  busy_->start(tr("Growing the tooth"), Busy::Cancel::offered);
  stage_->set_centre(busy_);
  connect(busy_, &Busy::cancelled, this, [this] {
    grower_->cancel();
    busy_ = nullptr;
    stage_->set_specimen(nullptr);
    auto* state = new EmptyState(u"tooth"_qs, tr("No tooth yet"), tr("Growing was stopped. The exercise is as it was."),
                                 tr("Grow it"));
    connect(state, &EmptyState::acted, this, &EditorPage::grow);
    stage_->set_centre(state);
  });
  grower_->grow(model_->scenario().specimen, model_->scenario().method, model_->folder());
}

void EditorPage::show_title() {
  const Scenario& s = model_->scenario();
  show_text(*title_, s.title, screen_language());
  title_->setPlaceholderText(local(s.title));
}

void EditorPage::show_version() {
  const Scenario& s = model_->scenario();
  const bool unchanged = model_->unchanged();
  version_->set(unchanged ? tr("Version %1, published").arg(model_->published()->version)
                          : tr("Version %1, not published").arg(s.version),
                unchanged ? Chip::Kind::good : Chip::Kind::plain);
  if (left_in_tabs()) version_->hide();  // set() shows it
  if (!publish_wait_->running()) {
    publish_->setAccessibleName(tr("Publish version %1").arg(s.version));
    publish_->setText(left_in_tabs() ? tr("Publish") : publish_->accessibleName());
  }
  publish_->setEnabled(model_->standing() == EditorModel::Standing::ready);
}

void EditorPage::follow_model() {
  const Scenario& s = model_->scenario();
  show_title();
  show_version();
  const EditorModel::Standing standing = model_->standing();
  const bool whole = grown_ != nullptr && model_->playable();
  try_->setEnabled(whole && opengl_allowed());
  reference_->setEnabled(whole && !reference_job_->running());
  tooth_->setText(isolate(s.specimen.generator.empty() ? breakable(specimen_name(s.specimen), kWholeInPanel) : specimen_name(s.specimen)));
  const bool drawn = model_->has_outline();
  on_top_->setEnabled(grown_ != nullptr && s.target.kind == RegionKind::outline);
  shapes_->setExclusive(drawn);  // of another part no button is chosen
  for (int i = 0; i < static_cast<int>(std::size(kShapes)); ++i) {
    QAbstractButton* button = shapes_->button(i);
    const QSignalBlocker silent(button);
    button->setEnabled(drawn);
    button->setToolTip(drawn ? QString() : tr("Choose an outline among the parts of the target first"));
    button->setChecked(drawn && model_->outline().shape == kShapes[i].key);
  }
  while (QLayoutItem* item = contents_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const auto line = [&](const QString& icon_name, const QString& text) {
    auto* row = new QWidget;
    auto* inside = new QHBoxLayout(row);
    inside->setContentsMargins(px(8), 0, 0, 0);
    inside->setSpacing(px(8));
    auto* sign = new QLabel;
    sign->setPixmap(icon_pixmap(icon_name, Ink::text2, 18, devicePixelRatioF()));
    inside->addWidget(sign);
    QLabel* name = make_label(text);
    name->setWordWrap(true);
    inside->addWidget(name, 1);
    contents_->addWidget(row);
  };
  line(u"target"_qs, target_name(s.target));
  for (const ScenarioTissue& t : s.tissues) {
    const bool guarded = is_protected(s, t.tissue);
    const QString name = tissue_name(t.tissue, model_->tissue_names());
    line(guarded ? u"shield"_qs : u"layers"_qs, guarded ? tr("%1, protected").arg(name) : name);
  }

  const auto& findings = model_->findings();
  const int wrong = static_cast<int>(findings.size());
  const bool failing = has_error(findings);
  const Ink ink = failing ? Ink::bad : wrong > 0 ? Ink::look : Ink::good;
  check_sign_->setPixmap(icon_pixmap(wrong > 0 ? u"warning"_qs : u"check"_qs, ink, 18, devicePixelRatioF()));
  check_aside_->setText(failing                                          ? tr("publishing waits for it")
                        : standing == EditorModel::Standing::unproved    ? tr("the tooth is still being checked")
                        : standing == EditorModel::Standing::unchanged   ? tr("nothing was changed since it was published")
                                                                         : tr("ready to publish"));
  checks_chip_->set(failing ? tr("Check fails") : tr("Checks passed"), failing ? Chip::Kind::bad : Chip::Kind::good);
  checks_chip_->setHidden(check_aside_->isHidden());  // set() shows it in a narrow window too
  shown_check_ = 0;  // an error comes first
  show_check();
}

/// One finding, in front of a button that shows the next.
void EditorPage::show_check() {
  const auto& findings = model_->findings();
  const int count = static_cast<int>(findings.size());
  const bool any = shown_check_ < findings.size();
  check_title_->setText(count > 1 ? tr("%1 of %2 things to look at").arg(shown_check_ + 1).arg(count)
                        : any     ? tr("%n thing(s) to look at", nullptr, count)
                                  : tr("Everything fits"));
  check_->setText(any ? check_message(findings[shown_check_], &model_->scenario().target, model_->tissue_names()) : QString());
  show_->setVisible(any);
  next_check_->setVisible(count > 1);
}

void EditorPage::show_next_check() {
  if (model_->findings().empty()) return;
  shown_check_ = (shown_check_ + 1) % model_->findings().size();
  show_check();
}

void EditorPage::show_undo() {
  undo_->setEnabled(model_->stack().canUndo());
  redo_->setEnabled(model_->stack().canRedo());
  undo_->setToolTip(model_->stack().canUndo() ? short_tool_tip(tr("Undo: %1 (Ctrl+Z)").arg(model_->stack().undoText())) : tr("Undo (Ctrl+Z)"));
  redo_->setToolTip(model_->stack().canRedo() ? short_tool_tip(tr("Redo: %1 (Ctrl+Y)").arg(model_->stack().redoText())) : tr("Redo (Ctrl+Y)"));
}

void EditorPage::show_place_of_check() {
  if (shown_check_ >= model_->findings().size()) return;
  switch (place_of(model_->findings()[shown_check_])) {
    case EditorPlace::title: tabs_->setCurrentIndex(kWordsTab); break;
    case EditorPlace::tooth: show_tooth_form(true); return;
    case EditorPlace::shape: tabs_->setCurrentIndex(kShapeTab); break;
    case EditorPlace::points: tabs_->setCurrentIndex(kPointsTab); break;
    case EditorPlace::burs: tabs_->setCurrentIndex(kBursTab); break;
    case EditorPlace::tissues: tabs_->setCurrentIndex(kTissuesTab); break;
  }
  tabs_->setFocus();
}

void EditorPage::put_target_on_top() {
  if (!grown_ || model_->scenario().target.kind != RegionKind::outline) return;
  Outline t = model_->outline();
  if (t.paths.empty() || t.paths.front().empty()) return;
  const Vec3 middle = (grown_->facts.low_mm + grown_->facts.high_mm) / 2.0;
  const Vec3 to = grown_->central_mm.value_or(middle);
  const auto height = height_at(grown_->whole->specimen(), to.x, to.y);
  if (!height) return;
  Vec3 low = t.paths.front().front(), high = low;
  for (const auto& path : t.paths) {
    for (const Vec3& p : path) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  const auto tidy = [](double mm) { return std::round(mm * 100) / 100; };
  const Vec3 by(tidy(to.x - (low.x + high.x) / 2), tidy(to.y - (low.y + high.y) / 2), 0);
  for (auto& path : t.paths) {
    for (Vec3& p : path) p += by;
  }
  t.top_mm = tidy(*height);
  settle_on_floor(t);
  model_->end_gesture();
  model_->set_outline(t, u"place"_qs);
  model_->end_gesture();
}

}  // namespace cusp::ui
