/// Asks who has just ended an attempt to rate each criterion, before anything of the result is shown. Keys 1 to 3 rate a row and
/// go on to the next one. Thread: GUI.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "scenarios/format/scenario.h"
#include "storage/records/self_assessment.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/half_filled.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class Band;
class Segments;

class SelfAssessmentPage : public QWidget, public HalfFilled {
  Q_OBJECT

 public:
  /// What follows: the result, or that an assessment is handed in.
  enum class Then : std::uint8_t { result, handed_in };
  /// `tissues`: the names that the tooth's volume gives its tissues.
  SelfAssessmentPage(const Scenario& scenario, Then then, const TissueNames& tissues = {}, QWidget* parent = nullptr);
  /// As it is chosen now.
  SelfAssessment own() const;
  bool half_filled() const override { return !own().ratings.empty(); }
  Segments* row(std::size_t criterion) const { return rows_[criterion].steps; }
  /// It could not be kept: one tries again, or goes on without it.
  void show_failure(const Message& message);

 Q_SIGNALS:
  /// Rated, or skipped. Emitted again if it could not be kept and one tries again.
  void decided(const SelfAssessment& own);
  /// One goes on without it after a failure.
  void passed_over();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Row {
    std::string criterion;
    Segments* steps;
  };
  void add_rows(QVBoxLayout& column, const Scenario& scenario, const TissueNames& tissues);
  void add_buttons(QVBoxLayout& column, Then then);
  void count();
  void rate_next(int step);
  void focus_row(std::size_t index);

  std::vector<Row> rows_;
  Band* band_;
  QLabel* counted_;
  QPushButton *go_on_, *skip_;
  bool failed_ = false;
};

}  // namespace cusp::ui
