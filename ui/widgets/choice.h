/// A list that folds down: a filter of a page. Thread: GUI.
#pragma once

class QComboBox;
class QString;

namespace cusp::ui {

/// As wide as its widest entry, up to 360 px at 100 %: a longer one is cut in the closed list. Names of exercises here take 345.
/// `name` is the accessible name.
QComboBox* make_choice(const QString& name);

}  // namespace cusp::ui
