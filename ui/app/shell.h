/// The frame round everyday pages: top bar (48), sidebar (200), and the page.
#pragma once

#include <QIcon>
#include <QVector>
#include <QWidget>
#include <functional>
#include <utility>

#include "storage/repositories/accounts.h"
#include "ui/modules.h"
#include "ui/widgets/parts.h"

class QButtonGroup;
class QLabel;
class QMenu;
class QPushButton;
class QStackedWidget;
class QToolButton;
class QVBoxLayout;

namespace cusp::ui {

struct Message;

/// One line of the sidebar. The page is made when it is first shown, and anew each time it is chosen again, so that it
/// never shows yesterday's results.
struct NavEntry {
  QString key;   // stable: "start", "people"
  QString name;
  QString icon;
  std::function<QWidget*()> make;
};

class Shell : public QWidget {
  Q_OBJECT

 public:
  Shell(const Account& account, QVector<NavEntry> entries, QWidget* parent = nullptr);
  void show_page(const QString& key);
  /// The page after another one lay over it: read anew where it can be (Rereads), else made anew.
  void show_again();
  QString page_key() const { return key_; }
  QWidget* page() const;
  /// What attempts are drilled with, at the foot of the sidebar.
  void show_device(const QString& name, const QString& icon_name);
  /// A band over the pages that stays: what is the matter with the records.
  void show_notice(const Message& message);
  /// A band over the pages with how work ended whose page was left. It stays until somebody closes it; then it calls `closed`.
  void show_outcome(Band::Kind kind, const Message& outcome, std::function<void()> closed);
  const QVector<NavEntry>& entries() const { return entries_; }
  /// Offers in the account's menu which hand holds the handpiece, and keeps the choice there. `settings` outlives this.
  void keep_hand_in(class Settings& settings);
  /// Calls `then` at once, later, or never.
  using Leave = std::function<void(std::function<void()> then)>;
  /// What a press in the sidebar passes before the page is left.
  void ask_before_leaving(Leave leave) { leave_ = std::move(leave); }
  /// Offers beside the languages of the program those of the exercises' texts. `chosen`: "" = as the program.
  void offer_exercise_languages(const QStringList& codes, const QString& chosen);
  /// Moves the focus to the next of top bar, sidebar and page.
  void next_pane();

 Q_SIGNALS:
  void language_chosen(const QString& code);
  void exercise_language_chosen(const QString& code);
  void theme_toggled();
  void scale_chosen(int percent);
  void help_wanted();
  void password_wanted();
  void signed_out();

 private:
  QWidget* make_top_bar(const Account& account);
  QToolButton* make_language_button();
  QPushButton* make_account_button(const Account& account);
  QMenu* make_account_menu(const Account& account, QWidget* button);
  QWidget* make_sidebar();
  void leave_for(const QString& key);

  QVector<NavEntry> entries_;
  QString key_;
  Leave leave_ = [](const std::function<void()>& then) { then(); };
  QWidget *top_ = nullptr, *side_ = nullptr;
  QMenu *account_menu_ = nullptr, *language_menu_ = nullptr;
  QLabel *device_sign_ = nullptr, *device_ = nullptr;
  Band* notice_;
  QVBoxLayout* above_ = nullptr;  // bands over the pages
  QButtonGroup* group_;
  QStackedWidget* pages_;
};

}  // namespace cusp::ui
