#include "ui/render/opengl_allowed.h"

#include <atomic>

namespace cusp::ui {
namespace {

std::atomic<bool> g_forbidden{false};

}  // namespace

void forbid_opengl() noexcept { g_forbidden = true; }
bool opengl_allowed() noexcept { return !g_forbidden; }

}  // namespace cusp::ui
