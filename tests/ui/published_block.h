/// An exercise on named_block(), among the records.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/library/library.h"
#include "storage/store.h"
#include "tests/modules.h"
#include "tests/ui/named_block.h"
#include "ui/session/file_bytes.h"

namespace cusp::test {

/// A version of channel-1, published by `author`. `folder`: for the volume's file meanwhile.
inline void publish_named_block(Store& store, const Actor& author, const std::filesystem::path& folder) {
  ASSERT_TRUE(write_nrrd(named_block(), folder / "block.nrrd"));
  const auto bytes = bytes_of(folder / "block.nrrd");
  ASSERT_TRUE(bytes);
  const auto hash = store.blobs.put(*bytes);
  ASSERT_TRUE(hash);
  Scenario imported = *load_builtin("channel-1");
  imported.specimen = {};
  imported.specimen.volume = "block.nrrd";
  ASSERT_TRUE(store.scenarios.publish(author, imported, canonical_json(imported), content_hash(imported).bytes, {{"block.nrrd", *hash}}));
}

}  // namespace cusp::test
