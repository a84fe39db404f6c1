// The JSON value that scenes are read from and written to. Objects keep the order of their keys.
#pragma once

#include <nlohmann/json.hpp>

namespace tumble::scene {

using Json = nlohmann::ordered_json;

}  // namespace tumble::scene
