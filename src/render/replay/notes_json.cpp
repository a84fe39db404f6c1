#include "render/replay/notes_json.hpp"

#include <nlohmann/json.hpp>

namespace tumble::render {

nlohmann::ordered_json notes_json(std::span<const SceneNote> notes) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SceneNote& note : notes) {
        nlohmann::ordered_json& json = list.emplace_back(nlohmann::ordered_json{{"text", note.text}});
        json["from"] = note.from;
        json["until"] = note.until ? nlohmann::ordered_json(*note.until) : nlohmann::ordered_json();
        if (note.position)
            json["position"] = {note.position->x, note.position->y};
        else
            json["above"] = note.above;
    }
    return list;
}

}  // namespace tumble::render
