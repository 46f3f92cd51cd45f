/// Each criterion's share of its points, before and now, on one line each: ring before, dot now, difference at the right.
#pragma once

#include <QVector>
#include <QWidget>

#include "scenarios/grading/grade.h"
#include "ui/modules.h"

namespace cusp::ui {

class AgainstBefore : public QWidget {
  Q_OBJECT

 public:
  AgainstBefore(const Grade& now, const Grade& before, QWidget* parent = nullptr);
  struct Row {
    QString name;
    double before = 0, now = 0;  // shares of the full points
    double points = 0;           // gained
  };
  const QVector<Row>& rows() const { return rows_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  /// Width of the names: what the longest needs, up to the share that the lines can spare.
  double names_width() const;

  QVector<Row> rows_;
};

}  // namespace cusp::ui
