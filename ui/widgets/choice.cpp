#include "ui/widgets/choice.h"

#include <QComboBox>

#include "ui/widgets/theme.h"

namespace cusp::ui {

QComboBox* make_choice(const QString& name) {
  auto* box = new QComboBox;
  box->setAccessibleName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  box->setMinimumWidth(px(110));
  box->setMaximumWidth(px(360));
  return box;
}

}  // namespace cusp::ui
