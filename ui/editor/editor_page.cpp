#include "ui/editor/editor_page.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <algorithm>

#include "ui/app/language.h"
#include "ui/app/sentences.h"
#include "ui/drill/tooth_view.h"
#include "ui/editor/burrs_form.h"
#include "ui/editor/check_sentences.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/points_form.h"
#include "ui/editor/shape_form.h"
#include "ui/editor/specimen_form.h"
#include "ui/editor/target_view.h"
#include "ui/editor/tissues_form.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp {
namespace {

constexpr int kTopBar = 48, kLeft = 248, kRight = 304, kChecks = 80;  // px at 100 %
constexpr int kAutosaveMs = 1500;
constexpr const char* kLanguages[] = {"en", "de"};
enum Tab { kShapeTab, kPointsTab, kBurrsTab, kTissuesTab, kWordsTab };

struct ShapeChoice {
  const char* key;
  const char* icon;
};
constexpr ShapeChoice kShapes[] = {{"outline", "fissures"}, {"channel", "channel"}, {"box", "box"}};

std::string screen_language() { return current_language() == u"de" ? "de" : "en"; }

QWidget* scrolling(QWidget* form) {
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(form);
  form->setProperty("kind", u"page_surface"_qs);
  form->setAttribute(Qt::WA_StyledBackground);
  return area;
}

}  // namespace

EditorPage::EditorPage(Store& store, const Actor& actor, const Ports& ports, EditorStart start, QWidget* parent)
    : QWidget(parent),
      store_(store),
      actor_(actor),
      ports_(ports),
      model_(new EditorModel(std::move(start), this)),
      grower_(new SpecimenGrower(this)) {
  setAccessibleName(tr("Editor"));
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  stage_ = new TargetView(*model_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_top_bar());
  band_ = new Band;
  column->addWidget(band_);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  row->addWidget(make_left());
  auto* middle = new QVBoxLayout;
  middle->setSpacing(0);
  middle->addWidget(stage_, 1);
  middle->addWidget(make_checks());
  row->addLayout(middle, 1);
  row->addWidget(make_right());
  column->addLayout(row, 1);

  connect(model_, &EditorModel::changed, this, &EditorPage::follow_model);
  // The model tells of a change while its step is still being pushed: what can be undone is the stack's to tell.
  connect(&model_->stack(), &QUndoStack::indexChanged, this, &EditorPage::show_undo);
  connect(model_, &EditorModel::specimen_changed, this, &EditorPage::grow);
  connect(grower_, &SpecimenGrower::progressed, this, [this](double share) {
    if (busy_) busy_->set_progress(share, QLocale().toString(qRound(100 * share)) + QChar(0x00A0) + u'%');
  });
  connect(grower_, &SpecimenGrower::grown, this, [this](const std::shared_ptr<const GrownSpecimen>& grown) {
    busy_ = nullptr;
    stage_->set_centre(nullptr);
    grown_ = grown;
    stage_->set_specimen(grown);
    model_->set_facts(grown->facts, grown->pulp_mm);
    Q_EMIT ready();
  });
  connect(grower_, &SpecimenGrower::failed, this, [this](const ImportFailure& failure) {
    busy_ = nullptr;
    const Told told = tell(failure);
    auto* state = new EmptyState(u"warning"_qs, told.what, told.more, tr("Change"), Ink::bad);
    connect(state, &EmptyState::acted, this, [this] { show_tooth_form(true); });
    stage_->set_centre(state);
    follow_model();
  });
  // A window that is closed, or a machine that stops, loses a moment's work and no more.
  autosave_.setSingleShot(true);
  autosave_.setInterval(kAutosaveMs);
  connect(&autosave_, &QTimer::timeout, this, &EditorPage::keep);
  connect(model_, &EditorModel::changed, this, [this] {
    autosave_.start();
    band_->clear();
  });
  connect(new QShortcut(QKeySequence::Save, this), &QShortcut::activated, this, [this] {
    if (keep()) band_->show_message(Band::Kind::good, tr("The draft is saved."), {});
  });
  setFocusProxy(tabs_);
  follow_model();
  show_undo();
  grow();
}

