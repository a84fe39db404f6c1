// Changes one value in the text of a scene file.
#include <stdexcept>
#include <string>

#include "scene/json/input.hpp"
#include "scene/json/json_text.hpp"
#include "scene/json/locate.hpp"
#include "tumble/scene_file.hpp"

namespace tumble {

std::string replace_text(std::string_view scene_text, const std::string& pointer, std::string_view text) {
    const std::string_view json = scene::without_byte_order_mark(scene_text);
    const std::size_t start = scene_text.size() - json.size() + scene::find_offset(json, pointer, false);
    if (start >= scene_text.size() || scene_text[start] != '"')
        throw std::invalid_argument("there is no text at " + pointer);
    std::size_t end = start + 1;
    while (end < scene_text.size() && scene_text[end] != '"') end += scene_text[end] == '\\' ? 2 : 1;
    if (end >= scene_text.size()) throw std::invalid_argument("the text at " + pointer + " does not end");
    return std::string(scene_text.substr(0, start)) + scene::quoted(std::string(text)) +
           std::string(scene_text.substr(end + 1));
}

}  // namespace tumble
