#include "ui/widgets/half_filled.h"

#include <QCoreApplication>

namespace cusp::ui {
namespace {

struct LeaveText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::HalfFilled)
};

}  // namespace

Question leave_form_question() {
  return {LeaveText::tr("Leave without saving the form?"), LeaveText::tr("What was filled in and not saved is not kept."), LeaveText::tr("Leave"), true};
}

}  // namespace cusp::ui
