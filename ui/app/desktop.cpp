#include "ui/app/desktop.h"

#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QPointer>
#include <QShortcut>
#include <QStackedWidget>
#include <QStandardPaths>
#include <algorithm>

#include "device/hid/hid_station.h"
#include "scenarios/library/library.h"
#include "ui/admin/exchange_page.h"
#include "ui/admin/log_page.h"
#include "ui/admin/people_page.h"
#include "ui/admin/performance.h"
#include "ui/admin/station_page.h"
#include "ui/app/quick_open.h"
#include "ui/app/help_page.h"
#include "ui/app/password_dialog.h"
#include "ui/app/shell.h"
#include "ui/app/sparing_records.h"
#include "ui/device/device_page.h"
#include "ui/device/hid_settings.h"
#include "ui/device/space_mouse_turner.h"
#include "ui/drill/drill_screen.h"
#include "ui/instructor/import_page.h"
#include "ui/instructor/cohorts_page.h"
#include "ui/instructor/library_page.h"
#include "ui/modules.h"
#include "ui/render/opengl_allowed.h"
#include "ui/settings/device_settings.h"
#include "ui/signin/sign_in.h"
#include "ui/student/course.h"
#include "ui/student/exercises_page.h"
#include "ui/student/own_history.h"
#include "ui/student/thumbnail_cache.h"
#include "ui/student/start_page.h"
#include "ui/text/falcon_text.h"
#include "ui/text/language.h"
#include "ui/view/tooth_cache.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr QSize kLeast{960, 540}, kUsual{1280, 800};   // px
constexpr int kAccountLookMs = 2'000;                   // one row is read
constexpr int kFrame = 48;                              // px; what a window manager takes of the height at most
constexpr const char* kCoverExercise = "class-1-36";    // whose tooth the sign-in shows
constexpr int kCoverAfterMs = 3'000;                    // it is drawn; whoever signs in at once has use for the processor

std::filesystem::path cache_folder() {
  return (QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + u"/Cusp"_qs).toStdString();
}

}  // namespace

Desktop::Desktop(Settings& settings, Ports ports, std::filesystem::path database, OpenRecords open, QWidget* parent)
    : QMainWindow(parent),
      settings_(settings),
      ports_(sparing_records(std::move(ports), database)),
      database_(std::move(database)),
      open_(std::move(open)),
      pictures_(std::make_unique<ThumbnailCache>(cache_folder() / "pictures")),
      teeth_(std::make_shared<ToothCache>(cache_folder() / "teeth")),
      stack_(new QStackedWidget),
      idle_(ports_.since_boot ? ports_.since_boot : time_since_boot) {
  setWindowTitle(QStringLiteral("Cusp"));
  setWindowIcon(icon(u"tooth"_qs, Ink::accent));
  setCentralWidget(stack_);
  // A full HD screen at 200 % has 960 x 540 to give: there the window takes all of it.
  const QSize most = screen()->availableSize() - QSize(0, kFrame);
  setMinimumSize(kLeast.boundedTo(most));
  resize(kUsual.boundedTo(most));
  if (!restoreGeometry(settings_.window())) setWindowState(Qt::WindowMaximized);  // the first start
  connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_K), this), &QShortcut::activated, this, &Desktop::quick_open);
  connect(new QShortcut(QKeySequence(Qt::Key_F6), this), &QShortcut::activated, this, [this] {
    if (page() == shell_ && shell_) {
      shell_->next_pane();
    } else {
      focusNextChild();
    }
  });
  connect(pictures_.get(), &ThumbnailCache::ready, this, &Desktop::show_cover);
  connect(&idle_, &IdleWatch::idle, this, &Desktop::lock_idle);
  connect(&backup_timer_, &QTimer::timeout, this, &Desktop::keep_daily_backup);
  connect(&account_timer_, &QTimer::timeout, this, &Desktop::look_at_account);
  connect(&account_timer_, &QTimer::timeout, this, &Desktop::look_at_opening);
}

Desktop::~Desktop() = default;

QString Desktop::marker_folder() { return QString::fromStdString((cache_folder() / "running").string()); }
std::filesystem::path Desktop::volume_folder() { return cache_folder() / "volumes"; }

void Desktop::replace_root(QWidget* root) {
  shell_ = nullptr;
  sign_in_ = nullptr;
  while (stack_->count() > 0) {
    QWidget* old = stack_->widget(0);
    stack_->removeWidget(old);
    old->deleteLater();
  }
  stack_->addWidget(root);
  stack_->setCurrentWidget(root);
  if (QWidget* begins = root->focusProxy()) begins->setFocus();
}

