/// The report of one attempt: the tooth by deviation at the left; score, criteria, what to do next time and the best before
/// at the right. A chosen row turns the tooth to its place and pins it.
#pragma once

#include <QPointer>
#include <QWidget>
#include <utility>
#include <vector>

#include "ui/report/report_data.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/ports.h"

class QBoxLayout;
class QFrame;
class QLabel;
class QPushButton;

namespace cusp::ui {

class CriteriaModel;
class AgainstBefore;
class BeforeAfter;
class DeviationLegend;
class PinnedTooth;
class ReportSection;
class Segments;
class Table;

class ReportPage : public QWidget {
  Q_OBJECT

 public:
  /// `offered` and `refused`: to the one who drilled it, with and without a button to a further attempt; the page then leaves out the
  /// student's name. After an assessment that button names its attempt practice. After forbid_opengl() it is disabled.
  enum class TryAgain { hidden, refused, offered };
  ReportPage(ReportData data, const Ports& ports, TryAgain again, const QString& back_name, QWidget* parent = nullptr);
  Table* table() const { return table_; }
  const ReportData& data() const { return data_; }
  /// The same attempt after somebody stated something about it. The tooth stays.
  void show_data(ReportData data);
  /// A card above the criteria: for who marks, or about an opened pack. Once.
  void set_card(QWidget* card);
  /// Shows the button of the appeal pack. `why_not`: it is disabled, with that as its tool tip.
  void offer_pack(const QString& why_not = {});
  void show_message(Band::Kind kind, const QString& what, const QString& more);
  /// Of the chosen row; nullptr: none is chosen.
  const CriterionGrade* chosen_criterion() const;

 Q_SIGNALS:
  void back_wanted();
  void try_again_wanted();
  void pack_wanted();
  void criterion_chosen();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* make_bar(TryAgain again, const QString& back_name);
  QPushButton* make_again();
  QWidget* make_tooth();
  QWidget* make_tools(QWidget& legend);
  struct TeethButtons {
    QPushButton &drilled, &both;
  };
  QPushButton* make_section(const TeethButtons& others);
  void fit_tools(int width);
  void fit_bar(int width);
  void fill();
  void order_tabs();
  /// Emits `wanted`; first it asks while a comment, a reason or points under Marking are not kept.
  void leave_for(void (ReportPage::*wanted)());
  void show_state();
  void choose_first();
  QWidget* make_score();
  QWidget* make_unread();
  QWidget* make_remarks();
  QWidget* make_criteria();
  QWidget* make_next_time();
  QWidget* make_against();
  void choose(int row);
  void save_pdf();
  void print();
  /// The picture for the paper, drawn on the first call; a failure is tried again.
  const DrawnTooth& drawing();

  ReportData data_;
  const Ports& ports_;
  CriteriaModel* model_ = nullptr;
  Table* table_ = nullptr;
  PinnedTooth* tooth_ = nullptr;
  BeforeAfter* teeth_ = nullptr;  // holds the tooth
  ReportSection* section_ = nullptr;  // null without a tooth
  QBoxLayout* tools_ = nullptr;  // lines of buttons
  std::vector<QWidget*> shown_;  // the tools, in the order of reading
  AgainstBefore* against_ = nullptr;  // if an attempt came before
  Band* band_ = nullptr;         // of the attempt: what fails it
  Band* news_ = nullptr;         // of what was saved or printed
  std::optional<DrawnTooth> drawing_;
  std::vector<std::pair<QPushButton*, QString>> saves_;  // print, PDF and pack, with their texts
  QPushButton* pack_ = nullptr;
  QFrame* bar_ = nullptr;  // at the head of the page
  QLabel *title_ = nullptr, *aside_ = nullptr;     // in it
  QLabel* occasion_ = nullptr;      // as aside_, beside the score of a page that has no room for it
  QBoxLayout* outcome_ = nullptr;   // passed or not, and of how many points
  QBoxLayout* body_;  // of the text
  QWidget *head_ = nullptr, *main_ = nullptr;  // of the text: made anew by fill()
  QPointer<QWidget> card_;                     // between them
  QBoxLayout* halves_;                         // tooth and text
  QBoxLayout* below_ = nullptr;                // advice and comparison
};

}  // namespace cusp::ui
