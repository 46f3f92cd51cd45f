/// The verbs of `cusp`: the desktop's work without a window (design: "Two programs").
#pragma once

#include <QStringList>
#include <optional>
#include <string_view>

namespace cusp::ui {

/// True when the first argument names a verb, --help or --version: then main() returns run_verb() and opens no window. A name
/// that ends in .cusp or .CUSP is an exercise file, which the window opens.
bool is_verb(int argc, char** argv);

/// Whether the window would need a display and none is named. A platform of Qt that draws without one (vnc, linuxfb, eglfs, offscreen)
/// needs none, named by -platform or by the environment. Then run_verb() refuses what is no verb.
bool no_display(int argc, char** argv);

/// What the window is to open, from its command line: one exercise file at most. Else 2, wrong usage, and one line on stderr.
std::optional<int> refuse_files(const QStringList& files);

/// Runs the verb. 0 done, 1 failed with one line on stderr, 2 wrong usage. Needs no QApplication; `play` makes an
/// offscreen QGuiApplication of its own for the PDF.
int run_verb(int argc, char** argv);

}  // namespace cusp::ui
