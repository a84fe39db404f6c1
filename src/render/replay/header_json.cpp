#include "render/replay/header_json.hpp"

#include <charconv>
#include <cstdio>

namespace tumble::render {

double brief(double number) {
    constexpr int kDigits = 7;
    char text[64];
    const auto [end, unused] = std::to_chars(text, text + sizeof text, number, std::chars_format::general, kDigits);
    double read = 0.0;
    std::from_chars(text, end, read);
    return read;
}

nlohmann::ordered_json numbers(std::span<const DVec2> points) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const DVec2 point : points) {
        list.push_back(point.x);
        list.push_back(point.y);
    }
    return list;
}

std::string to_hex(Color color) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", unsigned{color.r}, unsigned{color.g}, unsigned{color.b});
    return text;
}

}  // namespace tumble::render
