/// Letters of a tooth's sides. Frame: specimen.
#pragma once

#include <QString>
#include <array>

#include "engine/base/vec.h"
#include "ui/modules.h"

namespace cusp::ui {

struct ToothSide {
  Vec3 way;  // unit
  QString letter;
};
/// Mesial, distal, buccal, and lingual or palatal, as the frame has them (scenarios/teeth/landmarks.h). Pre: is_tooth_number(fdi).
std::array<ToothSide, 4> tooth_sides(int fdi);
bool is_tooth_number(int fdi);

}  // namespace cusp::ui
