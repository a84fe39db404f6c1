// The JSON values of this room: objects keep the order of their file.
#pragma once

#include <nlohmann/json.hpp>

namespace tumble::scene {

using Json = nlohmann::ordered_json;

}  // namespace tumble::scene
