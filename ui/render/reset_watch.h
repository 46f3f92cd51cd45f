/// Whether a graphics card has lost an OpenGL context: a reset after a hang, or a card that was taken away.
/// Thread: the one on which the context is current.
#pragma once

namespace cusp::ui {

class ResetWatch {
 public:
  /// Of the current context, which must stand.
  ResetWatch();
  /// True: all that was uploaded is gone, and only another context draws. False where the driver does not report it.
  [[nodiscard]] bool lost() const;

 private:
  enum class Asked { nothing, core, arb };
  Asked asked_ = Asked::nothing;
};

}  // namespace cusp::ui
