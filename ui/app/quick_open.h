/// Ctrl+K: type a few letters of a page or an exercise, Enter goes there.
#pragma once

#include <QDialog>
#include <QVector>
#include <functional>

class QLineEdit;
class QListWidget;

namespace cusp::ui {

struct Destination {
  QString name, kind, icon;
  std::function<void()> attempt;
};

class QuickOpen : public QDialog {
  Q_OBJECT

 public:
  QuickOpen(QVector<Destination> places, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void narrow(const QString& text);
  void open_chosen();
  QVector<Destination> places_;
  QLineEdit* line_;
  QListWidget* list_;
};

}  // namespace cusp::ui
