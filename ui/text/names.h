/// Codes of the modules below as names that people read: roles, states, kinds of session, devices, tissues. Thread: any.
#pragma once

#include <QString>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/volume/tissue.h"
#include "scenarios/format/scenario.h"
#include "storage/repositories/sessions.h"
#include "storage/base/rights.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Text in the language of the exercises, else in the installed one, else in English.
QString local(const LocalText& text);
/// The briefing in that language. A line breaks nowhere between a figure and its unit.
QString briefing_text(const Scenario& scenario);

QString role_name(Role role);
QString state_name(SessionState state);
QString kind_name(SessionKind kind);
QString level_name(Level level);
/// "15 min" of the time that a student needs, whole minutes, at least one.
QString expected_time_text(double seconds);
/// "1:12 min", and from an hour on "1:15:00 h".
QString duration_text(double seconds);
/// "Beginner, 15 min": what an exercise states of both; empty if neither.
QString level_and_time_text(const Scenario& scenario);
/// "Reference operator" of a scripted one, with its fault if it makes one; the key itself of any other.
QString operator_name(const std::string& key);
QString device_name(const std::string& device_class);
/// "Falcon, Inverse3".
QString device_names(const std::vector<std::string>& device_classes);
/// "self-test at most 7 days old".
QString self_test_age(int days);
/// Whether a name stands before another in a list: by the language's alphabet, numbers by their value. "Group 2" before "Group 10".
/// Thread: GUI.
bool stands_before(const std::string& name, const std::string& other);
/// "another tooth for each candidate", of an assignment that draws teeth.
QString drawn_tooth_text();
/// What a student does for a newer self-test of the device, in one sentence.
QString self_test_advice(const std::string& device_class);
QString tissue_name(Tissue tissue);
/// A volume's own names of its tissues, by code (VoxelVolume::names).
using TissueNames = std::map<std::uint8_t, std::string>;
/// As the volume's author named it; a tissue without such a name, or of a grown tooth, as above.
QString tissue_name(Tissue tissue, const TissueNames& own);
/// "gingival floor" of a key of kFaceKeys; "other walls" of a side wall.
QString face_name(std::string_view key);

}  // namespace cusp::ui
