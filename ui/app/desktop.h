/// The window: sign-in first, then top bar, sidebar and pages by role; work that needs the space (drilling, report,
/// editor) takes the whole window with a way back. Holds what the pages share: the records and who is signed in.
#pragma once

#include <QDateTime>
#include <QMainWindow>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/replay.h"
#include "ui/settings/settings.h"
#include "ui/student/assessments.h"
#include "ui/student/exercises.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/idle_watch.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/ports.h"

class QStackedWidget;

namespace cusp::device::hid {
class HidStation;
}

namespace cusp::ui {

class DrillScreen;
struct DrillText;
struct EditorStart;
class MarkingCard;
class ReportPage;
struct OpenedPack;
struct ReportData;
class ThumbnailCache;
class ToothCache;
class Shell;
class SignIn;
struct BackedUp;
struct NavEntry;
struct WorkProgress;

/// Of an attempt whose student has large text.
inline constexpr int kLargeTextPercent = 150;

class Desktop : public QMainWindow {
  Q_OBJECT

 public:
  /// Store::open(), but in tests.
  using OpenRecords =
      std::function<Stored<std::unique_ptr<Store>>(const std::filesystem::path& file, const StoreOptions& options)>;
  Desktop(
      Settings& settings, Ports ports, std::filesystem::path database,
      OpenRecords open = [](const std::filesystem::path& file, const StoreOptions& options) { return Store::open(file, options); },
      QWidget* parent = nullptr);
  ~Desktop() override;

  /// Pedal and SpaceMouse of this station; outlives the desktop. Before start(); without it there are none.
  void use_hid(hid::HidStation& station) { hid_ = &station; }
  hid::HidStation* hid() const { return hid_; }

  /// Of the files that RunMarker sets.
  static QString marker_folder();

  /// Opens the records and shows sign-in, or shows why they cannot be opened. Where nothing can be written they are opened
  /// for reading: then there are results and reports, and neither drilling nor the library.
  void start();

  /// Asks whether to start without 3D pictures, because a crash came before this start, and start()s. The window is shown.
  void offer_safe_start();

  /// An exercise file that the library opens as soon as somebody with the right signs in; others read who may open it.
  /// The path is absolute. Before start().
  void open_after_sign_in(const QString& file) { waiting_file_ = file; }

  void sign_in(const Account& account);
  void sign_out();
  /// Signs out after the station's time without input, unless somebody drills. An editor keeps its draft. What cannot be saved stays,
  /// hidden, until the same account signs in again.
  void lock_idle();
  const std::optional<Account>& account() const { return account_; }
  Store* store() { return store_.get(); }

  /// A page over the whole window; back() closes it and shows what was there before.
  void push(QWidget* page);
  void back();
  /// What fills the window now: sign-in, the shell, or the page pushed last.
  QWidget* page() const;
  Shell* shell() const { return shell_; }

  /// Starts an attempt; without an account nothing is kept.
  void drill(const Exercise& exercise);
  /// Of the device that this station's settings name.
  std::string device_class();
  /// Asks for the start code, then begins the assessment.
  void sit(const AssignedAssessment& assessment);
  /// Resumes an attempt that broke off, from where it stood; an assessment once its start code is typed.
  void resume_attempt(const SessionId& session);
  /// After an attempt: its report, or that it is handed in. Where the exercise says so, who drilled it rates it first.
  void end_attempt(const std::shared_ptr<const SessionResult>& result, const std::optional<Exercise>& exercise);
  /// Of an own assessment that is interrupted: the start page, which continues it. One that was finished without a grade gets it first.
  void open_report(const SessionId& session);
  /// Asks, then grades an attempt that broke off as it stands, keeps that grade and shows it; hands in an assessment.
  void grade_interrupted(const SessionId& session);
  void edit(const EditorStart& start);
  /// Shows an appeal pack of any origin as a report, with what its verification found.
  void open_pack(const QString& path);
  void import_specimen();
  void import_people();