void Desktop::show_sign_in(SignIn* page) {
  if (const auto message = incident()) page->show_incident(*message);
  if (const auto why = why_reading_only()) page->show_reading_only(*why);
  if (records_damaged()) page->offer_way_back();
  connect(page, &SignIn::way_back_wanted, this, [this] { show_way_back(why_going_back()); });
  if (!opengl_allowed()) page->show_no_drilling({ToothView::pictures_off(), tr("The next start tries them again.")});
  if (!behind_lock_.empty()) page->show_note({tr("Some work is not saved."), behind_lock_text()});
  connect(page, &SignIn::try_again, this, &Desktop::start);
  connect(page, &SignIn::signed_in, this, &Desktop::sign_in);
  connect(page, &SignIn::administrator_made, this, &Desktop::show_quick_start);
  connect(page, &SignIn::administrator_there, this, [this] {
    show_sign_in(new SignIn(*store_));
    sign_in_->set_typed_number({}, SignIn::Who::staff);
    sign_in_->show_note({tr("There is an administrator by now."), tr("Another window of Cusp made one. Sign in as that administrator.")});
  });
  connect(page, &SignIn::language_chosen, this, &Desktop::set_language);
  connect(page, &SignIn::theme_toggled, this,
          [this] { set_scheme(tokens().dark ? ColourScheme::light : ColourScheme::dark); });
  connect(page, &SignIn::try_it, this, [this] {
    const auto list = load_exercises(*store_);
    if (!list || list->exercises.empty()) return;
    const Exercise* block = &list->exercises.front();
    for (const Exercise& e : list->exercises) {
      if (e.scenario.key == "channel-1") block = &e;
    }
    account_.reset();
    drill(*block);
  });
  replace_root(page);
  sign_in_ = page;
  show_cover();
}

void Desktop::show_cover() {
  const auto scenario = load_builtin(kCoverExercise);
  if (!sign_in_ || !scenario) return;
  const Exercise exercise{*scenario, {}, 1, {}};
  const QImage kept = pictures_->kept(exercise, ThumbnailCache::Use::cover);
  if (!kept.isNull()) return sign_in_->set_picture(kept);
  QTimer::singleShot(kCoverAfterMs, sign_in_, [this, exercise] { pictures_->picture(exercise, {}, ThumbnailCache::Use::cover); });
}

void Desktop::sign_in(const Account& account) {
  account_ = account;
  begin_idle();
  account_timer_.start(kAccountLookMs);
  pictures_->stop();
  show_shell(entries().first().key);
  open_waiting_file();
  take_from_behind_lock();
  save_behind_lock();
}

void Desktop::look_at_opening() {
  auto* start = shell_ && page() == shell_ ? qobject_cast<StartPage*>(shell_->page()) : nullptr;
  if (start != nullptr) start->look_at_clock(ports_.now());
}

void Desktop::sign_out() {
  // A dialog of the window outlives the pages, and acts for whoever was signed in.
  for (QDialog* open : findChildren<QDialog*>(Qt::FindDirectChildrenOnly)) delete open;
  account_.reset();
  if (hid_) {
    const HidSettings kept(settings_.file());
    hid_->pedal().set_settings(kept.pedal());
    hid_->space_mouse().set_settings(kept.space_mouse());
  }
  use_text(TextSize::usual);
  show_sign_in(new SignIn(*store_));
}

/// People, cohorts, everybody's results, and what the station keeps.
void Desktop::add_school_entries(QVector<NavEntry>& list) {
  const Role role = account_->role;
  if (may(role, Action::manage_accounts)) {
    list += {u"people"_qs, tr("People"), u"person"_qs,
             [this]() -> QWidget* {
               auto* page = new PeoplePage(*store_, account_->actor(), ports_, nullptr, &settings_);
               connect(page, &PeoplePage::import_wanted, this, &Desktop::import_people);
               return page;
             }};
  }
  if (!reading_only_ && may(role, Action::manage_cohorts)) {
    list += {u"cohorts"_qs, tr("Cohorts"), u"people"_qs,
             [this]() -> QWidget* {
               auto* page = new CohortsPage(*store_, account_->actor(), ports_);
               connect(page, &CohortsPage::results_wanted, this, &Desktop::show_assignment);
               return page;
             }};
  }
  if (may(role, Action::see_all_results)) {
    list += {u"performance"_qs, tr("Performance"), u"chart"_qs, [this]() -> QWidget* {
               auto* page = new Performance(*store_, account_->actor(), ports_, volume_folder());
               connect(page, &Performance::report_wanted, this, &Desktop::open_report);
               connect(page, &Performance::pack_wanted, this, &Desktop::open_pack);
               return page;
             }};
  }
  if (!reading_only_ && may(role, Action::manage_station)) {
    list += {u"station"_qs, tr("Station"), u"save"_qs,
             [this]() -> QWidget* { return new StationPage(*store_, account_->actor(), settings_, ports_); }};
    list += {u"exchange"_qs, tr("Other stations"), u"monitor"_qs,
             [this]() -> QWidget* { return new ExchangePage(*store_, account_->actor(), settings_, ports_); }};
  }
  if (may(role, Action::see_audit_log)) {
    list += {u"audit"_qs, tr("Audit log"), u"shield"_qs, [this]() -> QWidget* { return new LogPage(*store_, account_->actor(), ports_); }};
  }
}

