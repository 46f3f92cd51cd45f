/// The way from a new station to its first report in five pictures: shown after the first administrator is made, and from Help.
/// Thread: GUI.
#pragma once

#include <QVector>
#include <QWidget>

class QGridLayout;

namespace cusp::ui {

class Card;

class QuickStart : public QWidget {
  Q_OBJECT

 public:
  explicit QuickStart(QWidget* parent = nullptr);

 Q_SIGNALS:
  void back_wanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_cards();

  QGridLayout* grid_ = nullptr;
  QVector<Card*> cards_;  // as many in a row as the width holds
};

}  // namespace cusp::ui
