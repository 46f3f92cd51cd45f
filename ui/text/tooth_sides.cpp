#include "ui/text/tooth_sides.h"

#include <QCoreApplication>

#include "scenarios/teeth/landmarks.h"

namespace cusp::ui {
namespace {

struct SidesText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Compass)
};

}  // namespace

bool is_tooth_number(int fdi) { return mesial_x(fdi) != 0; }

std::array<ToothSide, 4> tooth_sides(int fdi) {
  const double mesial = mesial_x(fdi);
  return {{{{mesial, 0, 0}, SidesText::tr("M", "mesial")},
           {{-mesial, 0, 0}, SidesText::tr("D", "distal")},
           {{0, 1, 0}, SidesText::tr("B", "buccal")},
           {{0, -1, 0}, fdi < 30 ? SidesText::tr("P", "palatal") : SidesText::tr("L", "lingual")}}};
}

}  // namespace cusp::ui
