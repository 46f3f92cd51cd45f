/// The instructor's exercises: opens one in the editor, begins a new one, empty, from a template or as a copy, imports a specimen,
/// saves one as a file and opens such a file, and withdraws a published version. Thread: GUI.
#pragma once

#include <QWidget>
#include <filesystem>
#include <functional>
#include <variant>

#include "scenarios/library/exercise_file.h"
#include "storage/store.h"
#include "ui/editor/editor_model.h"
#include "ui/instructor/exchange.h"
#include "ui/instructor/library_model.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/widgets/at_work.h"
#include "ui/widgets/ports.h"
#include "ui/widgets/rereads.h"

class QAction;
class QLineEdit;
class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QStackedWidget;

namespace cusp::ui {

class Band;
class ExerciseCard;
class Table;
class ThumbnailCache;
struct Withdrawal;

class LibraryPage : public QWidget, public Rereads, public AtWork {
  Q_OBJECT

 public:
  /// Volumes of drafts lie beside `database`, those of published versions in `cache`. Without `pictures` no tooth is shown.
  LibraryPage(Store& store, const Actor& actor, const Ports& ports, std::filesystem::path database,
              std::filesystem::path cache, ThumbnailCache* pictures = nullptr, QWidget* parent = nullptr);
  bool read_again() override;
  Table* table() const { return table_; }
  QLineEdit* search() const { return search_; }
  const LibraryModel& model() const { return *model_; }
  QComboBox* groups() const { return group_; }
  QComboBox* states() const { return state_; }
  /// While a file is read or written: a volume takes seconds. No other file is opened or saved meanwhile.
  bool working() const override { return working_; }

 public Q_SLOTS:
  void open_chosen();
  void copy_chosen();
  /// A channel in the plain block.
  void begin_new();
  /// Asks for template, tooth and parameters.
  void begin_from_template(const std::string& key);
  /// Asks first; the published version stays.
  void discard_draft();
  /// Asks first, with what follows; withdraws nothing if something else follows by then. Only of a version that a person published.
  void withdraw_chosen();
  /// Asks for a file name. Saves the published version; the draft of an exercise that was never published.
  void save_chosen();
  void choose_file();
  /// Makes a draft of the exercise in the file. Asks if the library has that exercise with another content, or if another file is
  /// still being read or written.
  void open_file(const QString& path);

 Q_SIGNALS:
  void edit_wanted(const EditorStart& start);
  void import_wanted();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void read();
  void read_and_choose(ScenarioId id);  // the first row if it has none any more
  void fit_buttons();
  void show_use();
  void show_picture();
  void make_search();
  QWidget* make_filters();
  bool fits(int row) const;
  /// Shows the rows of the chosen group and state whose name or tooth has the text.
  void filter();
  QPushButton* make_new_button();
  QPushButton* make_more_button();
  void begin_as_copy(const Exercise& pattern, const LocalText& title);
  void withdraw_row(const LibraryRow& row, const Withdrawal& plan);
  /// Instead of withdrawing a version of which something else follows than was asked.
  void show_changed(const LibraryRow& row);
  void save_row(const LibraryRow& row, const QString& title, const QString& picked);
  struct Looked {
    ExerciseFile file;
    Standing standing = Standing::unknown;
    QString path{};
  };
  /// Of the records, or of the file.
  using FileFailure = std::variant<StorageFailure, ExerciseFileFailure>;
  /// work(store) on a thread and a store of their own, then then(page, answer), unless the page is gone.
  template <class Work, class Then>
  void in_background(const QString& meanwhile, Work work, Then then);
  /// Asks whether to do what another file was in the way of.
  void offer_again(const Question& question, std::function<void(LibraryPage&)> act);
  void open_looked(const Looked& looked);
  void open_taken(const Looked& looked, KeepId keep);
  int row_of(ScenarioId id) const;
  void show_failure(const StorageFailure& failure);
  void show_failure(const FileFailure& failure);

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  std::filesystem::path database_, cache_;
  LibraryModel* model_;
  Table* table_ = nullptr;
  QStackedWidget* below_ = nullptr;  // the table, or that no exercise fits
  QLineEdit* search_ = nullptr;
  Band* band_ = nullptr;
  QComboBox *group_ = nullptr, *state_ = nullptr;  // filters; the first entry of each is all
  QLabel* count_ = nullptr;
  ExerciseCard* chosen_ = nullptr;
  ThumbnailCache* pictures_;
  BackgroundTask work_;
  bool working_ = false;
  QString read_;  // path of the file that is being read, or made a draft of; empty: none is
  QAction *copy_ = nullptr, *save_ = nullptr, *withdraw_ = nullptr, *discard_ = nullptr;
};

}  // namespace cusp::ui
