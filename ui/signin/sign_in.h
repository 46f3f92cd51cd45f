/// Sign-in: number and PIN first, staff second, Try it apart; on the first start it makes the administrator instead.
/// It asks storage and says what came; who is signed in is the desktop's to know.
#pragma once

#include <QImage>
#include <QWidget>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace cusp::ui {

class Band;
class PinBoxes;
class Segments;

class SignIn : public QWidget {
  Q_OBJECT

 public:
  explicit SignIn(Store& store, QWidget* parent = nullptr);

  /// Shown at the right, from 1100 px of width on.
  void set_picture(const QImage& picture);
  /// What was typed survives a change of language or scale.
  QString typed_number() const;
  void set_typed_number(const QString& number, bool staff);
  bool staff() const;
  /// What opening the records met: shown to staff alone. Where there is no administrator yet, to whoever makes one.
  void show_incident(const Message& message);
  /// Nothing can be written: shown to everybody, with a way to try again.
  void show_reading_only(const Message& why);
  bool first_start() const { return first_start_; }
  QString message() const;

 Q_SIGNALS:
  void signed_in(const Account& account);
  void try_it();
  void try_again();
  void language_chosen(const QString& code);
  void theme_toggled();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* make_head();
  QWidget* make_notices();
  QWidget* make_sign_in_form();
  QWidget* make_first_start_form();
  void submit();
  void create_administrator();
  void refuse(const Message& message);
  void show_segment(int index);

  Store& store_;
  bool first_start_ = false;
  Segments* who_ = nullptr;
  QWidget *student_fields_ = nullptr, *staff_fields_ = nullptr;
  QLineEdit *number_ = nullptr, *staff_number_ = nullptr, *password_ = nullptr, *repeat_ = nullptr, *name_ = nullptr;
  PinBoxes* pin_ = nullptr;
  QPushButton *enter_ = nullptr, *try_again_ = nullptr;
  Band *band_ = nullptr, *incident_ = nullptr, *reading_only_ = nullptr;
  QLabel* picture_ = nullptr;
  QImage image_;
};

}  // namespace cusp::ui
