/// Codes of every room, put into words. The rooms below ui have codes only; whoever shows one to a person comes here.
/// Needs no window. Here: people, goes, devices and tissues; with it come the words of failures and of grades.
#pragma once

#include <QString>
#include <string>

#include "engine/volume/tissue.h"
#include "scenarios/format/scenario.h"
#include "storage/repositories/sessions.h"
#include "storage/base/rights.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"
#include "ui/text/grade_text.h"

namespace cusp::ui {

/// Text in the installed language, English where there is none.
QString local(const LocalText& text);

QString role_name(Role role);
QString state_name(SessionState state);
QString kind_name(SessionKind kind);
QString device_name(const std::string& device_class);
QString tissue_name(Tissue tissue);

}  // namespace cusp::ui
