/// Clock, file picker and message box, injected so that tests answer them. No function waits: the answer comes through `then`,
/// or never if the window is closed. Thread: GUI.
#pragma once

#include <QDateTime>
#include <QString>
#include <chrono>
#include <functional>
#include <memory>

class QDialog;
class QWidget;

namespace cusp::ui {

/// A question before an act that cannot be undone.
struct Question {
  QString what;            // bold: "Remove the PIN of Lena Brandt?"
  QString more;            // what follows from it
  QString act;             // the verb on the button
  bool erases = false;     // red outline
  QString stay{};          // on the other button, which is then the default; empty: Cancel
  QString code{};          // that must be typed before the act; empty: none
};

struct FileWish {
  enum class What { file, new_file, folder };  // new_file: its writer replaces none, and the picker offers no replacing
  QString title;
  QString name;            // suggested file name (saving)
  QString filter;          // "CSV (*.csv)"
  bool saving = true;
  What what = What::file;  // of a folder title alone counts
};

struct Ports {
  std::function<QDateTime()> now;
  /// Milliseconds that rise, also while the computer sleeps. Empty: the system's.
  std::function<std::chrono::milliseconds()> since_boot{};
  /// `then` gets true when the act was chosen.
  std::function<void(QWidget* parent, const Question&, std::function<void(bool)> then)> ask;
  /// `then` gets the path; not called when the picker was cancelled.
  std::function<void(QWidget* parent, const FileWish&, std::function<void(const QString&)> then)> pick_file;

  /// Keeps screen and computer awake as long as what it gives stands. `why`: for the desktop to show. Empty: nobody does.
  std::function<std::shared_ptr<void>(const QString& why)> keep_awake;

  static Ports of_the_system();
};

/// Makes the opener's window the active one when `dialog` closes, unless another dialog is open by then.
/// If a dialog closes together with its own question, some window managers leave no window active, and keys go nowhere.
void activate_after(const QDialog& dialog, QWidget* opener);

}  // namespace cusp::ui
