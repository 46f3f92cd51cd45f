/// Codes of the modules below as names that people read: roles, states, kinds of session, devices, tissues. Thread: any.
#pragma once

#include <QString>
#include <string>

#include "engine/volume/tissue.h"
#include "scenarios/format/scenario.h"
#include "storage/repositories/sessions.h"
#include "storage/base/rights.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Text in the installed language, English where there is none.
QString local(const LocalText& text);

QString role_name(Role role);
QString state_name(SessionState state);
QString kind_name(SessionKind kind);
QString device_name(const std::string& device_class);
QString tissue_name(Tissue tissue);
/// "gingival floor" of a key of kFaceKeys; "other walls" of a side wall.
QString face_name(std::string_view key);

}  // namespace cusp::ui