EditorPage::~EditorPage() = default;

QWidget* EditorPage::make_top_bar() {
  auto* bar = new QFrame;
  bar->setProperty("kind", u"bar_top"_qs);
  bar->setFixedHeight(px(kTopBar));
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(px(12), 0, px(12), 0);
  row->setSpacing(px(8));
  QPushButton* back = make_button(tr("Library"), ButtonKind::quiet, u"chevron_left"_qs, QKeySequence(Qt::ALT | Qt::Key_Left));
  back->setToolTip(tr("Keeps the draft and goes back (Alt+Left)"));
  connect(back, &QPushButton::clicked, this, &EditorPage::leave);
  row->addWidget(back);
  QFrame* rule = make_rule(Qt::Vertical);
  rule->setFixedHeight(px(30));
  row->addWidget(rule);
  title_ = new QLineEdit;
  title_->setAccessibleName(tr("Title of the exercise"));
  title_->setToolTip(tr("Title, in the language of the screen; the others stand under Words"));
  title_->setFont(font_of(TextRole::section, true));
  title_->setMinimumWidth(px(200));
  title_->setMaximumWidth(px(340));
  row->addWidget(title_, 1);
  connect(title_, &QLineEdit::textEdited, this, [this](const QString& text) {
    // English is always there: an emptied one keeps its last letter until another is typed.
    model_->set_title(screen_language(), text.trimmed());
  });
  connect(title_, &QLineEdit::editingFinished, this, [this] {
    model_->end_gesture();
    show_words();
  });
  version_ = new Chip;
  row->addWidget(version_);
  row->addStretch();
  undo_ = make_icon_button(u"undo"_qs, tr("Undo"), QKeySequence::Undo);
  redo_ = make_icon_button(u"redo"_qs, tr("Redo"), QKeySequence(Qt::CTRL | Qt::Key_Y));
  row->addWidget(undo_);
  row->addWidget(redo_);
  row->addSpacing(px(8));
  connect(undo_, &QToolButton::clicked, this, [this] {
    undo_->setFocus();  // a field that is being typed in shows what there is again
    model_->stack().undo();
  });
  connect(redo_, &QToolButton::clicked, this, [this] {
    redo_->setFocus();
    model_->stack().redo();
  });
  try_ = make_button(tr("Try out"), ButtonKind::standard, u"hand"_qs, QKeySequence(Qt::Key_F5));
  row->addWidget(try_);
  QLabel* cap = make_key_cap(u"F5"_qs);
  cap->setFixedHeight(px(18));
  row->addWidget(cap, 0, Qt::AlignVCenter);
  publish_ = make_button(tr("Publish"), ButtonKind::primary);
  row->addWidget(publish_);
  connect(try_, &QPushButton::clicked, this, &EditorPage::try_out);
  connect(publish_, &QPushButton::clicked, this, &EditorPage::publish_version);
  return bar;
}

