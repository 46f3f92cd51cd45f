/// What an instructor is shown before a version is published: what changed, who uses an older version, whether it was tried out.
/// No widget. Thread: GUI.
#pragma once

#include <QStringList>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "storage/store.h"
#include "ui/editor/editor_model.h"
#include "ui/modules.h"

namespace cusp::ui {

/// An assignment that is not over and names a version published before.
struct OlderUse {
  std::string cohort;
  int version = 1;
  SessionKind kind = SessionKind::practice;
  std::optional<std::int64_t> due_utc_us{};
};

struct PublishFacts {
  int number = 1;            // of the version that publishing makes
  std::optional<int> since;  // newest version that is not withdrawn; nullopt: there is none
  bool elsewhere = false;    // another window published `since` after this one was opened
  QStringList changes;       // against `since`
  std::vector<OlderUse> uses;
  bool tried = false;
};

/// `versions`: all of one exercise.
Stored<std::vector<OlderUse>> open_uses(Store& store, const std::vector<ScenarioVersion>& versions, std::int64_t now_utc_us);

Stored<PublishFacts> publish_facts(Store& store, const EditorModel& model, std::int64_t now_utc_us);

}  // namespace cusp::ui
