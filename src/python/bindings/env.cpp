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

// A member of a dictionary, or its default.
template <class T>
T get(const py::dict& dict, const char* name, T fallback) {
    return dict.contains(name) ? dict[name].cast<T>() : fallback;
}

template <class IdType>
IdType id_in(const py::dict& dict, const char* name) {
    return dict.contains(name) ? to_id<IdType>(dict[name].cast<std::uint64_t>()) : IdType{};
}

EnvPlan to_plan(const py::list& actions, const py::list& observations, const py::list& randoms, int frame_skip) {
    EnvPlan plan;
    plan.frame_skip = frame_skip;
    for (const py::handle entry : actions) {
        const auto dict = entry.cast<py::dict>();
        plan.actions.push_back({static_cast<ActionKind>(get(dict, "kind", 0)), id_in<BodyId>(dict, "body"),
                                id_in<JointId>(dict, "joint"), to_vec2(get(dict, "axis", Pair{})),
                                to_vec2(get(dict, "point", Pair{})), get(dict, "speed", 0.0f), get(dict, "low", 0.0f),
                                get(dict, "high", 0.0f)});
    }
    for (const py::handle entry : observations) {
        const auto dict = entry.cast<py::dict>();
        plan.observations.push_back({static_cast<ObservedKind>(get(dict, "kind", 0)), id_in<BodyId>(dict, "body"),
                                     id_in<BodyId>(dict, "other"), id_in<JointId>(dict, "joint"),
                                     to_vec2(get(dict, "axis", Pair{})), to_vec2(get(dict, "point", Pair{})),
                                     get(dict, "turns", false), get(dict, "offset", 0.0f), get(dict, "scale", 1.0f)});
    }
    for (const py::handle entry : randoms) {
        const auto dict = entry.cast<py::dict>();
        plan.randoms.push_back({static_cast<RandomKind>(get(dict, "kind", 0)), id_in<BodyId>(dict, "body"),
                                get(dict, "low", 0.0f), get(dict, "high", 0.0f)});
    }
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
        if (is_busy.exchange(true)) throw std::runtime_error("another thread is stepping these worlds");
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

}  // namespace

void add_env(py::module_& module) {
    py::class_<Batch>(module, "EnvWorlds")
        .def(py::init([](const WorldBox& start, const py::list& actions, const py::list& observations,
                         const py::list& randoms, int frame_skip, std::size_t count, int threads, std::uint64_t seed) {
            return new Batch{EnvWorlds(start.world().save(), to_plan(actions, observations, randoms, frame_skip), count,
                                       threads, seed)};
        }))
        .def("seed", [](Batch& batch, std::uint64_t seed) { batch.exclusively([&](EnvWorlds& w) { w.seed(seed); }); })
        .def("step",
             [](Batch& batch, const Floats& actions, Floats observations, Flags failed) {
                 const EnvPlan& plan = batch.worlds.plan();
                 require_size(actions, batch.worlds.count() * plan.actions.size(), "actions");
                 require_size(observations, batch.worlds.count() * plan.observations.size(), "observations");
                 require_size(failed, batch.worlds.count(), "failed");
                 const auto in = readable(actions);
                 const auto out = writable(observations);
                 const auto flags = writable(failed);
                 batch.exclusively([&](EnvWorlds& worlds) { worlds.step(in, out, flags); });
             })
        .def("reset",
             [](Batch& batch, const Flags& mask, Floats observations) {
                 require_size(mask, batch.worlds.count(), "mask");
                 require_size(observations, batch.worlds.count() * batch.worlds.plan().observations.size(),
                              "observations");
                 const auto in = readable(mask);
                 const auto out = writable(observations);
                 batch.exclusively([&](EnvWorlds& worlds) { worlds.reset(in, out); });
             })
        .def("save",
             [](Batch& batch, std::size_t index) {
                 const std::vector<std::byte> bytes = batch.worlds.world(index).save();
                 return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
             })
        .def("state_hash", [](Batch& batch, std::size_t index) { return batch.worlds.world(index).state_hash(); });
}

}  // namespace tumble::python
