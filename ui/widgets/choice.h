/// A list that folds down: a filter of a page. Thread: GUI.
#pragma once

class QComboBox;
class QString;

namespace cusp::ui {

/// As wide as its widest entry; `name` is the accessible name.
QComboBox* make_choice(const QString& name);

}  // namespace cusp::ui
