#include "ui/widgets/ports.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

namespace {

/// Takes out the indent that Qt keeps for a sign: without one, the text begins where field and buttons do.
void align_text(QMessageBox& box) {
  auto* grid = qobject_cast<QGridLayout*>(box.layout());
  if (grid == nullptr) return;
  for (int i = 0; i < grid->count(); ++i)
    if (QSpacerItem* indent = grid->itemAt(i)->spacerItem()) indent->changeSize(0, 0, QSizePolicy::Fixed, QSizePolicy::Fixed);
  grid->setHorizontalSpacing(0);
  grid->setColumnStretch(grid->columnCount() - 1, 1);  // the buttons may need more width than the text
  grid->invalidate();
}

/// Takes the keys that repeat: who still holds Enter from the button that asks has read nothing, and would answer.
class HeldKeys : public QObject {
 public:
  explicit HeldKeys(QMessageBox& box) : QObject(&box) {
    box.installEventFilter(this);
    for (QAbstractButton* button : box.buttons()) button->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool held = event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->isAutoRepeat();
    return held || QObject::eventFilter(watched, event);
  }
};

/// Adds a field to a box whose act waits for the right code.
void ask_code(QMessageBox& box, QPushButton& act, const Question& question) {
  act.setEnabled(false);
  auto* grid = qobject_cast<QGridLayout*>(box.layout());
  auto* buttons = box.findChild<QDialogButtonBox*>();
  if (grid == nullptr || buttons == nullptr) return;
  auto* typed = new QLineEdit;
  typed->setAccessibleName(question.more);
  const int row = grid->rowCount();
  grid->addWidget(typed, row, 0, 1, -1);
  grid->addWidget(buttons, row + 1, 0, 1, -1);  // below the field
  QObject::connect(typed, &QLineEdit::textChanged, &act, [&act, code = question.code](const QString& text) { act.setEnabled(text.trimmed() == code); });
  typed->setFocus();
}

}  // namespace

Ports Ports::of_the_system() {
  Ports ports;
  ports.now = [] { return QDateTime::currentDateTime(); };
  ports.ask = [](QWidget* parent, const Question& question, std::function<void(bool)> then) {
    auto* box = new QMessageBox(parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(QStringLiteral("Cusp"));
    box->setText(QStringLiteral("<b>%1</b>").arg(question.what.toHtmlEscaped()));
    if (!question.more.isEmpty()) box->setInformativeText(tool_tip_text(question.more));
    const bool stays = !question.stay.isEmpty();
    QPushButton* act = box->addButton(question.act, QMessageBox::AcceptRole);
    QPushButton* stay = stays ? box->addButton(question.stay, QMessageBox::RejectRole) : box->addButton(QMessageBox::Cancel);
    if (question.erases || !stays) set_kind(act, question.erases ? "erase" : "primary");
    if (stays) set_kind(stay, "primary");
    box->setDefaultButton(question.erases || stays ? stay : act);
    box->setEscapeButton(stay);
    align_text(*box);
    if (!question.code.isEmpty()) ask_code(*box, *act, question);
    new HeldKeys(*box);
    QObject::connect(box, &QMessageBox::finished, box, [box, act, then] { then(box->clickedButton() == act); });
    box->open();
  };
  ports.pick_file = [](QWidget* parent, const FileWish& wish, std::function<void(const QString&)> then) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    auto* dialog = new QFileDialog(parent, wish.title, folder, wish.filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(wish.saving ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(wish.saving ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    if (wish.saving) {
      dialog->selectFile(wish.name);
      dialog->setDefaultSuffix(QFileInfo(wish.name).suffix());  // the dialog then asks before it replaces that file
      dialog->setOption(QFileDialog::DontConfirmOverwrite, wish.what == FileWish::What::new_file);
    }
    if (wish.what == FileWish::What::folder) {
      dialog->setAcceptMode(QFileDialog::AcceptOpen);
      dialog->setFileMode(QFileDialog::Directory);
    }
    QObject::connect(dialog, &QFileDialog::fileSelected, dialog, [then](const QString& path) { then(path); });
    if (parent != nullptr) activate_after(*dialog, parent);  // the picker itself asks before it replaces a file
    dialog->open();
  };
  return ports;
}

void activate_after(const QDialog& dialog, QWidget* opener) {
  QObject::connect(&dialog, &QDialog::finished, opener, [opener] {
    if (QApplication::activeModalWidget() == nullptr) opener->activateWindow();
  });
}

}  // namespace cusp::ui
