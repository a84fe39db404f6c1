// The way of a scene file: bytes, JSON, overrides, fields, checks across fields. Each stage goes on as far as errors of
// the one before allow, so that a user sees all of them at once.
#include "scene/check.hpp"
#include "scene/input.hpp"
#include "scene/lint.hpp"
#include "scene/override.hpp"
#include "scene/reader.hpp"
#include "scene/writer.hpp"
#include "tumble/file.hpp"
#include "tumble/scene.hpp"

namespace tumble {

Scene parse_scene(std::string_view text, const std::string& file_name, const LoadOptions& options,
                  std::vector<Diagnostic>* warnings) {
    text = scene::without_byte_order_mark(text);
    scene::Diagnostics diagnostics(file_name, text);
    Scene result;
    if (std::optional<scene::Json> value = scene::parse_json(text, diagnostics)) {
        scene::apply_overrides(options, *value, diagnostics);
        result = scene::read_scene(*value, diagnostics);
        scene::check_scene(result, diagnostics);
        if (options.lint && !diagnostics.has_errors()) scene::add_lints(result, diagnostics);
    }
    diagnostics.finish(warnings);
    return result;
}

Scene parse_scene(std::string_view text, const std::string& file_name, std::vector<Diagnostic>* warnings) {
    return parse_scene(text, file_name, LoadOptions{}, warnings);
}

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, std::vector<Diagnostic>* warnings) {
    return parse_scene(read_file(file, scene::kMaxFileBytes), file.string(), options, warnings);
}

Scene load_scene(const std::filesystem::path& file, std::vector<Diagnostic>* warnings) {
    return load_scene(file, LoadOptions{}, warnings);
}

void save_scene(const Scene& scene, const std::filesystem::path& file) {
    OutputFile output(file);
    output.write(to_json(scene));
    output.commit();
}

std::vector<Shape> parse_shapes(std::string_view text, const std::string& source) {
    scene::Diagnostics diagnostics(source, text);
    std::vector<Shape> shapes;
    if (const std::optional<scene::Json> value = scene::parse_json(text, diagnostics)) {
        const ShapeGeometry geometry = scene::read_query_geometry(*value, diagnostics);
        try {
            if (!diagnostics.has_errors()) shapes = make_shapes(geometry);
        } catch (const std::invalid_argument& cause) {
            diagnostics.error("", cause.what());
        }
    }
    diagnostics.finish(nullptr);
    return shapes;
}

}  // namespace tumble