QWidget* EditorPage::make_left() {
  left_ = new QStackedWidget;
  left_->setFixedWidth(px(kLeft));
  auto* side = new QFrame;
  side->setProperty("kind", u"bar_side"_qs);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(px(12), px(12), px(12), px(12));
  column->setSpacing(px(8));
  column->addWidget(make_label(tr("Target"), TextRole::section, true));
  shapes_ = new QButtonGroup(this);
  for (int i = 0; i < static_cast<int>(std::size(kShapes)); ++i) {
    const QString name = shape_name(kShapes[i].key);
    auto* button = new QPushButton(icon(QString::fromLatin1(kShapes[i].icon)), u"  "_qs + name);
    button->setIconSize(QSize(px(20), px(20)));
    button->setProperty("kind", u"nav"_qs);
    button->setCheckable(true);
    button->setAutoDefault(false);
    button->setAccessibleName(name);
    shapes_->addButton(button, i);
    column->addWidget(button);
  }
  connect(shapes_, &QButtonGroup::idToggled, this, [this](int id, bool on) {
    if (on) model_->set_shape(kShapes[id].key);
  });
  column->addSpacing(px(8));
  column->addWidget(make_rule());
  column->addSpacing(px(8));
  column->addWidget(make_label(tr("In this exercise"), TextRole::section, true));
  contents_ = new QVBoxLayout;
  contents_->setSpacing(px(8));
  column->addLayout(contents_);
  column->addStretch();
  on_top_ = make_button(tr("Put the target on the tooth"), ButtonKind::standard, u"target"_qs);
  on_top_->setToolTip(tr("Moves the target to the middle of the tooth, at its surface"));
  column->addWidget(on_top_);
  connect(on_top_, &QPushButton::clicked, this, &EditorPage::put_target_on_top);
  column->addWidget(make_rule());
  column->addWidget(make_label(tr("Tooth"), TextRole::section, true));
  auto* row = new QHBoxLayout;
  tooth_ = make_label({});
  tooth_->setWordWrap(true);
  row->addWidget(tooth_, 1);
  change_ = make_button(tr("Change"), ButtonKind::standard);
  change_->setAccessibleName(tr("Change the tooth"));
  row->addWidget(change_);
  column->addLayout(row);
  connect(change_, &QPushButton::clicked, this, [this] { show_tooth_form(true); });
  left_->addWidget(side);
  auto* form = new SpecimenForm(*model_, ports_);
  auto* frame = new QFrame;
  frame->setProperty("kind", u"bar_side"_qs);
  auto* inside = new QVBoxLayout(frame);
  inside->setContentsMargins(0, 0, 1, 0);
  inside->addWidget(scrolling(form));
  left_->addWidget(frame);
  connect(form, &SpecimenForm::done, this, [this] { show_tooth_form(false); });
  return left_;
}

void EditorPage::show_tooth_form(bool on) {
  left_->setCurrentIndex(on ? 1 : 0);
  if (on) {
    left_->currentWidget()->setFocus();
    focusNextChild();
  } else {
    change_->setFocus();
  }
}

QWidget* EditorPage::make_words_form() {
  auto* form = new QWidget;
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(px(16), px(12), px(16), px(16));
  column->setSpacing(px(8));
  const QString titles[] = {tr("Title, English"), tr("Title, German")};
  const QString briefings[] = {tr("Briefing, English"), tr("Briefing, German")};
  for (int i = 0; i < 2; ++i) {
    titles_[i] = new QLineEdit;
    briefings_[i] = new QPlainTextEdit;
    briefings_[i]->setTabChangesFocus(true);
    briefings_[i]->setFixedHeight(px(140));
    column->addWidget(labelled(titles[i], titles_[i]));
    column->addWidget(labelled(briefings[i], briefings_[i]));
    const std::string code = kLanguages[i];
    connect(titles_[i], &QLineEdit::textEdited, this,
            [this, code](const QString& text) { model_->set_title(code, text.trimmed()); });
    connect(titles_[i], &QLineEdit::editingFinished, this, [this] {
      model_->end_gesture();
      show_words();
    });
    connect(briefings_[i], &QPlainTextEdit::textChanged, this, [this, code, edit = briefings_[i]] {
      model_->set_briefing(code, edit->toPlainText().trimmed());
    });
  }
  column->addStretch();
  return form;
}

QWidget* EditorPage::make_right() {
  auto* panel = new QFrame;
  panel->setProperty("kind", u"panel_right"_qs);
  panel->setFixedWidth(px(kRight));
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(1, 0, 0, 0);
  tabs_ = new QTabWidget;
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setProperty("tight", true);  // five words in 304 px
  tabs_->addTab(scrolling(new ShapeForm(*model_)), tr("Shape"));
  tabs_->addTab(scrolling(new PointsForm(*model_)), tr("Points"));
  tabs_->addTab(scrolling(new BurrsForm(*model_)), tr("Burrs"));
  tabs_->addTab(scrolling(new TissuesForm(*model_)), tr("Tissues"));
  tabs_->addTab(scrolling(make_words_form()), tr("Words"));
  column->addWidget(tabs_);
  return panel;
}

