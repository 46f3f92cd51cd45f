#include "ui/render/reset_watch.h"

#include <epoxy/gl.h>

namespace cusp::ui {

/// A lost context answers no question about its version and extensions.
ResetWatch::ResetWatch() {
  if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness")) {
    asked_ = Asked::core;
  } else if (epoxy_has_gl_extension("GL_ARB_robustness")) {
    asked_ = Asked::arb;
  }
  static_cast<void>(lost());  // the first call looks the function up
}

bool ResetWatch::lost() const {
  switch (asked_) {
    case Asked::nothing: return false;
    case Asked::core: return glGetGraphicsResetStatus() != GL_NO_ERROR;
    case Asked::arb: return glGetGraphicsResetStatusARB() != GL_NO_ERROR;
  }
  return false;
}

}  // namespace cusp::ui
