#include "ui/widgets/ports.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "ui/widgets/theme.h"

namespace cusp::ui {

Ports Ports::of_the_system() {
  Ports ports;
  ports.now = [] { return QDateTime::currentDateTime(); };
  ports.ask = [](QWidget* parent, const Question& question, std::function<void(bool)> then) {
    auto* box = new QMessageBox(parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(QStringLiteral("Cusp"));
    box->setText(QStringLiteral("<b>%1</b>").arg(question.what.toHtmlEscaped()));
    box->setInformativeText(question.more);
    const bool stays = !question.stay.isEmpty();
    QPushButton* act = box->addButton(question.act, QMessageBox::AcceptRole);
    QPushButton* stay = stays ? box->addButton(question.stay, QMessageBox::RejectRole) : box->addButton(QMessageBox::Cancel);
    stay->setIcon({});  // the style's own sign is of another family
    if (question.erases || !stays) set_kind(act, question.erases ? "erase" : "primary");
    if (stays) set_kind(stay, "primary");
    box->setDefaultButton(question.erases || stays ? stay : act);
    box->setEscapeButton(stay);
    QObject::connect(box, &QMessageBox::finished, box, [box, act, then] { then(box->clickedButton() == act); });
    box->open();
  };
  ports.pick_file = [](QWidget* parent, const FileWish& wish, std::function<void(const QString&)> then) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    auto* dialog = new QFileDialog(parent, wish.title, folder, wish.filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(wish.saving ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(wish.saving ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    if (wish.saving) dialog->selectFile(wish.name);
    if (wish.what == FileWish::What::folder) {
      dialog->setAcceptMode(QFileDialog::AcceptOpen);
      dialog->setFileMode(QFileDialog::Directory);
    }
    QObject::connect(dialog, &QFileDialog::fileSelected, dialog, [then](const QString& path) { then(path); });
    dialog->open();
  };
  return ports;
}

}  // namespace cusp::ui