std::string Desktop::device_class() {
  const DeviceKind* device = device_kind(DeviceSettings(settings_.file()).choice().kind);
  return device != nullptr ? std::string(device->device_class) : std::string();
}

QVector<NavEntry> Desktop::entries() {
  QVector<NavEntry> list;
  const Role role = account_->role;
  const bool writing = !reading_only_;
  if (writing && role == Role::student) {
    list += {u"start"_qs, tr("Start"), u"home"_qs, [this]() -> QWidget* {
               mark_left();
               auto* page = new StartPage(*store_, *account_, *pictures_, ports_.now(), device_class(), volume_folder());
               connect(page, &StartPage::resume_wanted, this, &Desktop::resume_attempt);
               connect(page, &StartPage::grade_wanted, this, &Desktop::grade_interrupted);
               connect(page, &StartPage::briefing_wanted, this, &Desktop::show_briefing);
               connect(page, &StartPage::start_wanted, this, &Desktop::drill);
               connect(page, &StartPage::assessment_wanted, this, &Desktop::sit);
               connect(page, &StartPage::assessment_opened, this, &Desktop::read_page_again);
               connect(page, &StartPage::report_wanted, this, &Desktop::open_report);
               return page;
             }};
  }
  if (writing && may(role, Action::edit_scenarios)) {
    list += {u"library"_qs, tr("Library"), u"layers"_qs, [this]() -> QWidget* {
               auto* page = new LibraryPage(*store_, account_->actor(), ports_, database_, volume_folder(), pictures_.get());
               connect(page, &LibraryPage::edit_wanted, this, &Desktop::edit);
               connect(page, &LibraryPage::import_wanted, this, &Desktop::import_specimen);
               return page;
             }};
  }
  if (writing && role != Role::administrator) {
    list += {u"exercises"_qs, tr("Exercises"), u"list"_qs, [this]() -> QWidget* {
               auto* page = new ExercisesPage(*store_, account_->actor(), *pictures_, volume_folder());
               connect(page, &ExercisesPage::briefing_wanted, this, &Desktop::show_briefing);
               connect(page, &ExercisesPage::again_wanted, this, &Desktop::read_page_again);
               return page;
             }};
  }
  if (role == Role::student) {
    list += {u"results"_qs, tr("My results"), u"chart"_qs, [this]() -> QWidget* {
               auto* page = new OwnHistory(*store_, account_->actor());
               connect(page, &OwnHistory::report_wanted, this, &Desktop::open_report);
               connect(page, &OwnHistory::exercises_wanted, this, [this] { shell_->show_page(u"exercises"_qs); });
               return page;
             }};
  }
  add_school_entries(list);
  list += {u"device"_qs, tr("Device"), u"device"_qs, [this, role]() -> QWidget* {
             auto* page = new DevicePage(settings_, ports_, role, hid_);
             connect(page, &DevicePage::chosen, this, &Desktop::show_device);
             connect(page, &DevicePage::tested, this, &Desktop::keep_device_test);
             return page;
           }};
  list += {u"help"_qs, tr("Help"), u"book"_qs, [this, role]() -> QWidget* {
             auto* page = new HelpPage(role);
             connect(page, &HelpPage::quick_start_wanted, this, &Desktop::show_quick_start);
             return page;
           }};
  return list;
}

void Desktop::show_shell(const QString& page_key) {
  auto* shell = new Shell(*account_, entries());
  connect(shell, &Shell::language_chosen, this, &Desktop::set_language);
  offer_exercise_languages(*shell);
  connect(shell, &Shell::theme_toggled, this,
          [this] { set_scheme(tokens().dark ? ColourScheme::light : ColourScheme::dark); });
  connect(shell, &Shell::scale_chosen, this, &Desktop::set_scale);
  shell->keep_hand_in(settings_);
  shell->ask_before_leaving([this](std::function<void()> then) { leave_page(std::move(then)); });
  connect(shell, &Shell::help_wanted, this, [this] { leave_page([this] { shell_->show_page(u"help"_qs); }); });
  connect(shell, &Shell::signed_out, this, [this] { leave_page([this] { sign_out(); }); });
  connect(shell, &Shell::password_wanted, this, [this] { (new PasswordDialog(*store_, *account_, this))->open(); });
  if (const auto why = why_reading_only()) {
    shell->show_notice(*why);
  } else if (const auto message = incident(); message && account_->role == Role::administrator) {
    shell->show_notice(*message);
  } else if (backup_failure_ && account_->role == Role::administrator) {
    shell->show_notice(*backup_failure_);
  } else if (!opengl_allowed()) {
    shell->show_notice({ToothView::pictures_off(), tr("The next start tries them again.")});
  }
  replace_root(shell);
  shell_ = shell;
  show_device();
  shell->show_page(page_key);
  show_pack_outcomes();
}

