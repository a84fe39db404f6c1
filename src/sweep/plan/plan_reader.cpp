// A plan from its JSON text. What needs the scenes is in plan_trial.
#ifndef __clang_analyzer__
#define XXH_INLINE_ALL
#endif
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/json/input.hpp"
#include "scene/json/json_text.hpp"
#include "scene/json/named_file.hpp"
#include "sweep/plan/plan.hpp"
#include "sweep/plan/plan_lints.hpp"
#include "sweep/plan/plan_object.hpp"
#include "sweep/plan/plan_trial.hpp"
#include "sweep/plan/sobol.hpp"
#include "sweep/plan/written_reader.hpp"
#include "tumble/file.hpp"

namespace tumble::sweep {

namespace {

using scene::Diagnostics;
using scene::Json;

constexpr double kLongestTimeout = 1e6;  // s

bool is_name(const std::string& text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    return !text.empty() && text.size() <= 64 && is_letter(text[0]) &&
           std::ranges::all_of(text, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

// The columns of the table that every sweep has.
const std::set<std::string> kColumns{"run",    "scene",         "seed",       "outcome",   "steps",
                                     "claims", "failed_claims", "state_hash", "data_hash", "message"};

void read_name(PlanObject& object, std::set<std::string>& names, std::string& name) {
    if (!object.has("name")) return object.error("", "needs the key \"name\", the name of its column in the table");
    name = object.text("name");
    if (!is_name(name))
        object.error("name", "must consist of letters, digits and _, not a digit first, got " + scene::quoted(name));
    else if (kColumns.contains(name))
        object.error("name", "is a column of every table; choose another");
    else if (!names.insert(name).second)
        object.error("name", "occurs twice");
}

void check_whole_range(PlanObject& object, const std::string& key, const Parameter& parameter) {
    const double lower = parameter.lower, upper = parameter.upper, most = static_cast<double>(kMostRuns);
    if (std::floor(lower) != lower || std::floor(upper) != upper || lower < -most || upper > most)
        object.error(key, "must have whole ends of at most 2^53, for \"whole\": true");
    else if (parameter.kind == Parameter::Kind::range && static_cast<double>(parameter.count) > upper - lower + 1.0)
        object.error("count", "is more than there are whole numbers in the range");
}

void read_range(PlanObject& object, const std::string& key, Parameter& parameter) {
    const auto ends = object.pair(key);
    parameter.count = object.whole("count", 1, kMostRuns, 0);
    parameter.whole = object.flag("whole", false);
    if (!ends) return;
    parameter.lower = ends->first;
    parameter.upper = ends->second;
    if (parameter.kind == Parameter::Kind::normal) {
        if (ends->second < 0.0) object.error(key, "must be [mean, deviation] with a deviation of at least 0");
        if (object.has("count") || parameter.whole)
            object.error("", "numbers of a normal distribution have no \"count\" and are not \"whole\"");
        if (!std::isfinite(ends->first + 9.0 * ends->second) || !std::isfinite(ends->first - 9.0 * ends->second))
            object.error(key, "must leave the mean and nine deviations within the numbers of 64 bits");
        return;
    }
    if (!std::isfinite(ends->second - ends->first))
        object.error(key, "is too wide: the difference of its ends must be a number of 64 bits");
    if (parameter.whole) check_whole_range(object, key, parameter);
    if (ends->first > ends->second) object.error(key, "must be [lower, upper] with lower <= upper");
    if (parameter.kind == Parameter::Kind::log_range && ends->first <= 0.0) object.error(key, "must be above 0");
}

Parameter read_parameter(const Json& json, const std::string& pointer, std::set<std::string>& names,
                         Diagnostics& diagnostics) {
    PlanObject object(json, pointer, diagnostics);
    Parameter parameter;
    read_name(object, names, parameter.name);
    parameter.pointers = object.texts("set");
    for (const std::string& target : parameter.pointers)
        if (!target.starts_with('/') || target.find('=') != std::string::npos)
            object.error("set", "must be a JSON pointer, got " + scene::quoted(target), "for example /world/gravity/1");
    using Kind = Parameter::Kind;
    int kinds = 0;
    for (const auto& [key, kind] : {std::pair<const char*, Kind>("list", Kind::list),
                                    {"range", Kind::range},
                                    {"log_range", Kind::log_range},
                                    {"normal", Kind::normal},
                                    {"choice", Kind::choice}}) {
        if (!object.has(key)) continue;
        ++kinds;
        parameter.kind = kind;
        if (kind == Kind::list || kind == Kind::choice)
            parameter.values = object.values(key);
        else
            read_range(object, key, parameter);
    }
    if (kinds != 1) object.error("", "needs one of the keys list, range, log_range, normal, choice");
    object.finish();
    return parameter;
}

template <class Read>
void read_each(PlanObject& plan, const char* key, Diagnostics& diagnostics, Read read) {
    const Json* const list = plan.find(key);
    if (list == nullptr) return;
    if (!list->is_array())
        return diagnostics.error(plan.pointer_to(key), "must be an array, got " + scene::describe(*list),
                                 list->is_object() ? "in brackets, as a list: [{...}]" : "");
    for (std::size_t i = 0; i < list->size(); ++i) read((*list)[i], plan.pointer_to(key) + "/" + std::to_string(i));
}

Measure read_measure(const Json& json, const std::string& pointer, std::set<std::string>& names,
                     Diagnostics& diagnostics) {
    PlanObject object(json, pointer, diagnostics);
    Measure measure;
    if (!json.is_object()) return measure;
    read_name(object, names, measure.name);
    if (!object.has("value")) object.error("", "needs the key \"value\", an expression");
    measure.expression = object.text("value");
    object.finish();
    return measure;
}

Seeds read_seeds(PlanObject& plan, Diagnostics& diagnostics) {
    Seeds seeds;
    const Json* const json = plan.find("seeds");
    if (json == nullptr) return seeds;
    seeds.is_drawn = false;
    if (!json->is_object()) {
        if (json->is_array())
            for (const Json& seed : *json)
                if (seed.is_number_unsigned()) seeds.list.push_back(seed.get<std::uint64_t>());
        if (seeds.list.empty() || seeds.list.size() != json->size())
            plan.error("seeds", "must be an array of whole numbers, or {\"first\": 1, \"count\": 100}");
        return seeds;
    }
    PlanObject object(*json, plan.pointer_to("seeds"), diagnostics);
    seeds.first = object.whole("first", 0, kMostRuns, 1);
    seeds.count = object.whole("count", 1, kMostRuns, 1);
    object.finish();
    return seeds;
}

Filter read_filter(PlanObject& plan, Diagnostics& diagnostics) {
    Filter filter;
    const Json* const json = plan.find("filter");
    if (json == nullptr) return filter;
    PlanObject object(*json, plan.pointer_to("filter"), diagnostics);
    filter.claims = object.flag("claims", false);
    filter.that = object.text("that");
    object.finish();
    return filter;
}

void read_settings(PlanObject& plan, Plan& result) {
    const Json* const json = plan.find("set");
    if (json == nullptr) return;
    if (!json->is_object()) return plan.error("set", "must be an object of JSON pointers and values");
    for (const auto& [pointer, value] : json->items())
        result.settings.push_back(pointer + "=" + scene::compact_text(value));
}

void read_scenes(PlanObject& object, Plan& plan) {
    const std::vector<std::string> scenes = object.texts("scenes");
    const std::string scene = object.text("scene");
    if (scene.empty() == scenes.empty()) {
        const bool is_scene = object.has("bodies") || object.has("world");
        object.error("", "needs one of the keys scene, scenes",
                     is_scene ? R"(this is a scene; a plan names it: {"format": 1, "scene": "FILE", "runs": 10})" : "");
    }
    plan.scenes.assign(scenes.begin(), scenes.end());
    if (!scene.empty()) plan.scenes.emplace_back(scene);
}

// The size of the grid, or an error if it is more than kMostRuns.
void check_grid(const Plan& plan, PlanObject& object) {
    double size = static_cast<double>(plan.scenes.size()) * static_cast<double>(plan.seeds.grid_size());
    unsigned drawn = 0;
    for (const Parameter& parameter : plan.parameters) {
        if (parameter.is_on_grid()) size *= static_cast<double>(parameter.grid_size());
        drawn += parameter.is_on_grid() ? 0 : 1;
    }
    if (size > static_cast<double>(kMostRuns)) object.error("", "the grid has more than 2^53 points");
    if (plan.sampling == Sampling::sobol && drawn > kMostSobolDimensions)
        object.error("sampling", "a Sobol sequence has at most 21 drawn parameters, got " + std::to_string(drawn));
}

Plan read_object(const Json& json, const std::filesystem::path& file, std::uint64_t runs, Diagnostics& diagnostics) {
    PlanObject object(json, "", diagnostics);
    Plan plan;
    plan.file = file;
    object.find("$schema");
    object.whole("format", 1, 1, 1);
    if (!object.has("format")) object.error("", R"(the key "format" is missing)", R"("format": 1)");
    plan.name = object.text("name", file.stem().string());
    plan.description = object.text("description");
    read_scenes(object, plan);
    read_settings(object, plan);
    plan.seed = object.whole("seed", 0, kMostRuns, 1);
    plan.seeds = read_seeds(object, diagnostics);
    const std::string sampling = object.word("sampling", {"random", "latin_hypercube", "sobol"});
    plan.sampling = sampling == "random"  ? Sampling::random
                    : sampling == "sobol" ? Sampling::sobol
                                          : Sampling::latin_hypercube;
    std::set<std::string> names;
    read_each(object, "parameters", diagnostics, [&](const Json& value, const std::string& pointer) {
        plan.parameters.push_back(read_parameter(value, pointer, names, diagnostics));
    });
    read_each(object, "measures", diagnostics, [&](const Json& value, const std::string& pointer) {
        plan.measures.push_back(read_measure(value, pointer, names, diagnostics));
    });
    plan.filter = read_filter(object, diagnostics);
    plan.write = read_written(object, diagnostics);
    plan.shard_runs = object.whole("shard_runs", 1, kMostShardRuns, 0);
    plan.timeout = object.number("timeout", 1e-3, kLongestTimeout, 0.0);
    const std::uint64_t stated = object.whole("runs", 1, kMostRuns, 0);
    check_grid(plan, object);
    object.finish();
    if (diagnostics.has_errors()) return plan;
    plan.states_runs = stated > 0 || runs > 0;
    plan.slices = stated > 0 ? stated : grid_size(plan);
    plan.runs = runs > 0 ? runs : plan.slices;
    return plan;
}

void check_scene_files(const Plan& plan, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < plan.scenes.size(); ++i)
        scene::check_named_file(plan.scenes[i], plan.file, pointer_of_scene(plan, i), diagnostics);
}

}  // namespace

Plan read_plan(const std::filesystem::path& file, std::uint64_t runs, bool allow_outside,
               std::vector<Diagnostic>* warnings) {
    return parse_plan(read_file(file, scene::kMaxFileBytes), file, runs, allow_outside, warnings);
}

Plan parse_plan(std::string text, const std::filesystem::path& file, std::uint64_t runs, bool allow_outside,
                std::vector<Diagnostic>* warnings) {
    const std::string_view body = scene::without_byte_order_mark(text);
    Diagnostics diagnostics(file.string(), body);
    Plan plan;
    if (const auto json = scene::parse_json(body, diagnostics, R"(the smallest plan is {"format": 1, "scene": "F"})")) {
        plan = read_object(*json, file, runs, diagnostics);
        plan.allow_outside = allow_outside;
        if (!allow_outside) check_scene_files(plan, diagnostics);
        if (!diagnostics.has_errors()) {
            const TriedScenes scenes = try_first_runs(plan, diagnostics);
            if (!diagnostics.has_errors()) add_plan_lints(plan, scenes.facts, diagnostics);
            Json of_runs = *json;
            for (const char* const key : {"$schema", "name", "description"}) of_runs.erase(key);
            const std::string all = scene::compact_text(of_runs) + scenes.texts;
            plan.hash = XXH64(all.data(), all.size(), 0);
        }
    }
    diagnostics.finish(warnings);
    plan.text = std::move(text);
    return plan;
}

}  // namespace tumble::sweep
