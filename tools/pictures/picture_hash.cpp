#include "tools/pictures/picture_hash.hpp"

#ifndef __clang_analyzer__  // it assumes null pointers that a string of some size does not have
#define XXH_INLINE_ALL
#endif
#include <xxhash.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "tools/output/json_writer.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

std::uint64_t hash_of(std::string_view text) { return XXH64(text.data(), text.size(), 0); }

std::uint64_t hash_of(const Image& image) {
    return XXH64(image.rgba.data(), image.rgba.size(), static_cast<std::uint64_t>(image.width));
}

// The hashes of the pixels of image files, each of which is read once.
class FileHashes {
public:
    // "missing" for a file that does not exist: frames show an outline instead.
    const std::string& of(const fs::path& file) {
        const auto [entry, is_new] = known_.try_emplace(file, "missing");
        if (is_new && is_file_there(file)) entry->second = to_hex(hash_of(read_picture(file)));
        return entry->second;
    }

private:
    std::map<fs::path, std::string> known_;
};

// The scene without what no frame depends on.
Scene drawn_part(Scene scene) {
    leave_out_remarks(scene);
    scene.world.duration = SceneSettings{}.duration;
    return scene;
}

void add_images(JsonWriter& json, FileHashes& hashes, const SceneBody& body) {
    for (const SceneImage& image : body.images) json.value(hashes.of(image.path));
}

}  // namespace

std::uint64_t picture_hash(const Scene& scene, const Camera& start) {
    FileHashes hashes;
    JsonWriter json(JsonWriter::Layout::compact);
    json.open_array().value(to_json(drawn_part(scene)));
    json.value(start.center).value(start.height).value(start.offset).value(start.follows.index);
    for (const SceneBody& body : scene.bodies) add_images(json, hashes, body);
    for (const SceneEvent& event : scene.timeline)
        if (event.spawn) add_images(json, hashes, *event.spawn);
    return hash_of(json.close_array().text());
}

}  // namespace tumble::tools