QWidget* EditorPage::make_checks() {
  auto* bar = new QFrame;
  bar->setProperty("kind", u"bar_bottom"_qs);
  bar->setFixedHeight(px(kChecks));
  bar->setAccessibleName(tr("Checks"));
  auto* column = new QVBoxLayout(bar);
  column->setContentsMargins(px(16), px(8), px(16), px(8));
  column->setSpacing(px(2));
  auto* head = new QHBoxLayout;
  head->setSpacing(px(8));
  check_sign_ = new QLabel;
  head->addWidget(check_sign_);
  check_title_ = make_label({}, TextRole::body, true);
  head->addWidget(check_title_);
  check_aside_ = make_label({}, TextRole::body, false, "text2");
  head->addWidget(check_aside_);
  head->addStretch();
  checks_chip_ = new Chip;
  head->addWidget(checks_chip_);
  column->addLayout(head);
  auto* row = new QHBoxLayout;
  check_ = make_label({});
  check_->setWordWrap(true);
  check_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(check_, 1);
  show_ = make_button(tr("Show"), ButtonKind::standard, u"target"_qs);
  show_->setAccessibleName(tr("Show where"));
  row->addWidget(show_);
  column->addLayout(row);
  connect(show_, &QPushButton::clicked, this, &EditorPage::show_first_check);
  return bar;
}

void EditorPage::grow() {
  grown_.reset();
  stage_->set_specimen(nullptr);
  busy_ = new Busy;
  busy_->start(tr("Growing the tooth"), true);
  stage_->set_centre(busy_);
  connect(busy_, &Busy::cancelled, this, [this] {
    grower_->cancel();
    busy_ = nullptr;
    auto* state = new EmptyState(u"tooth"_qs, tr("No tooth yet"), tr("Growing was stopped. The exercise is as it was."),
                                 tr("Grow it"));
    connect(state, &EmptyState::acted, this, &EditorPage::grow);
    stage_->set_centre(state);
  });
  grower_->grow(model_->scenario().specimen, model_->scenario().method, model_->folder());
}

void EditorPage::show_words() {
  const auto show = [](QLineEdit* edit, const LocalText& texts, const std::string& code) {
    const auto it = texts.find(code);
    const QString text = it == texts.end() ? QString() : QString::fromStdString(it->second);
    // A space just typed at the end is not taken away from under the cursor.
    if (edit->text().trimmed() != text) edit->setText(text);
  };
  const Scenario& s = model_->scenario();
  show(title_, s.title, screen_language());
  title_->setPlaceholderText(local(s.title));
  for (int i = 0; i < 2; ++i) {
    show(titles_[i], s.title, kLanguages[i]);
    const auto it = s.briefing.find(kLanguages[i]);
    const QString text = it == s.briefing.end() ? QString() : QString::fromStdString(it->second);
    if (briefings_[i]->toPlainText().trimmed() != text && !briefings_[i]->hasFocus()) {
      const QSignalBlocker quiet(briefings_[i]);
      briefings_[i]->setPlainText(text);
    }
  }
}

