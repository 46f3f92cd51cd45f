/// A page with a form whose content stands nowhere else until it is saved. Thread: GUI.
#pragma once

#include "ui/widgets/ports.h"

namespace cusp::ui {

class HalfFilled {
 public:
  /// Something is typed or chosen that is lost with the page.
  virtual bool half_filled() const = 0;

 protected:
  ~HalfFilled() = default;
};

/// Asked before a half-filled form is left.
Question leave_form_question();

}  // namespace cusp::ui
