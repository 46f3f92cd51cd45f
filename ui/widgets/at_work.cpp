#include "ui/widgets/at_work.h"

#include <QCoreApplication>

namespace cusp::ui {
namespace {

struct WorkText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::AtWork)
};

}  // namespace

Question leave_work_question() {
  return {WorkText::tr("Leave before the work has ended?"), WorkText::tr("How it ended is then shown nowhere."), WorkText::tr("Leave"), true};
}

}  // namespace cusp::ui
