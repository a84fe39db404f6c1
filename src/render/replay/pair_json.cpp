#include "render/replay/pair_json.hpp"

#include <nlohmann/json.hpp>

#include "render/replay/header_json.hpp"

namespace tumble::render {

namespace {

nlohmann::ordered_json sequence(const std::vector<double>& values) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const double value : values) list.push_back(brief(value));  // dumped as null if it is not finite
    return list;
}

}  // namespace

nlohmann::ordered_json pair_json(const ReplayPair& pair) {
    nlohmann::ordered_json json{{"title", pair.title}, {"names", {pair.name_a, pair.name_b}}, {"first", nullptr}};
    if (pair.first_difference) json["first"] = *pair.first_difference;
    json["distances"] = sequence(pair.distances);
    json["energies"] = {sequence(pair.energies_a), sequence(pair.energies_b)};
    return json;
}

}  // namespace tumble::render
