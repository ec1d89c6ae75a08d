#pragma once
/// \file
/// What a problem file may say, as a JSON Schema that editors check and complete TOML files with.

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace mechwright {

/// Made from the lists that the reader uses (keys.h) and from the mechanisms. `methods` are the names that
/// [solver] method can have. Nothing that the reader accepts is refused.
nlohmann::ordered_json problem_schema(const std::vector<std::string_view>& methods);

}  // namespace mechwright
