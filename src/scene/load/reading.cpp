#include "scene/load/reading.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/build/validate.hpp"
#include "scene/format/fields.hpp"
#include "scene/format/override.hpp"
#include "scene/format/reader.hpp"
#include "scene/format/writer.hpp"
#include "scene/json/input.hpp"
#include "scene/json/json_text.hpp"
#include "scene/json/named_file.hpp"
#include "scene/load/place_part.hpp"
#include "scene/model/geometry.hpp"
#include "tumble/file.hpp"

namespace tumble::scene {

namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

bool are_same(const SceneMaterial& a, const SceneMaterial& b) {
    Scene one, other;
    one.materials = {a};
    other.materials = {b};
    return write_scene(one) == write_scene(other);
}

// Several files may declare a material of one name if it is the same in all of them.
void append_materials(Scene& scene, const std::vector<SceneMaterial>& more) {
    for (const SceneMaterial& material : more) {
        const SceneMaterial* known = find_material(scene, material.name);
        if (known == nullptr)
            scene.materials.push_back(material);
        else if (!are_same(*known, material))
            throw std::invalid_argument("declares the material " + quoted(material.name) +
                                        " with other values than the one that exists");
    }
}

// Calls action(image, pointer) for the images of all bodies, also of those that events spawn.
template <class SomeScene, class Action>
void for_each_image(SomeScene& scene, Action action) {
    const auto visit = [&](auto& body, const std::string& pointer) {
        for (std::size_t i = 0; i < body.images.size(); ++i)
            action(body.images[i], pointer + "/images/" + std::to_string(i));
    };
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) visit(scene.bodies[i], "/bodies/" + std::to_string(i));
    for (std::size_t i = 0; i < scene.timeline.size(); ++i)
        if (scene.timeline[i].spawn) visit(*scene.timeline[i].spawn, "/timeline/" + std::to_string(i) + "/spawn");
}

// The paths of the scene's own entries.
void check_named_files(const Scene& scene, const std::filesystem::path& file, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < scene.include.size(); ++i)
        check_named_file(scene.include[i].file, file, "/include/" + std::to_string(i) + "/file", diagnostics);
    for (std::size_t i = 0; i < scene.expect.size(); ++i) {
        const std::string claim = "/expect/" + std::to_string(i);
        check_named_file(scene.expect[i].picture, file, claim + "/picture", diagnostics);
        check_named_file(scene.expect[i].reference, file, claim + "/reference", diagnostics);
    }
    for_each_image(scene, [&](const SceneImage& image, const std::string& pointer) {
        check_named_file(image.file, file, pointer + "/file", diagnostics);
    });
}

}  // namespace

ReadScene Reading::read(std::string_view text, const std::filesystem::path& file, const LoadOptions& changes,
                        Diagnostics& diagnostics, const Json* parsed) {
    std::optional<Json> value =
        parsed != nullptr ? *parsed : parse_json(text, diagnostics, R"(the smallest scene is {"format": 1})");
    if (!value) return {};
    apply_overrides(changes, *value, diagnostics);
    if (open_.empty()) context_.seed = seed_of(*value);
    ReadScene result{.scene = read_scene(*value, diagnostics, context_)};
    value.reset();
    result.own = sizes_of(result.scene);
    if (read_ && !allow_outside_) check_named_files(result.scene, file, diagnostics);
    if (read_)
        for_each_image(result.scene, [&](SceneImage& image, const std::string&) {
            image.path = (file.parent_path() / image.file).lexically_normal();
        });
    open_.push_back(file.lexically_normal());
    include_all(result.scene, file, diagnostics);
    open_.pop_back();
    // Without the included files, many names of the scene would be unknown.
    if (!diagnostics.has_errors_in("/include")) result.resolved = validate_scene(result.scene, result.own, diagnostics);
    return result;
}

