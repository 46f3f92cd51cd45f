// Publishing a model's draft as the editor's page does, on the test's own thread.
#pragma once

#include "tests/modules.h"
#include "ui/editor/editor_records.h"

namespace cusp::test {

inline Stored<ScenarioVersion> publish_draft(Store& store, const Actor& actor, EditorModel& model, std::optional<std::string>& kept) {
  const auto what = publication_of(model, kept);
  if (!what) return std::unexpected(what.error());
  const auto done = publish(store, actor, *what);
  if (!done) return std::unexpected(done.error());
  kept.reset();
  model.now_published(done->scenario);
  return done->version;
}

}  // namespace cusp::test