  /// Looks in the background whether a day has passed since the last daily backup, and then makes one, unless somebody drills now. After a
  /// failure it waits an hour. True if it has begun to look.
  bool keep_daily_backup();
  /// Whether one was found due, and is being made.
  bool makes_daily_backup() const;

  enum class TextSize : std::uint8_t { usual, large };
  /// `large`: pages made from now on are at least kLargeTextPercent of their size, until back() or sign_out().
  void use_text(TextSize size);

  void set_scheme(ColourScheme scheme);
  void set_language(const QString& code);
  /// "": as the program.
  void set_exercise_language(const QString& code);
  void set_scale(int percent);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void begin_idle();
  /// Locks if the account was switched off, erased or given another role since it signed in: pages read in that role.
  void look_at_account();
  /// Offers an assessment that has opened while the start page is shown.
  void look_at_opening();
  void read_page_again();
  /// Signs out, keeps what can be kept, and says why.
  void lock(const QString& why);
  /// The pages over the shell go out of sight, for sign_in() of the same account.
  void put_behind_lock();
  void take_from_behind_lock();
  /// Frees what could be saved meanwhile.
  void save_behind_lock();
  QString behind_lock_text() const;
  /// Whose comments wait for their authors; empty: none does.
  QString waiting_comments_text() const;
  /// What whoever was signed out had written into the card.
  void give_back_comment(MarkingCard& card);
  /// True if something would be lost: closing then waits for the answer. Drafts are kept.
  bool asks_before_closing();
  /// True while makes_daily_backup(): the window shows it, offers to leave it out, and closes after it. A signal stops it, and so does
  /// closing before one is found due.
  bool waits_for_backup();
  void end_daily_backup(const Stored<BackedUp>& made);
  void show_last_backup();
  /// Calls `then`; after a question, or never, if a form of the shell's page or the outcome of its work would be lost.
  void leave_page(std::function<void()> then);
  void offer_exercise_languages(class Shell& shell);
  void rebuild();
  void show_sign_in(SignIn* page);
  void show_cover();
  void show_shell(const QString& page_key);
  void show_device();
  void show_refusal(const Message& message);
  /// Closes the records: a backup takes their place.
  void show_way_back(const Message& why);
  /// From the sign-in: damage, or a new computer.
  Message why_going_back() const;
  bool records_damaged() const;
  Stored<std::unique_ptr<Store>> open_records(StoreOptions options = {}) const;
  /// What staff has to know of the records before it relies on them, or of the clock before anybody drills.
  std::optional<Message> incident();
  std::optional<Message> why_reading_only() const;
  void replace_root(QWidget* root);
  void show_briefing(const Exercise& exercise);
  /// Shows in the briefing, if one is the page, what the attempt that lay over it has used up.
  void look_at_briefing();
  void try_out(const SessionPlan& plan, const QString& title);
  /// An attempt on the station's device and with its pedal. Whoever calls connects what follows a finished attempt.
  DrillScreen* open_drilling(const SessionPlan& plan, const DrillText& text);
  static std::filesystem::path volume_folder();
  QVector<NavEntry> entries();
  void add_school_entries(QVector<NavEntry>& list);
  /// What follows where the grade of a finished attempt cannot be kept: the reason, or the report without it.
  enum class NotKept : std::uint8_t { fails, opens };
  /// A page that waits for the background. Its Cancel goes back, and whoever waits for the page's answer finds it gone.
  QWidget* push_waiting(const QString& doing, Busy::Cancel cancel);
  void open_result_page(const SessionId& session, Keep keep, NotKept not_kept = NotKept::fails);
  void show_drilling(const Exercise& exercise, SessionPlan plan, const QString& aside);
  /// Removes a page that another one has covered. What lies below is not made anew, as back() does.
  void drop(QWidget* covered);
  bool awaits_own_assessment(const SessionResult& result);
  void show_result(std::shared_ptr<const SessionResult> result, std::optional<Exercise> exercise);
  void show_report(const std::shared_ptr<const SessionResult>& result, ReportData gathered, const std::optional<Exercise>& exercise);
  /// gather_report() on a thread and a store of their own, then then(gathered), unless the page `shown` is gone or a later call came.
  /// Somebody is signed in.
  void gather(const std::shared_ptr<const SessionResult>& result, QWidget* shown, std::function<void(ReportData gathered)> then);
  void add_marking(ReportPage& report, const std::shared_ptr<const SessionResult>& result);
  StoreOptions beside() const;
  void offer_pack(ReportPage& report);
  void write_pack(ReportPage& report, const QString& path);
  /// How the writing of an appeal pack ended whose report was left.
  struct PackOutcome {
    UserId owner;  // who began it
    Band::Kind kind = Band::Kind::info;
    Message message;
  };
  /// To its owner: on another report that is shown, else over the pages until it is closed, also after the next sign-in.
  void report_pack(PackOutcome outcome);
  void show_pack_outcome(int number);
  /// Of whoever is signed in.
  void show_pack_outcomes();
  void show_pack(const std::shared_ptr<const OpenedPack>& pack);
  void show_assignment(AssignmentId assignment);
  void open_waiting_file();
  void show_handed_in(const SessionId& session);
  void show_quick_start();
  void keep_device_test(const DeviceTest& test);
  void show_failure(const Message& message);
  /// Attempts that were left and still count as running, because the disk was full or the file was held, are interrupted now.
  void mark_left();
  /// True, with a page that gives the reason, where nothing can be drilled because no picture can be drawn.
  bool refuse_drilling();
  /// True, with a page that gives the reason (why_no_practice()).
  bool refuse_practice(ScenarioId exercise);
  void ask_start_code(const AssignedAssessment& assessment, AssessmentStart::Purpose purpose, std::function<void(const QString& code)> then);
  /// `plan` lacks the start code, which is asked for.
  void resume_assessment(const SessionDetails& attempt, const Exercise& exercise, SessionPlan plan);
  void quick_open();

