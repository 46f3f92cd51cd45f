/// Performance history of all: filters, four figures, two charts, the table of attempts, CSV. Enter opens an attempt's report.
#pragma once

#include <QWidget>
#include <filesystem>
#include <memory>
#include <optional>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/widgets/at_work.h"
#include "ui/widgets/ports.h"
#include "ui/widgets/rereads.h"

class QBoxLayout;
class QComboBox;
class QGridLayout;
class QDateEdit;
class QLabel;
class QLineEdit;
class QSortFilterProxyModel;
class QStackedWidget;

namespace cusp::ui {

class Band;
class Chart;
class Card;
class CriteriaCard;
class ExportRun;
struct Exercise;
class AttemptsModel;
class Table;

class Performance : public QWidget, public Rereads, public AtWork {
  Q_OBJECT

 public:
  /// `volumes`: folder for the volumes of exercises (exercise_folder()).
  Performance(Store& store, const Actor& reader, const Ports& ports, std::filesystem::path volumes = {}, QWidget* parent = nullptr);

  /// Without attempts of scripted operators, unless they are chosen as who drilled or as the device.
  HistoryFilter filter() const;
  bool read_again() override;
  const AttemptsModel& attempts() const { return *model_; }
  Table* table() const { return table_; }
  QLineEdit* search() const { return search_; }
  QComboBox* exercise() const { return exercise_; }
  QComboBox* version() const { return version_; }
  QComboBox* cohort() const { return cohort_; }
  QComboBox* who() const { return who_; }
  QComboBox* device() const { return device_; }
  QComboBox* kind() const { return kind_; }
  QComboBox* result() const { return result_; }
  CriteriaCard* criteria() const { return criteria_; }
  QComboBox* period() const { return period_; }
  bool exporting() const;
  bool working() const override { return exporting(); }

 public Q_SLOTS:
  void read();
  /// Asks for the file, then writes what the filters leave in the background.
  void export_csv();
  void cancel_export();
  /// Asks for the file of an appeal pack.
  void choose_pack();

 Q_SIGNALS:
  void report_wanted(const SessionId& session);
  void pack_wanted(const QString& path);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* make_filters();
  QWidget* make_figures();
  QBoxLayout* make_charts();
  QWidget* make_table();
  QWidget* make_progress();
  void fill_filters();
  /// What the records hold to be filtered by; what is chosen stays. False: the records could not be read.
  bool offer_choices();
  std::vector<QComboBox*> choices() const { return {exercise_, version_, cohort_, who_, kind_, result_, device_, period_}; }
  /// The versions of the chosen exercise.
  void fill_versions();
  /// nullopt: it could not be read, which unread_ then shows.
  std::optional<HistoryPage> page(const HistoryFilter& filter, const std::optional<HistoryKey>& after);
  /// Fetches the rest of the attempts for another order than the newest first; with too many, or if a page fails, it keeps that order
  /// and says so.
  void fetch_for_order(int column, Qt::SortOrder order);
  /// The filter's exercise in its version, else in its newest one that can be read. nullopt: in none.
  std::optional<Exercise> exercise_of(const HistoryFilter& shown);
  void show_failure(const StorageFailure& failure);
  void export_to(const QString& path, const HistoryFilter& shown);
  void show_no_figures();
  void show_numbers(const Figures& figures);
  void show_spread(const Figures& figures);
  void show_learning(const Figures& figures);
  /// In place of the chart.
  void show_no_learning(const QString& why);

  Store& store_;
  Actor reader_;
  const Ports& ports_;
  std::filesystem::path volumes_;
  AttemptsModel* model_;
  QSortFilterProxyModel* sorted_;
  Table* table_ = nullptr;
  QStackedWidget* below_ = nullptr;
  Band* band_ = nullptr;
  Band* unread_ = nullptr;  // shows after a page of the table that could not be read
  QLabel* without_scripted_ = nullptr;
  bool any_scripted_ = false;  // attempts of scripted operators in the records
  ExportRun* export_ = nullptr;
  QComboBox *exercise_ = nullptr, *version_ = nullptr, *cohort_ = nullptr, *who_ = nullptr, *kind_ = nullptr;
  QComboBox *result_ = nullptr, *device_ = nullptr, *period_ = nullptr;
  QLineEdit* search_ = nullptr;
  static constexpr int kFigures = 4;
  QLabel *figure_[kFigures] = {}, *note_[kFigures] = {};  // each in a card
  QGridLayout* figures_ = nullptr;
  Chart *spread_ = nullptr, *learning_ = nullptr;
  Card* learning_card_ = nullptr;
  QLabel* no_learning_ = nullptr;  // why it has no chart
  CriteriaCard* criteria_ = nullptr;  // shows with an exercise
  QBoxLayout* charts_ = nullptr;
};

}  // namespace cusp::ui
