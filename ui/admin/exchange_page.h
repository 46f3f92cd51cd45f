/// Files between stations: this station's key, whose files are read here, giving a file out and reading one in. Each file is shown
/// before it changes anything. Thread: GUI; files are written and read in the background on stores of their own.
#pragma once

#include <QWidget>
#include <optional>

#include "storage/exchange/exchange.h"
#include "storage/store.h"
#include "ui/admin/exchange_work.h"
#include "ui/admin/stations_model.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"
#include "ui/settings/settings.h"
#include "ui/widgets/at_work.h"
#include "ui/widgets/ports.h"

class QBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace cusp::ui {

class Band;
class Card;
struct KeyToTrust;
struct Message;
class Table;

class ExchangePage : public QWidget, public AtWork {
  Q_OBJECT

 public:
  /// Store, settings and ports outlive the page.
  ExchangePage(Store& store, const Actor& actor, Settings& settings, const Ports& ports, QWidget* parent = nullptr);
  QString message() const;
  bool working() const override { return run_->running(); }
  /// What stands in place of the list: comparing a key, looking at a file, or neither.
  enum class Step { stations, key, file };
  Step step() const { return step_; }

 public Q_SLOTS:
  void save_key();
  void copy_fingerprint();
  void choose_key();
  void open_station();
  void revoke_station();
  void give_out_results();
  void give_out_office();
  void choose_file();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  static constexpr int kStackBelow = 800, kActsBelow = 560;  // px at 100 %, of the page: cards, and buttons of the list

  QWidget* make_head();
  QWidget* make_stations();
  QWidget* make_own_key();
  QWidget* make_giving_out();
  void read_stations();
  void show_chosen();
  void show_step(Step step, Card* card);
  void back_to_stations();
  void show_failure(const QString& what, const Message& message);
  void show_stopped(const QString& what);
  void ask_for_key(const KeyToTrust& asked);
  /// `known`: as its card showed it. Nothing is written if another window has changed that since.
  void trust_key(const PublicKey& key, std::optional<KeyRole> known, KeyRole role, const QString& name);
  std::optional<KeyRole> role_of(const PublicKey& key) const;
  void give_out_to(ExchangeKind kind);
  void show_given_out(const Stored<GivenOut>& given);
  void look_into(const QString& path);
  void show_look(const Stored<ExchangeLook>& look);
  void show_file(const ExchangeLook& look);
  void read_in();
  void show_read_in(const Stored<ReadIn>& read);
  ExchangeWork begin(const QString& what, const QString& file, WorkRun::Counted counted);
  void end();
  QString name_of(const Uuid& station) const;
  QString own_name() const;
  QString name_in_file() const;

  Store& store_;
  Actor actor_;
  Settings& settings_;
  const Ports& ports_;
  Step step_ = Step::stations;
  QString file_;                               // that is read
  ExchangeKind kind_ = ExchangeKind::results;  // of that file, once it was checked
  QString given_;                              // that is written
  std::optional<ExchangeLook> waiting_;        // for its key
  BackgroundTask task_;
  StationsModel* model_;
  Band* band_;
  WorkRun* run_;
  QBoxLayout *columns_ = nullptr, *acts_ = nullptr;
  QStackedWidget *main_ = nullptr, *list_ = nullptr;
  Table* table_ = nullptr;
  QLineEdit* name_ = nullptr;
  QPushButton *read_ = nullptr, *add_ = nullptr, *open_ = nullptr, *revoke_ = nullptr, *results_ = nullptr, *office_ = nullptr;
};

}  // namespace cusp::ui
