/// Asks for template, tooth and parameters of a new exercise, and shows after each change whether they make one. It writes
/// nothing: made() gives the exercise, Cancel leaves everything as it was. Thread: GUI.
#pragma once

#include <QDialog>
#include <QTimer>
#include <optional>
#include <vector>

#include "scenarios/templates/templates.h"
#include "ui/modules.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QScrollArea;

namespace cusp::ui {

class Band;
class NumberField;

class TemplateDialog : public QDialog {
  Q_OBJECT

 public:
  /// Begins with the template of that key; the user may choose another.
  explicit TemplateDialog(const std::string& key, QWidget* parent = nullptr);
  ~TemplateDialog() override;
  /// Makes the exercise and closes; stays open if the values make none.
  void accept() override;

 Q_SIGNALS:
  /// An exercise with an id of its own.
  void made(const Scenario& exercise);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// A choice is a check box, any other parameter a number.
  struct Row {
    TemplateParameter parameter;
    NumberField* number = nullptr;
    QCheckBox* choice = nullptr;
    QLabel* note = nullptr;
    double usual = 0;  // on the chosen tooth
    QWidget* field() const;
    double value() const;
    void show(double value);
    bool at_default() const;
  };

  void make_choices();
  void make_foot();
  void show_template();
  void add_row(QFormLayout& form, const TemplateParameter& parameter);
  QWidget* make_field(Row& row);
  void show_defaults();
  void take_edit();
  QString refusal() const;
  void fit();
  enum class Fits : std::uint8_t { no, yes };
  void show_standing(Fits fits, const QString& text);
  void fit_height();
  void order_fields();
  const ExerciseTemplate& chosen() const;
  FitRequest request() const;

  ScenarioId id_;
  std::vector<Row> rows_;
  std::optional<Scenario> exercise_;  // of the values shown, while they make one
  QTimer fit_soon_;
  QComboBox *template_ = nullptr, *tooth_ = nullptr;
  QLabel* about_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  Band* band_ = nullptr;
  QPushButton *cancel_ = nullptr, *make_ = nullptr;
};

}  // namespace cusp::ui
