// class EnvWorlds: the plans come as lists of dictionaries whose ids are resolved.
#include "python/bindings/convert.hpp"
#include "python/bindings/env_worlds.hpp"
#include "python/bindings/ids.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/world_box.hpp"

namespace tumble::python {

namespace {

using Floats = py::array_t<float, py::array::c_style>;
using Flags = py::array_t<std::uint8_t, py::array::c_style>;
using Labels = py::array_t<std::uint16_t, py::array::c_style>;
using Counts = py::array_t<std::int64_t, py::array::c_style>;
using Rewards = py::array_t<double, py::array::c_style>;

// A member of a dictionary, or its default.
template <class T>
T get(const py::dict& dict, const char* name, T fallback) {
    return dict.contains(name) ? dict[name].cast<T>() : fallback;
}

template <class IdType>
IdType id_in(const py::dict& dict, const char* name) {
    return dict.contains(name) ? to_id<IdType>(dict[name].cast<std::uint64_t>()) : IdType{};
}

template <class Entry, class Read>
void read_all(const py::dict& declared, const char* name, std::vector<Entry>& entries, Read&& read) {
    for (const py::handle entry : declared[name].cast<py::list>()) entries.push_back(read(entry.cast<py::dict>()));
}

ActionPlan to_action(const py::dict& dict) {
    return {static_cast<ActionKind>(get(dict, "kind", 0)),
            id_in<BodyId>(dict, "body"),
            id_in<JointId>(dict, "joint"),
            to_vec2(get(dict, "axis", Pair{})),
            to_vec2(get(dict, "point", Pair{})),
            get(dict, "speed", 0.0f),
            get(dict, "low", 0.0f),
            get(dict, "high", 0.0f),
            get(dict, "pointer", std::string())};
}

ObservedPlan to_observed(const py::dict& dict) {
    return {static_cast<ObservedKind>(get(dict, "kind", 0)),
            id_in<BodyId>(dict, "body"),
            id_in<BodyId>(dict, "other"),
            id_in<JointId>(dict, "joint"),
            to_vec2(get(dict, "axis", Pair{})),
            to_vec2(get(dict, "point", Pair{})),
            get(dict, "turns", false),
            get(dict, "mask", ~std::uint64_t{0}),
            get(dict, "offset", 0.0f),
            get(dict, "scale", 1.0f),
            get(dict, "expression", std::string()),
            get(dict, "pointer", std::string())};
}

RandomPlan to_random(const py::dict& dict) {
    return {static_cast<RandomKind>(get(dict, "kind", 0)), id_in<BodyId>(dict, "body"), get(dict, "low", 0.0f),
            get(dict, "high", 0.0f)};
}

ImagePlan to_image(const py::dict& dict) {
    ImagePlan plan{get(dict, "is_mask", false),       get(dict, "columns", 0), get(dict, "rows", 0), {}, {},
                   get(dict, "follow", std::string())};
    if (dict.contains("center")) plan.center = to_dvec2(dict["center"].cast<Pair>());
    if (dict.contains("height")) plan.height = dict["height"].cast<double>();
    return plan;
}

EnvPlan to_plan(const py::dict& declared) {
    EnvPlan plan;
    read_all(declared, "actions", plan.actions, to_action);
    read_all(declared, "observations", plan.observations, to_observed);
    read_all(declared, "images", plan.images, to_image);
    read_all(declared, "randoms", plan.randoms, to_random);
    plan.choices = get(declared, "choices", plan.choices);
    plan.observation_names = get(declared, "observation_names", plan.observation_names);
    plan.action_names = get(declared, "action_names", plan.action_names);
    plan.reward = get(declared, "reward", plan.reward);
    plan.done = get(declared, "done", plan.done);
    plan.frame_skip = get(declared, "frame_skip", plan.frame_skip);
    plan.steps = get(declared, "steps", plan.steps);
    plan.text = get(declared, "text", plan.text);
    plan.file = get(declared, "file", plan.file);
    return plan;
}

void require_size(const py::array& array, std::size_t size, const char* name) {
    if (static_cast<std::size_t>(array.size()) != size)
        throw std::invalid_argument(std::string(name) + " needs " + std::to_string(size) + " entries, got " +
                                    std::to_string(array.size()));
}

// Keeps two threads from entering one batch.
struct Batch {
    EnvWorlds worlds;
    std::atomic<bool> is_busy = false;

