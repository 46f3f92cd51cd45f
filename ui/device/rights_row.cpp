#include "ui/device/rights_row.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/device/panel_card.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

RightsRow::RightsRow(QWidget* parent) : QWidget(parent) {
  QVBoxLayout* column = make_column(this, 4);
  auto* what = make_label(tr("This user may not open it. Paste this line into a terminal once, then plug it in again:"),
                          TextRole::body, Weight::regular, "look");
  what->setWordWrap(true);
  column->addWidget(what);
  auto* row = new QHBoxLayout;
  row->setSpacing(px(8));
  line_ = new QLineEdit;
  line_->setReadOnly(true);
  line_->setLayoutDirection(Qt::LeftToRight);
  line_->setAccessibleName(tr("Line for the terminal"));
  row->addWidget(line_, 1);
  QPushButton* copy = make_button(tr("Copy"), ButtonKind::standard, QStringLiteral("copy"));
  connect(copy, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(line_->text());
    announce(this, tr("Copied"));
  });
  row->addWidget(copy);
  column->addLayout(row);
  hide();
}

void RightsRow::set_command(const QString& command) {
  if (line_->text() != command) {
    line_->setText(command);
    line_->setCursorPosition(0);
  }
  setVisible(!command.isEmpty());
}

}  // namespace cusp::ui
