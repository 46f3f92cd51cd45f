#include "ui/device/kept_band.h"

#include <QCoreApplication>
#include <utility>

namespace cusp::ui {
namespace {

struct KeptText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::KeptBand)
};

}  // namespace

KeptBand::KeptBand(QString file, QWidget* parent) : Band(parent), file_(std::move(file)) {}

void KeptBand::show_kept(bool kept) {
  if (kept) return clear();
  if (!isHidden()) return;
  show_message(Kind::bad, KeptText::tr("What is changed here holds until Cusp is closed."),
               KeptText::tr("%1 cannot be written, so the next start does not know it.").arg(file_));
}

}  // namespace cusp::ui
