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

// `parsed` is the value of the text, or null if it is not known.
Scene read_whole(std::string_view text, const scene::Json* parsed, const std::string& file_name,
                 const LoadOptions& options, std::vector<Diagnostic>* warnings) {
    text = scene::without_byte_order_mark(text);
    scene::Diagnostics diagnostics(file_name, text);
    auto [result, own, resolved] = scene::Reading(options).read(text, file_name, options, diagnostics, parsed);
    std::vector<SceneInclude> include = std::exchange(result.include, {});
    if (options.lint && !diagnostics.has_errors()) scene::add_lints(result, resolved.value(), diagnostics);
    diagnostics.finish(warnings);
    if (!options.keep_includes) return std::move(result);
    keep_own(result, own);
    result.include = std::move(include);
    return std::move(result);
}

LoadOptions with_reader(LoadOptions options) {
    if (!options.read_included) options.read_included = read_scene_file;
    return options;
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& file_name, const LoadOptions& options,
                  std::vector<Diagnostic>* warnings) {
    return read_whole(text, nullptr, file_name, options, warnings);
}

Scene parse_scene(std::string_view text, const std::string& file_name, std::vector<Diagnostic>* warnings) {
    return parse_scene(text, file_name, LoadOptions{}, warnings);
}

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, std::vector<Diagnostic>* warnings) {
    const LoadOptions from_file = with_reader(options);
    return parse_scene(from_file.read_included(file), file.string(), from_file, warnings);
}

Scene load_scene(const std::filesystem::path& file, std::vector<Diagnostic>* warnings) {
    return load_scene(file, LoadOptions{}, warnings);
}

struct SceneSource::Impl {
    std::string file;
    std::string text;
    std::optional<scene::Json> value;  // nothing for a text with errors, which load() reports
};

SceneSource::SceneSource(const std::filesystem::path& file, const ReadIncluded& read)
    : impl_(new Impl{file.string(), read ? read(file) : read_scene_file(file), std::nullopt}) {
    const std::string_view body = scene::without_byte_order_mark(impl_->text);
    scene::Diagnostics diagnostics(impl_->file, body);
    impl_->value = scene::parse_json(body, diagnostics);
    if (diagnostics.has_errors()) impl_->value.reset();
}

SceneSource::~SceneSource() = default;
SceneSource::SceneSource(SceneSource&&) noexcept = default;
SceneSource& SceneSource::operator=(SceneSource&&) noexcept = default;

Scene SceneSource::load(const LoadOptions& options, std::vector<Diagnostic>* warnings) const {
    return read_whole(impl_->text, impl_->value ? &*impl_->value : nullptr, impl_->file, with_reader(options),
                      warnings);
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
