/// Marks one attempt: comments, points that count instead, critical events that do not count, confirmation, release, and
/// taking each of them back. The reader's own attempt takes comments alone. In a low window it begins as one line. Every act is a
/// statement in the records. Thread: GUI.
#pragma once

#include <functional>
#include <map>
#include <utility>

#include "scenarios/grading/maxima.h"
#include "ui/report/report_data.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/ports.h"

class QCheckBox;
class QComboBox;
class QPlainTextEdit;

namespace cusp::ui {

class NumberField;

class MarkingCard : public Card {
  Q_OBJECT

 public:
  /// Pre: `report` comes from the records, with a grade; the actor may comment. Store and ports outlive the card.
  MarkingCard(Store& store, const Actor& actor, const ReportData& report, const Ports& ports, QWidget* parent = nullptr);
  /// What a comment's place and changed points concern; nullptr: nothing.
  void set_criterion(const CriterionGrade* criterion);
  void show_data(const ReportData& report);
  /// A comment or reason stands in the field and is not kept.
  bool has_comment() const { return !reason().isEmpty(); }
  /// Other points than those that count are typed, and not stated.
  bool has_points() const;
  bool unsaved() const { return has_comment() || has_points(); }
  QString written() const;
  void write(const QString& text);
  const SessionId& session() const { return session_; }

 Q_SIGNALS:
  /// Something was stated or taken back, here or at another desk.
  void stated();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void make_fold();
  enum class Content { shown, hidden };
  void show_content(Content content);
  QWidget* make_points();
  QWidget* make_result();
  QWidget* make_taking_back();
  QString reason() const;
  enum class Text { used, kept };  // what stands in the field
  /// Shows a failure, or tells that it is done.
  void finish(const Stored<SignedStatement>& result, const QString& done, Text text = Text::used);
  /// False, with a message, if another desk changed the result since the card shows it. True where the records give no answer.
  bool still_stands();
  void comment();
  void change_points();
  void strike();
  void take_back();

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  SessionId session_;
  Region target_;  // of the exercise: titles of several targets
  TissueNames tissue_names_;
  std::string criterion_;
  std::optional<Vec3> place_mm_;
  std::optional<std::pair<int, std::vector<Uuid>>> seen_;  // grade and changes that the report shows; none while it is read anew
  double points_now_ = 0, points_most_ = 0;  // of the criterion: as they count, and full ones; in the grade's own points
  double scale_ = 1;                         // points of the score for one of these (score_per_point)
  std::optional<Hash256> read_;  // shown_hash() of the result that the report shows
  ScaledPoints shown_;                       // of the criterion, as the report's table shows them
  std::map<std::string, ScaledPoints> in_table_;  // by criterion
  Band* band_;
  QPlainTextEdit* text_;
  QCheckBox* at_place_;
  QPushButton* fold_ = nullptr;
  QWidget* content_ = nullptr;
  bool chosen_ = false;  // to be open or not
  QLabel* points_label_ = nullptr;
  NumberField* points_ = nullptr;
  QPushButton *change_ = nullptr, *strike_ = nullptr, *confirm_ = nullptr, *release_ = nullptr, *take_back_ = nullptr;
  QComboBox *events_ = nullptr, *remarks_ = nullptr;
  QWidget *events_row_ = nullptr, *remarks_row_ = nullptr;
};

}  // namespace cusp::ui
