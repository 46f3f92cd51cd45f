/// Whether this process may use OpenGL: without it no picture of a tooth is drawn, and everything else works. Any thread.
#pragma once

namespace cusp::ui {

/// For good. Contexts that stand remain.
void forbid_opengl() noexcept;
bool opengl_allowed() noexcept;

}  // namespace cusp::ui
