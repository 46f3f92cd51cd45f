/// Compares two grades, one line a criterion: ring for the old share of points, dot for the new one, difference at the right.
/// Thread: GUI.
#pragma once

#include <QVector>
#include <QWidget>

#include "scenarios/grading/grade.h"
#include "ui/modules.h"
#include "ui/text/names.h"

namespace cusp::ui {

class AgainstBefore : public QWidget {
  Q_OBJECT

 public:
  /// `whole`: the exercise's target, for the titles of several. `own`: the names that the tooth's volume gives its tissues.
  AgainstBefore(const Grade& now, const Grade& before, const Region* whole = nullptr, const TissueNames& own = {}, QWidget* parent = nullptr);
  struct Row {
    QString name;
    double before = 0, now = 0;  // shares of the full points, 0 to 1
    double points = 0;           // gained
  };
  const QVector<Row>& rows() const { return rows_; }
  /// The least width at which no name is cut, px.
  int whole_width() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  /// Width of the longest name with its gap, px.
  int longest_name() const;
  /// The same, limited to a share of the widget.
  double names_width() const;

  QVector<Row> rows_;
  int decimals_ = 0;  // of the points gained
};

}  // namespace cusp::ui