  void lead_views(QWidget* page);

  Settings& settings_;
  Ports ports_;
  std::filesystem::path database_;
  OpenRecords open_;
  std::unique_ptr<Store> store_;
  std::optional<StorageFailure> reading_only_;  // why nothing can be written
  std::optional<Account> account_;
  std::unique_ptr<ThumbnailCache> pictures_;
  std::shared_ptr<ToothCache> teeth_;
  QStackedWidget* stack_;
  Shell* shell_ = nullptr;
  SignIn* sign_in_ = nullptr;
  hid::HidStation* hid_ = nullptr;
  QString waiting_file_;  // empty: none
  QTimer backup_timer_, account_timer_;
  IdleWatch idle_;
  BackgroundTask backup_, packing_, gathering_;
  int gathered_ = 0;  // calls of gather()
  int packs_being_written_ = 0, packs_reported_ = 0;
  std::map<int, PackOutcome> pack_outcomes_;  // by number, until their owners have closed them
  std::optional<Message> backup_failure_;  // of the last daily backup
  QDateTime next_backup_;                  // after one that failed; invalid: at once
  std::shared_ptr<WorkProgress> backing_up_;  // null: no daily backup is being made or looked for
  bool closes_after_backup_ = false;
  struct UnsavedComment {
    QString author, text;
  };
  std::map<std::pair<UserId, SessionId>, UnsavedComment> unsaved_comments_;  // of whoever was signed out, by account and attempt
  struct BehindLock {
    QString owner;
    QWidget* pages = nullptr;  // hidden; its children, the lowest page first
  };
  std::map<std::pair<UserId, Role>, BehindLock> behind_lock_;  // what cannot be saved, by account and the role that its pages act in
  std::vector<SessionId> unmarked_;  // as of DrillScreen::left_unmarked()
  bool closes_anyway_ = false;
};

}  // namespace cusp::ui
