#include "tools/diff/frame_diff.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "tools/diff/input_kind.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

// The largest difference of a channel of the pixel that begins at this byte.
int difference_at(const Image& a, const Image& b, std::size_t byte) {
    int largest = 0;
    for (std::size_t channel = byte; channel < byte + 4; ++channel)
        largest = std::max(largest, std::abs(int{a.rgba[channel]} - int{b.rgba[channel]}));
    return largest;
}

std::string size_text(const Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height) + " pixels";
}

FrameDifference compare(const std::string& name, const Image& a, const Image& b, double tolerance) {
    FrameDifference difference;
    difference.frame = name;
    if (a.width != b.width || a.height != b.height) {
        difference.what = size_text(a) + " in A, " + size_text(b) + " in B";
        return difference;
    }
    const auto width = static_cast<std::size_t>(a.width);
    for (std::size_t pixel = 0; 4 * pixel < a.rgba.size(); ++pixel) {
        const int value = difference_at(a, b, 4 * pixel);
        if (value > tolerance) ++difference.pixels;
        if (value <= difference.largest) continue;
        difference.largest = value;
        difference.x = static_cast<int>(pixel % width);
        difference.y = static_cast<int>(pixel / width);
    }
    return difference;
}

std::vector<std::string> frame_names(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".png") names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

void add_frame(const std::string& name, const Image& a, const Image& b, double tolerance, FrameComparison& comparison) {
    ++comparison.frames;
    const FrameDifference difference = compare(name, a, b, tolerance);
    if (difference.what.empty() && difference.pixels == 0) return;
    ++comparison.differing;
    if (!comparison.first) comparison.first = difference;
    if (difference.pixels == 0 || (comparison.worst && difference.pixels <= comparison.worst->pixels)) return;
    comparison.worst = difference;
    comparison.heat_map = make_heat_map(a, b, tolerance);
}

std::string describe(const FrameDifference& difference) {
    if (!difference.what.empty()) return difference.frame + ": " + difference.what;
    return difference.frame + ": " + counted(difference.pixels, "pixel") + ", by up to " +
           std::to_string(difference.largest) + " of 255, at [" + std::to_string(difference.x) + ", " +
           std::to_string(difference.y) + "]";
}

void write_difference(JsonWriter& json, const char* key, const std::optional<FrameDifference>& difference) {
    if (!difference) return;
    json.key(key).open_object().member("frame", difference->frame);
    if (difference->what.empty())
        json.member("pixels", difference->pixels).member("largest", difference->largest).member("x", difference->x);
    else
        json.member("what", difference->what);
    if (difference->what.empty()) json.member("y", difference->y);
    json.close_object();
}

}  // namespace

Image make_heat_map(const Image& a, const Image& b, double tolerance) {
    Image map = a;
    for (std::size_t byte = 0; byte < map.rgba.size(); byte += 4) {
        const int value = difference_at(a, b, byte);
        std::uint8_t* const pixel = &map.rgba[byte];
        if (value > tolerance) {
            pixel[0] = 255;
            pixel[1] = static_cast<std::uint8_t>(255 - value);
            pixel[2] = 0;
        } else {
            const int grey = (int{a.rgba[byte]} + int{a.rgba[byte + 1]} + int{a.rgba[byte + 2]}) / 12;
            std::fill_n(pixel, 3, static_cast<std::uint8_t>(grey));
        }
        pixel[3] = 255;
    }
    return map;
}

FrameComparison compare_frames(const fs::path& a, const fs::path& b, double tolerance) {
    FrameComparison comparison;
    if (!fs::is_directory(a) || !fs::is_directory(b)) {
        add_frame(a.filename().string(), read_png(a), read_png(b), tolerance, comparison);
        return comparison;
    }
    const fs::path in_a = frames_in(a), in_b = frames_in(b);
    const std::vector<std::string> names_a = frame_names(in_a), names_b = frame_names(in_b);
    std::ranges::set_difference(names_a, names_b, std::back_inserter(comparison.only_a));
    std::ranges::set_difference(names_b, names_a, std::back_inserter(comparison.only_b));
    std::vector<std::string> common;
    std::ranges::set_intersection(names_a, names_b, std::back_inserter(common));
    for (const std::string& name : common)
        add_frame(name, read_png(in_a / name), read_png(in_b / name), tolerance, comparison);
    return comparison;
}

std::string to_text(const FrameComparison& comparison) {
    std::string text;
    for (const auto& [names, run] : {std::pair(&comparison.only_a, "A"), std::pair(&comparison.only_b, "B")})
        if (!names->empty())
            text += "only " + std::string(run) + " has " + names->front() + (names->size() == 1 ? "" : " and ") +
                    (names->size() == 1 ? "" : std::to_string(names->size() - 1) + " more") + "\n";
    if (comparison.differing == 0) return text + "equal: " + counted(comparison.frames, "frame") + "\n";
    text += std::to_string(comparison.differing) + " of " + counted(comparison.frames, "frame") + " differ\n";
    text += "  the first is " + describe(*comparison.first) + "\n";
    if (comparison.worst) text += "  the worst is " + describe(*comparison.worst) + "\n";
    return text;
}

std::string to_json(const FrameComparison& comparison, const fs::path& heat_map) {
    JsonWriter json;
    json.open_object().member("equal", comparison.is_equal()).member("frames", comparison.frames);
    json.member("differing_frames", comparison.differing);
    json.member("only_a", comparison.only_a);
    json.member("only_b", comparison.only_b);
    write_difference(json, "first", comparison.first);
    write_difference(json, "worst", comparison.worst);
    if (!heat_map.empty()) json.member("heat_map", heat_map.string());
    return json.close_object().text() + "\n";
}

}  // namespace tumble::tools
