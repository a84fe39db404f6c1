// Scene texts, and the runs of scenes. A scene is its JSON text here; the package keeps it as Python data.
#include "tumble/scene.hpp"

#include <cmath>

#include "python/bindings/convert.hpp"
#include "python/bindings/errors.hpp"
#include "python/bindings/ids.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/world_box.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/suggest.hpp"

namespace tumble::python {

namespace {

std::shared_ptr<WorldBox> start(Scene&& scene) {
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    return std::make_shared<WorldBox>(WatchedRun{std::move(scene), std::move(run), std::move(watch)});
}

py::bytes to_bytes(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::span<const std::byte> span_of(std::string_view bytes) { return std::as_bytes(std::span(bytes)); }

// Names with the ids of what is alive; of equal names the first.
template <class Instance>
py::dict names_of(const World& world, const std::vector<Instance>& instances) {
    py::dict names;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const std::string name = output_name(instances[i], i);
        if (world.is_valid(instances[i].id) && !names.contains(name)) names[py::str(name)] = to_number(instances[i].id);
    }
    return names;
}

}  // namespace

void add_scene(py::module_& module) {
    module.def("load_scene", [](const std::string& path, const std::vector<std::string>& overrides,
                                std::optional<std::uint64_t> seed, bool allow_outside) {
        LoadOptions options;
        options.overrides = overrides;
        options.seed = seed;
        options.allow_outside = allow_outside;
        return to_json(load_scene(path, options));
    });
    module.def("canonical_text",
               [](const std::string& text, const std::string& name) { return to_json(parse_scene(text, name)); });
    module.def("validate_scene", [](const std::string& text, const std::string& name) {
        LoadOptions options;
        options.lint = true;
        std::vector<Diagnostic> warnings;
        parse_scene(text, name, options, &warnings);
        return to_list(warnings);
    });
    module.def("refuse_value", [](const std::string& text, const std::string& name, const std::string& pointer,
                                  const std::string& message, const std::string& hint, bool at_key) {
        refuse_value(text, name, pointer, {.message = message, .hint = hint, .at_key = at_key});
    });
    module.def("suggestion", [](const std::string& word, const std::vector<std::string>& candidates) {
        return suggestion(word, std::vector<std::string_view>(candidates.begin(), candidates.end()));
    });
    module.def("scene_hash", [](const std::string& text) { return scene_hash(parse_scene(text, "scene")); });
    module.def("scene_schema", scene_schema);
    module.def("count_steps", [](const std::string& text) { return count_steps(parse_scene(text, "scene")); });
    module.def("start",
               [](const std::string& text, const std::string& name) { return start(parse_scene(text, name)); });
    module.def("run_bodies", [](WorldBox& box) { return names_of(box.world(), box.run().run.built().bodies); });
    module.def("run_joints", [](WorldBox& box) { return names_of(box.world(), box.run().run.built().joints); });
    module.def("run_claims", [](WorldBox& box) {
        py::list claims;
        for (const ExpectationResult& result : box.run().watch.results())
            claims.append(py::make_tuple(result.passed && result.is_decided, result.claim, result.finding, result.step,
                                         result.time, result.is_decided));
        return claims;
    });
    module.def("run_value", [](WorldBox& box, const std::string& text) -> py::object {
        const Expression expression(text, box.run().scene);
        const double value = expression.value(box.run().run.built());
        if (expression.kind() == Expression::Kind::number) return py::float_(value);
        return std::isnan(value) ? py::object(py::none()) : py::bool_(value == 1.0);
    });
    module.def("is_stopped", [](WorldBox& box) { return box.run().run.is_stopped(); });
    module.def("save_run", [](WorldBox& box) {
        WatchedRun& run = box.run();
        return py::make_tuple(to_json(run.scene), to_bytes(run.run.save(run.scene)), to_bytes(run.watch.save()));
    });
    module.def("load_run", [](const std::string& text, const py::bytes& run, const py::bytes& watch) {
        Scene scene = parse_scene(text, "scene");
        SceneRun loaded = SceneRun::load(scene, span_of(run));
        ExpectationWatch claims = ExpectationWatch::load(scene, build_world(scene), span_of(watch));
        return std::make_shared<WorldBox>(WatchedRun{std::move(scene), std::move(loaded), std::move(claims)});
    });
}

}  // namespace tumble::python
