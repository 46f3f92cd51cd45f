/// What assistive technology sees where Qt's own (6.4) falls short.
/// - The main window and areas that scroll read past the end of their list of parts when one goes between the question how
///   many there are and the question for the last one: a scroll bar that hides while a screen reader looks round would end
///   the program.
/// - A button that stays down, and a radio button, is only set down, as if nobody had pressed it: nothing that listens for a
///   press happens. One with a menu waits in it before it answers, and the screen reader with it.
/// - A button that is painted by hand is a widget without a name for what it does: it cannot be pressed at all.
#pragma once

namespace cusp::ui {

/// Call once, after the application object and before the first window.
void install_accessible_parts();

}  // namespace cusp::ui
