#include "scenarios/format/compare.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include <nlohmann/json.hpp>

#include "scenarios/format/write_document.h"

namespace cusp::scenarios {
namespace {

using Json = nlohmann::json;

/// A list of objects and the key that names each of them.
struct NamedList {
  std::string_view path, key;
};
constexpr std::array kNamedLists = {NamedList{"/rubric/criteria", "metric"}, NamedList{"/tissues", "tissue"},
                                    NamedList{"/instruments", "name"}, NamedList{"/template/values", "parameter"}};
constexpr std::array<std::string_view, 4> kWordLists = {"/rubric/critical", "/phenomena", "/specimen/around", "/device/admitted"};
constexpr std::array<std::string_view, 2> kTexts = {"/title", "/briefing"};  // by language
constexpr std::array<std::string_view, 1> kWholes = {"/rubric/criteria/*/bands"};
constexpr std::array<std::string_view, 4> kIdentity = {"id", "version", "key", "format"};

bool is_among(const auto& list, std::string_view wanted) { return std::ranges::find(list, wanted) != list.end(); }

/// One kind of shape on both sides, without parts: its fields can be compared.
bool is_same_shape(const Json& before, const Json& after) {
  return !before.contains("parts") && !after.contains("parts") && before.value("kind", "") == after.value("kind", "") &&
         before.value("shape", "") == after.value("shape", "");
}

class Comparison {
 public:
  std::vector<Change> changes;

  void object(const Json& before, const Json& after, const std::string& path, const std::string& part) {
    std::set<std::string> keys;
    for (const Json* side : {&before, &after})
      for (const auto& item : side->items()) keys.insert(item.key());
    for (const std::string& key : keys) {
      if (path.empty() && is_among(kIdentity, key)) continue;
      const bool text = is_among(kTexts, path);
      const std::string here = path + '/' + (text ? "*" : key), item = text ? key : part;
      if (!before.contains(key)) {
        whole(ChangeKind::added, here, item);
      } else if (!after.contains(key)) {
        whole(ChangeKind::removed, here, item);
      } else {
        value(before[key], after[key], here, item);
      }
    }
  }

 private:
  void whole(ChangeKind kind, const std::string& path, const std::string& part) { changes.push_back({kind, path, part}); }

  void value(const Json& before, const Json& after, const std::string& path, const std::string& part) {
    if (before == after) return;
    if (before.is_number() && after.is_number()) {
      changes.push_back({ChangeKind::changed, path, part, before.get<double>(), after.get<double>()});
    } else if (before.is_object() && after.is_object() && !is_among(kWholes, path) &&
               (path != "/target" || is_same_shape(before, after))) {
      object(before, after, path, part);
    } else if (before.is_array() && after.is_array()) {
      list(before, after, path, part);
    } else {
      whole(ChangeKind::changed, path, part);
    }
  }

  void list(const Json& before, const Json& after, const std::string& path, const std::string& part) {
    const std::size_t known = changes.size();
    const auto* named = std::ranges::find(kNamedLists, std::string_view(path), &NamedList::path);
    if (named != kNamedLists.end()) {
      items(before, after, path, std::string(named->key));
    } else if (is_among(kWordLists, path)) {
      words(before, after, path);
    }
    if (changes.size() == known) whole(ChangeKind::changed, path, part);  // also: another order
  }

  static const Json* item_of(const Json& list, const std::string& key, const Json& name) {
    for (const Json& one : list)
      if (one.at(key) == name) return &one;
    return nullptr;
  }

  void items(const Json& before, const Json& after, const std::string& path, const std::string& key) {
    for (const Json& old : before)
      if (item_of(after, key, old.at(key)) == nullptr) whole(ChangeKind::removed, path + "/*", old.at(key).get<std::string>());
    for (const Json& fresh : after) {
      const auto name = fresh.at(key).get<std::string>();
      if (const Json* old = item_of(before, key, fresh.at(key))) {
        value(*old, fresh, path + "/*", name);
      } else {
        whole(ChangeKind::added, path + "/*", name);
      }
    }
  }

  void words(const Json& before, const Json& after, const std::string& path) {
    for (const Json& old : before)
      if (std::ranges::find(after, old) == after.end()) whole(ChangeKind::removed, path + "/*", old.get<std::string>());
    for (const Json& fresh : after)
      if (std::ranges::find(before, fresh) == before.end()) whole(ChangeKind::added, path + "/*", fresh.get<std::string>());
  }
};

}  // namespace

std::vector<Change> compare(const Scenario& before, const Scenario& after) {
  Comparison comparison;
  comparison.object(document_of(before), document_of(after), {}, {});
  return std::move(comparison.changes);
}

}  // namespace cusp::scenarios
