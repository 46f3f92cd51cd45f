#include "storage/exchange/json_read.h"

namespace cusp::storage {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

/// nullptr if there is none. Copying a text that nests a hundred thousand deep would overflow the stack.
const json* member_at(const json& from, const char* key) {
  if (!from.is_object()) return nullptr;
  const auto it = from.find(key);
  return it == from.end() ? nullptr : &*it;
}

}  // namespace

std::optional<std::string> text_at(const json& from, const char* key) {
  const json* text = member_at(from, key);
  return text != nullptr && text->is_string() ? std::optional(text->get<std::string>()) : std::nullopt;
}
std::optional<std::int64_t> number_at(const json& from, const char* key) {
  const json* number = member_at(from, key);
  return number != nullptr && number->is_number_integer() ? std::optional(number->get<std::int64_t>()) : std::nullopt;
}
std::optional<Hash256> hash_at(const json& from, const char* key) {
  const auto text = text_at(from, key);
  return text ? hash_from_hex(*text) : std::nullopt;
}
std::optional<Uuid> uuid_at(const json& from, const char* key) {
  const auto text = text_at(from, key);
  return text ? Uuid::parse(*text) : std::nullopt;
}

std::optional<ChainHead> head_at(const json& from, const char* key) {
  const json* head = member_at(from, key);
  if (head == nullptr) return std::nullopt;
  const auto entries = number_at(*head, "entries");
  const auto link = hash_at(*head, "link");
  if (!entries || *entries < 0 || !link) return std::nullopt;
  return ChainHead{static_cast<std::uint64_t>(*entries), *link};
}

std::optional<std::vector<PackFile>> files_at(const json& from, const char* key) {
  const json* files = member_at(from, key);
  if (files == nullptr || !files->is_object()) return std::nullopt;
  std::vector<PackFile> out;
  for (const auto& [name, value] : files->items()) {
    const auto hash = hash_at(*files, name.c_str());
    if (!hash) return std::nullopt;
    out.push_back({name, *hash});
  }
  return out;
}

ordered_json json_of(const ChainHead& head) {
  ordered_json out;
  out["entries"] = head.links;
  out["link"] = hex(head.link);
  return out;
}
ordered_json json_of(const std::vector<PackFile>& files) {
  ordered_json out = ordered_json::object();
  for (const PackFile& file : files) out[file.name] = hex(file.hash);
  return out;
}

}  // namespace cusp::storage
