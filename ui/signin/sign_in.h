/// The sign-in page: tabs for students (number, PIN) and staff (user name, password), and "Try it" without an account. Without
/// an administrator in the records the page makes one. The desktop keeps who is signed in. Thread: GUI.
#pragma once

#include <QImage>
#include <QWidget>
#include <functional>
#include <optional>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/busy.h"

class QBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTabBar;

namespace cusp::ui {

class Band;
class PinField;

class SignIn : public QWidget {
  Q_OBJECT

 public:
  /// Who types: students give number and PIN, staff user name and password. In the order of the tabs.
  enum class Who { student, staff };
  explicit SignIn(Store& store, QWidget* parent = nullptr);

  /// Shown at the right of windows of 1100 px and more.
  void set_picture(const QImage& picture);
  /// Number or user name as typed: the desktop keeps it over a change of language, theme or scale.
  QString typed_number() const;
  void set_typed_number(const QString& number, Who who);
  /// The first administrator's name, likewise; empty on other pages.
  QString typed_name() const;
  void set_typed_name(const QString& name);
  Who who() const;  // staff at the first start
  /// A fault met while the records were opened: shown to staff, and to whoever makes the first administrator.
  void show_incident(const Message& message);
  /// Why the page is here, until somebody signs in; a refusal stands in its place until the tab is changed.
  void show_note(const Message& message);
  /// Likewise; "Try it" is disabled, and its tool tip gives the reason.
  void show_no_drilling(const Message& why);
  /// The records cannot be written: shown to everybody, with "Try again".
  void show_reading_only(const Message& why);
  /// Beside what show_reading_only() says: the records are damaged.
  void offer_way_back();
  QString message() const;
  /// Until the records have answered: argon2id takes longer than a frame. A second press is ignored meanwhile.
  bool waiting() const { return wait_ && wait_->running(); }

 Q_SIGNALS:
  void signed_in(const Account& account);
  /// After signed_in() of the first administrator, who was made here.
  void administrator_made();
  /// Instead: another window has made one meanwhile.
  void administrator_there();
  void try_it();
  void try_again();
  void way_back_wanted();  // a backup in the place of damaged records, or of a new computer's
  void language_chosen(const QString& code);
  void theme_toggled();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  static constexpr int kFormWidth = 320;  // px at 100 %

  QWidget* make_head();
  QWidget* make_notices();
  QWidget* make_station();
  QWidget* make_sign_in_form();
  QWidget* make_student_fields();
  QWidget* make_staff_fields();
  QWidget* make_first_start_form();
  void add_try_it(QBoxLayout& column);
  void submit();
  void create_administrator();
  using Question = std::function<Stored<Account>(Accounts& accounts)>;
  using Answer = std::function<void(const Stored<Account>& account)>;
  /// `question` is asked on a thread of its own. No answer comes to a page that is hidden by then.
  void ask_records(Question question, Answer answer);
  enum class Given { password, pin, number };  // number: a student's number alone
  void refuse_sign_in(const StorageFailure& failure, const QString& number, Given given);
  /// A full PIN takes no further digit: each refusal empties it.
  void ask_pin_again();
  void refuse(const Message& message);
  void show_fields(int tab);

  Store& store_;
  bool first_start_ = false;
  QTabBar* who_ = nullptr;
  QWidget *student_fields_ = nullptr, *staff_fields_ = nullptr;
  QLineEdit *number_ = nullptr, *staff_number_ = nullptr, *password_ = nullptr, *repeat_ = nullptr, *name_ = nullptr;
  PinField* pin_ = nullptr;
  QPushButton *enter_ = nullptr, *try_again_ = nullptr, *way_back_ = nullptr, *try_it_ = nullptr;
  Band *band_ = nullptr, *incident_ = nullptr, *reading_only_ = nullptr;
  std::optional<Message> note_;
  QLabel* picture_ = nullptr;
  QImage image_;
  std::optional<ButtonWait> wait_;  // of enter_
  BackgroundTask asking_;
};

}  // namespace cusp::ui