void Reading::include_all(Scene& scene, const std::filesystem::path& file, Diagnostics& diagnostics) {
    IncludedParts included;
    for (std::size_t i = 0; i < scene.include.size(); ++i) {
        const SceneInclude& include = scene.include[i];
        const std::string pointer = "/include/" + std::to_string(i);
        if (diagnostics.has_errors_in(pointer)) continue;
        const std::string outer = context_.part;
        context_.part += include.prefix.empty() ? pointer + "/" : include.prefix;
        const Scene* part = find_part((file.parent_path() / include.file).lexically_normal(), pointer, diagnostics);
        context_.part = outer;
        if (part == nullptr) continue;
        const SceneSizes size = sizes_of(*part);
        entries_ += 1 + size.materials + size.bodies + size.joints + size.timeline + size.expect;
        if (entries_ > kMaxIncludedEntries) {
            diagnostics.error(pointer, "brings the number of included bodies, joints, events and claims to more than " +
                                           std::to_string(kMaxIncludedEntries));
            return;
        }
        Scene placed = *part;
        try {
            place_part(placed, include);
            append_materials(scene, placed.materials);
        } catch (const std::invalid_argument& cause) {
            diagnostics.error(pointer, cause.what());
            continue;
        }
        included.add("/bodies", scene.bodies.size(), pointer, include.file);
        included.add("/joints", scene.joints.size(), pointer, include.file);
        included.add("/timeline", scene.timeline.size(), pointer, include.file);
        included.add("/expect", scene.expect.size(), pointer, include.file);
        append(scene.bodies, placed.bodies);
        append(scene.joints, placed.joints);
        append(scene.timeline, placed.timeline);
        append(scene.expect, placed.expect);
        for (SceneDraw& draw : placed.draws) draw.pointer.clear();
        append(scene.draws, placed.draws);
    }
    diagnostics.set_included(std::move(included));
}

const Scene* Reading::find_part(const std::filesystem::path& file, const std::string& include,
                                Diagnostics& diagnostics) {
    auto part = parts_.find(file);
    // Each place of a file with random numbers has numbers of its own.
    const bool is_reusable = part != parts_.end() && (!part->second || part->second->draws.empty());
    if (!is_reusable) part = parts_.insert_or_assign(file, read_part(file, include, diagnostics)).first;
    return part->second ? &*part->second : nullptr;  // its errors were reported where it was first included
}

std::optional<Scene> Reading::read_part(const std::filesystem::path& file, const std::string& include,
                                        Diagnostics& diagnostics) {
    const auto refuse = [&](const std::string& message, const std::string& hint = "") {
        diagnostics.error(include + "/file", message, hint);
        return std::nullopt;
    };
    if (!read_) return refuse("cannot be included: only scenes that are read from files include others");
    if (std::ranges::find(open_, file) != open_.end()) return refuse("includes itself: " + chain_to(file));
    if (open_.size() > kMaxIncludeDepth)
        return refuse("is included more than " + std::to_string(kMaxIncludeDepth) + " files deep: " + chain_to(file));
    if (++files_read_ > kMaxIncludedFiles)
        return refuse("is one of more than " + std::to_string(kMaxIncludedFiles) + " included files");
    std::string text;
    try {
        text = read_(file);
    } catch (const FileError& error) {
        return refuse(error.what(), "paths are relative to the folder of the including file");
    }
    const std::string_view body = without_byte_order_mark(text);
    Diagnostics own(file.string(), body);
    Scene part = read(body, file, {}, own).scene;
    std::vector<Diagnostic> found;
    bool is_valid = true;
    try {
        own.finish(&found);
    } catch (const SceneError& error) {
        found = error.diagnostics;
        is_valid = false;
    }
    diagnostics.adopt(found, include);
    return is_valid ? std::optional<Scene>(std::move(part)) : std::nullopt;
}

std::string Reading::chain_to(const std::filesystem::path& file) const {
    std::string chain;
    for (const std::filesystem::path& open : open_) chain += open.string() + " > ";
    return chain + file.string();
}

}  // namespace tumble::scene
