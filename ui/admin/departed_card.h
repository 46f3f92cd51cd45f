/// Students who left: those without an attempt for as many years as the school says, and their erasure after a question.
/// Thread: GUI; the records are read and written in the background, by a store of its own.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "storage/exchange/trust.h"
#include "storage/retention/departed.h"
#include "ui/modules.h"
#include "ui/session/records_task.h"
#include "ui/widgets/at_work.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/ports.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace cusp::ui {

class NumberField;

class DepartedCard : public Card, public AtWork {
  Q_OBJECT

 public:
  /// The ports outlive the card.
  DepartedCard(RecordsBeside records, const Actor& actor, const Ports& ports, QWidget* parent = nullptr);
  bool working() const override { return working_; }
  /// Who would be erased; empty without years.
  QString found() const;
  void choose_years(int years);

 public Q_SLOTS:
  void erase();

 Q_SIGNALS:
  void reported(cusp::ui::Band::Kind kind, const QString& what, const QString& more);
  /// The list of accounts has changed.
  void erased();

 private:
  struct Found {
    DepartedStudents departed;
    std::vector<OtherKey> others;
  };
  static Stored<Found> read_departed(const RecordsBeside& records, const Actor& actor, int years);
  int years() const;
  void look();
  void show_found(const Stored<Found>& found);
  /// nullopt: nobody is, for others have left by now than the question named.
  void show_erased(const Stored<std::optional<DepartedStudents>>& outcome);
  void report_failure(const StorageFailure& failure);

  RecordsBeside records_;
  Actor actor_;
  const Ports& ports_;
  bool working_ = false;
  Found found_;
  BackgroundTask task_;
  QLabel* text_ = nullptr;
  QPlainTextEdit* names_ = nullptr;  // of all, where the text names the first alone
  NumberField* years_ = nullptr;
  QPushButton* erase_ = nullptr;
};

}  // namespace cusp::ui