void EditorPage::follow_model() {
  const Scenario& s = model_->scenario();
  show_words();
  const EditorModel::Standing standing = model_->standing();
  const bool unchanged = model_->unchanged();
  version_->set(unchanged ? tr("Version %1, published").arg(model_->published()->version)
                          : tr("Version %1, not published").arg(s.version),
                unchanged ? Chip::Kind::good : Chip::Kind::plain);
  publish_->setText(tr("Publish version %1").arg(s.version));
  publish_->setAccessibleName(publish_->text());
  publish_->setEnabled(standing == EditorModel::Standing::ready);
  try_->setEnabled(grown_ != nullptr && !has_error(model_->findings()));
  tooth_->setText(isolate(specimen_name(s.specimen)));
  on_top_->setEnabled(grown_ != nullptr);
  for (int i = 0; i < static_cast<int>(std::size(kShapes)); ++i) {
    if (s.target.shape == kShapes[i].key) shapes_->button(i)->setChecked(true);
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
    inside->addWidget(make_label(text), 1);
    contents_->addWidget(row);
  };
  line(u"target"_qs, shape_name(s.target.shape));
  for (const ScenarioTissue& t : s.tissues) {
    const bool guarded = std::ranges::find(s.protected_tissues, t.tissue) != s.protected_tissues.end();
    line(guarded ? u"shield"_qs : u"layers"_qs, guarded ? tr("%1, protected").arg(tissue_name(t.tissue)) : tissue_name(t.tissue));
  }

  const auto& findings = model_->findings();
  const int wrong = static_cast<int>(findings.size());
  const bool failing = has_error(findings);
  const Ink ink = failing ? Ink::bad : wrong > 0 ? Ink::look : Ink::good;
  check_sign_->setPixmap(icon_pixmap(wrong > 0 ? u"warning"_qs : u"check"_qs, ink, 18, devicePixelRatioF()));
  check_title_->setText(wrong > 0 ? tr("%n thing(s) to look at", nullptr, wrong) : tr("Everything fits"));
  check_aside_->setText(failing                                          ? tr("publishing waits for it")
                        : standing == EditorModel::Standing::unproved    ? tr("the tooth is still being checked")
                        : standing == EditorModel::Standing::unchanged   ? tr("nothing was changed since it was published")
                                                                         : tr("ready to publish"));
  checks_chip_->set(failing ? tr("Check fails") : tr("Checks passed"), failing ? Chip::Kind::bad : Chip::Kind::good);
  check_->setText(wrong > 0 ? check_sentence(findings.front()) : QString());
  show_->setVisible(wrong > 0);
}

void EditorPage::show_undo() {
  undo_->setEnabled(model_->stack().canUndo());
  redo_->setEnabled(model_->stack().canRedo());
  undo_->setToolTip(model_->stack().canUndo() ? tr("Undo: %1 (Ctrl+Z)").arg(model_->stack().undoText()) : tr("Undo (Ctrl+Z)"));
  redo_->setToolTip(model_->stack().canRedo() ? tr("Redo: %1 (Ctrl+Y)").arg(model_->stack().redoText()) : tr("Redo (Ctrl+Y)"));
}

void EditorPage::show_first_check() {
  if (model_->findings().empty()) return;
  switch (place_of(model_->findings().front())) {
    case EditorPlace::title: tabs_->setCurrentIndex(kWordsTab); break;
    case EditorPlace::tooth: show_tooth_form(true); return;
    case EditorPlace::shape: tabs_->setCurrentIndex(kShapeTab); break;
    case EditorPlace::points: tabs_->setCurrentIndex(kPointsTab); break;
    case EditorPlace::burrs: tabs_->setCurrentIndex(kBurrsTab); break;
    case EditorPlace::tissues: tabs_->setCurrentIndex(kTissuesTab); break;
  }
  tabs_->setFocus();
}

void EditorPage::put_target_on_top() {
  if (!grown_) return;
  Target t = model_->scenario().target;
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
  model_->set_target(t, u"place"_qs);
  model_->end_gesture();
}

void EditorPage::try_out() {
  if (!grown_ || has_error(model_->findings())) return;
  RunPlan plan;
  plan.scenario = model_->scenario();
  plan.scenario_folder = model_->folder();
  plan.student = actor_;
  plan.kind = SessionKind::try_out;  // and no database: nothing is kept
  plan.specimen = grown_->whole->specimen_ptr();
  Q_EMIT try_out_wanted(plan, local(model_->scenario().title));
}

void EditorPage::publish_version() {
  const auto version = publish(store_, actor_, *model_);
  if (!version) {
    const Told told = tell(version.error());
    band_->show_message(Band::Kind::bad, told.what, told.more);
    return;
  }
  band_->show_message(Band::Kind::good, tr("Version %1 is published.").arg(version->number),
                      tr("Students find it among their exercises. Earlier results keep the version they were made with."));
  Q_EMIT published(*version);
}

bool EditorPage::keep() {
  autosave_.stop();
  const auto kept = keep_draft(store_, actor_, *model_);
  if (kept) return true;
  const Told told = tell(kept.error());
  band_->show_message(Band::Kind::bad, told.what, told.more);
  return false;
}

void EditorPage::leave() {
  if (keep()) Q_EMIT back_wanted();
}

}  // namespace cusp