void Desktop::show_device() {
  if (!shell_) return;
  const DeviceChoice device = DeviceSettings(settings_.file()).choice();
  shell_->show_device(device_title(device.kind, device.name), device.kind == "falcon" ? u"device"_qs : u"mouse"_qs);
}

void Desktop::push(QWidget* fresh) {
  // If the stack itself gives the focus to the proxy's widget, the page has no proxy any more (theme.cpp).
  QWidget* begins = fresh->focusProxy() ? fresh->focusProxy() : fresh;
  stack_->addWidget(fresh);
  stack_->setCurrentWidget(fresh);
  // A device moves without mouse and keys: nobody is signed out, and the first key after a while is for the attempt.
  if (qobject_cast<DrillScreen*>(fresh) != nullptr) idle_.set_limit({});
  begins->setFocus();
  lead_views(fresh);
}

void Desktop::lead_views(QWidget* page) {
  if (!hid_) return;
  for (ToothView* view : page->findChildren<ToothView*>())
    connect(new SpaceMouseTurner(*view, hid_->space_mouse()), &SpaceMouseTurner::moved, &idle_, &IdleWatch::count_input);
}

void Desktop::back() {
  if (stack_->count() < 2) return;
  QWidget* old = stack_->currentWidget();
  // Where the keyboard was on the page below: without `old` Qt puts it on that page's first control.
  const QPointer<QWidget> last = stack_->widget(stack_->count() - 2)->focusWidget();
  stack_->removeWidget(old);
  old->deleteLater();
  if (qobject_cast<DrillScreen*>(old) != nullptr) begin_idle();
  use_text(TextSize::usual);
  stack_->setCurrentIndex(stack_->count() - 1);
  // What lies below may have new results.
  if (shell_ && page() == shell_) return shell_->show_again();
  look_at_briefing();
  if (last && page() != sign_in_) last->setFocus(Qt::OtherFocusReason);
}

void Desktop::drop(QWidget* covered) {
  stack_->removeWidget(covered);
  covered->deleteLater();
}

QWidget* Desktop::page() const { return stack_->currentWidget(); }

void Desktop::keep_device_test(const DeviceTest& test) {
  const auto kept = store_->device_tests.add(account_->actor(), test);
  if (!kept) shell_->show_notice(describe(kept.error()));
}

void Desktop::show_failure(const Message& message) {
  auto* state = new EmptyState(u"warning"_qs, message.what, message.more, tr("Back"), Ink::bad);
  connect(state, &EmptyState::acted, this, &Desktop::back);
  QWidget* page = make_page(state);
  page->setFocusProxy(state->button());
  push(page);
}

void Desktop::rebuild() {
  if (sign_in_ && page() == sign_in_) {
    auto* fresh = new SignIn(*store_);
    fresh->set_typed_number(sign_in_->typed_number(), sign_in_->who());
    fresh->set_typed_name(sign_in_->typed_name());
    show_sign_in(fresh);
  } else if (shell_ && page() == shell_) {
    show_shell(shell_->page_key());
  } else if (!store_) {
    start();
  }
}

void Desktop::quick_open() {
  if (!shell_ || page() != shell_) return;
  QVector<Destination> places;
  for (const NavEntry& entry : shell_->entries()) {
    places += {entry.name, tr("page"), entry.icon, [this, key = entry.key] { leave_page([this, key] { shell_->show_page(key); }); }};
  }
  // In the version that is assigned: an attempt at another one would not count.
  const bool drills = std::ranges::any_of(shell_->entries(), [](const NavEntry& entry) { return entry.key == u"exercises"_qs; });
  if (const auto course = drills ? load_course(*store_, account_->actor()) : Stored<Course>(Course{})) {
    for (const CourseRow& row : course->rows) {
      places += {local(row.exercise.scenario.title), tr("exercise"), u"list"_qs, [this, e = row.exercise] { show_briefing(e); }};
    }
  }
  (new QuickOpen(places, this))->open();
}

}  // namespace cusp::ui
