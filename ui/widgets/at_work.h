/// A page or card with work in the background whose outcome nothing else shows. Thread: GUI.
#pragma once

#include "ui/widgets/ports.h"

namespace cusp::ui {

class AtWork {
 public:
  virtual bool working() const = 0;

 protected:
  ~AtWork() = default;
};

/// Asked before a page at work is left.
Question leave_work_question();

}  // namespace cusp::ui
