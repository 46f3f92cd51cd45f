/// A page with a form whose content stands nowhere else until it is saved. Thread: GUI.
#pragma once

namespace cusp::ui {

class HalfFilled {
 public:
  /// Something is typed or chosen that is lost with the page.
  virtual bool half_filled() const = 0;

 protected:
  ~HalfFilled() = default;
};

}  // namespace cusp::ui
