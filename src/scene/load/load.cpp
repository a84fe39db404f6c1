// The public functions that load and save scenes.
#include "scene/format/reader.hpp"
#include "scene/json/input.hpp"
#include "scene/lint/lint.hpp"
#include "scene/load/reading.hpp"
#include "tumble/file.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

namespace {

std::string read_scene_file(const std::filesystem::path& file) { return read_file(file, scene::kMaxFileBytes); }

template <class T>
void cut(std::vector<T>& list, std::size_t size) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(size), list.end());
}

// Removes the entries of included files.
void keep_own(Scene& scene, const scene::SceneSizes& own) {
    cut(scene.materials, own.materials);
    cut(scene.bodies, own.bodies);
    cut(scene.joints, own.joints);
    cut(scene.timeline, own.timeline);
    cut(scene.expect, own.expect);
    std::erase_if(scene.draws, [](const SceneDraw& draw) { return draw.pointer.empty(); });
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& file_name, const LoadOptions& options,
                  std::vector<Diagnostic>* warnings) {
    text = scene::without_byte_order_mark(text);
    scene::Diagnostics diagnostics(file_name, text);
    auto [result, own, resolved] = scene::Reading(options).read(text, file_name, options, diagnostics);
    std::vector<SceneInclude> include = std::exchange(result.include, {});
    if (options.lint && !diagnostics.has_errors()) scene::add_lints(result, resolved.value(), diagnostics);
    diagnostics.finish(warnings);
    if (!options.keep_includes) return std::move(result);
    keep_own(result, own);
    result.include = std::move(include);
    return std::move(result);
}

Scene parse_scene(std::string_view text, const std::string& file_name, std::vector<Diagnostic>* warnings) {
    return parse_scene(text, file_name, LoadOptions{}, warnings);
}

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, std::vector<Diagnostic>* warnings) {
    LoadOptions from_file = options;
    if (!from_file.read_included) from_file.read_included = read_scene_file;
    return parse_scene(from_file.read_included(file), file.string(), from_file, warnings);
}

Scene load_scene(const std::filesystem::path& file, std::vector<Diagnostic>* warnings) {
    return load_scene(file, LoadOptions{}, warnings);
}

void refuse_value(std::string_view text, const std::string& file_name, const std::string& pointer,
                  const ValueProblem& problem) {
    using scene::Diagnostics;
    Diagnostics diagnostics(file_name, scene::without_byte_order_mark(text));
    if (problem.inside)
        diagnostics.error_in_text(pointer, *problem.inside, problem.message, problem.hint);
    else
        diagnostics.error(pointer, problem.message, problem.hint,
                          problem.at_key ? Diagnostics::At::key : Diagnostics::At::value);
    diagnostics.finish(nullptr);
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
            if (!diagnostics.has_errors()) shapes = make_exact_shapes(geometry);
        } catch (const std::invalid_argument& cause) {
            diagnostics.error("", cause.what());
        }
    }
    diagnostics.finish(nullptr);
    return shapes;
}

}  // namespace tumble