    template <class Call>
    void exclusively(Call&& call) {
        if (is_busy.exchange(true)) throw InUse("another thread is stepping these worlds");
        const py::gil_scoped_release release;
        try {
            call(worlds);
        } catch (...) {
            is_busy = false;
            throw;
        }
        is_busy = false;
    }
};

template <class T>
std::span<T> writable(py::array_t<T, py::array::c_style>& array) {
    return {array.mutable_data(), static_cast<std::size_t>(array.size())};
}
template <class T>
std::span<const T> readable(const py::array_t<T, py::array::c_style>& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

EnvArrays to_arrays(const EnvWorlds& worlds, const Floats& actions, const Counts& choices, Floats& observations,
                    Floats& final_observations, Rewards& rewards, Flags& terminated, Flags& truncated, Counts& steps) {
    const std::size_t n = worlds.count(), seen = worlds.plan().observations.size();
    EnvArrays arrays;
    const bool chooses = !worlds.plan().choices.empty();
    require_size(actions, chooses ? 0 : n * worlds.plan().actions.size(), "actions");
    require_size(choices, chooses ? n : 0, "choices");
    arrays.actions = readable(actions);
    arrays.choices = readable(choices);
    require_size(observations, n * seen, "observations");
    require_size(final_observations, n * seen, "final_observations");
    require_size(rewards, n, "rewards");
    require_size(terminated, n, "terminated");
    require_size(truncated, n, "truncated");
    require_size(steps, n, "steps");
    arrays.observations = writable(observations);
    arrays.final_observations = writable(final_observations);
    arrays.rewards = writable(rewards);
    arrays.terminated = writable(terminated);
    arrays.truncated = writable(truncated);
    arrays.steps = writable(steps);
    return arrays;
}

// The arrays of the images, in their order.
std::vector<ImageArray> to_images(const EnvWorlds& worlds, const py::list& list) {
    const EnvImages& images = worlds.images();
    if (list.size() != images.count()) throw std::invalid_argument("images need an array each");
    std::vector<ImageArray> arrays;
    for (std::size_t i = 0; i < images.count(); ++i) {
        const py::object array = list[i];
        require_size(array.cast<py::array>(), worlds.count() * images.size(i), "an image");
        if (images.is_mask(i)) {
            auto labels = array.cast<Labels>();
            arrays.push_back({{}, writable(labels)});
        } else {
            auto pixels = array.cast<Flags>();
            arrays.push_back({writable(pixels), {}});
        }
    }
    return arrays;
}

}  // namespace

void add_env(py::module_& module) {
    py::class_<Batch>(module, "EnvWorlds")
        .def(
            py::init([](WorldBox& start, const py::dict& declared, std::size_t count, int threads, std::uint64_t seed) {
                return new Batch{EnvWorlds(start.run().scene, to_plan(declared), count, threads, seed)};
            }))
        .def("seed", [](Batch& batch, std::uint64_t seed) { batch.exclusively([&](EnvWorlds& w) { w.seed(seed); }); })
        .def("step",
             [](Batch& batch, const Floats& actions, const Counts& choices, Floats observations,
                Floats final_observations, const py::list& images, const py::list& final_images, Rewards rewards,
                Flags terminated, Flags truncated, Counts steps) {
                 EnvArrays arrays = to_arrays(batch.worlds, actions, choices, observations, final_observations, rewards,
                                              terminated, truncated, steps);
                 arrays.images = to_images(batch.worlds, images);
                 arrays.final_images = to_images(batch.worlds, final_images);
                 batch.exclusively([&](EnvWorlds& worlds) { worlds.step(arrays); });
             })
        .def("reset",
             [](Batch& batch, Floats observations, const py::list& images) {
                 require_size(observations, batch.worlds.count() * batch.worlds.plan().observations.size(),
                              "observations");
                 const auto out = writable(observations);
                 const std::vector<ImageArray> arrays = to_images(batch.worlds, images);
                 batch.exclusively([&](EnvWorlds& worlds) { worlds.reset(out, arrays); });
             })
        .def("save",
             [](Batch& batch, std::size_t index) {
                 std::vector<std::byte> bytes;
                 batch.exclusively([&](EnvWorlds& worlds) { bytes = worlds.world(index).save(); });
                 return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
             })
        .def("state_hash", [](Batch& batch, std::size_t index) {
            std::uint64_t hash = 0;
            batch.exclusively([&](EnvWorlds& worlds) { hash = worlds.world(index).state_hash(); });
            return hash;
        });
}

}  // namespace tumble::python
