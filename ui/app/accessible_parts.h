/// What assistive technology sees of the main window and of areas that scroll. In place of Qt's own, which (6.4) read past
/// the end of their list of parts when one goes between the question how many there are and the question for the last
/// one: a scroll bar that hides while a screen reader looks around would end the program.
#pragma once

namespace cusp {

/// Call once, after the application object and before the first window.
void install_accessible_parts();

}  // namespace cusp
