/// Members of a JSON text of any origin: one that is missing or of another kind is nullopt. Within storage only.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "storage/exchange/signed_text.h"

namespace cusp::storage {

std::optional<std::string> text_at(const nlohmann::json& from, const char* key);
std::optional<std::int64_t> number_at(const nlohmann::json& from, const char* key);
std::optional<Hash256> hash_at(const nlohmann::json& from, const char* key);
std::optional<Uuid> uuid_at(const nlohmann::json& from, const char* key);
std::optional<ChainHead> head_at(const nlohmann::json& from, const char* key);
std::optional<std::vector<PackFile>> files_at(const nlohmann::json& from, const char* key);

nlohmann::ordered_json json_of(const ChainHead& head);
nlohmann::ordered_json json_of(const std::vector<PackFile>& files);

}  // namespace cusp::storage
