// `tumble diff`: where two runs first differ.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "tools/cli/command.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/validators.hpp"
#include "tools/output/csv_file.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/run/body_states.hpp"
#include "tools/scene/scene_options.hpp"

namespace tumble::tools {

namespace {

struct DiffArguments {
    std::string a, b;
    double tolerance = 0.0;
    LoadOptions changes;  // of B
};

struct Difference {
    std::uint64_t step = 0;
    double time = 0.0;  // s
    std::string what;   // for differences other than of numbers: "B ends before it"
    std::string body;
    std::size_t component = 0;
    double a = 0.0, b = 0.0;
    std::size_t differing_bodies = 0;  // in this step
    std::vector<std::string> contacts_a, contacts_b;
};

// The components by kind: what a tolerance of one number is chosen by.
struct Kind {
    std::string_view name, unit;
};
constexpr std::array<Kind, 4> kKinds{
    {{"position", "m"}, {"angle", "rad"}, {"velocity", "m/s"}, {"angular velocity", "rad/s"}}};
constexpr std::array<std::size_t, kComponents.size()> kKindOf{0, 0, 1, 2, 2, 3};

// How far the runs get apart in one kind of component.
struct Largest {
    double apart = 0.0;
    std::string body;
    std::uint64_t step = 0;
};

struct Comparison {
    std::uint64_t steps = 0;  // that are equal
    std::size_t bodies = 0;   // most in a step
    std::optional<Difference> first;
    std::array<Largest, kKinds.size()> largest;  // over all steps that both have, with the same bodies
};

// The floating-point numbers from one to the other, both zeros being one.
template <class Integer, class Number>
std::uint64_t ulps_between(Number a, Number b) {
    const auto ordered = [](Number value) {
        const auto bits = std::bit_cast<Integer>(value);
        return bits < 0 ? std::numeric_limits<Integer>::min() - bits : bits;
    };
    const Integer x = ordered(a), y = ordered(b);
    return x > y ? static_cast<std::uint64_t>(x) - static_cast<std::uint64_t>(y)
                 : static_cast<std::uint64_t>(y) - static_cast<std::uint64_t>(x);
}

constexpr double kMostTolerance = 1e9;             // m: the farthest place of a scene
constexpr std::uint64_t kCountableUlps = 1000000;  // more tell nobody anything

std::uint64_t ulps(const Difference& difference) {
    if (difference.component < kPreciseComponents) return ulps_between<std::int64_t>(difference.a, difference.b);
    return ulps_between<std::int32_t>(static_cast<float>(difference.a), static_cast<float>(difference.b));
}

// Of angles, the way around that is shorter.
double apart(std::size_t component, double a, double b) {
    const bool is_angle = kKinds[kKindOf[component]].unit == "rad";
    return std::abs(is_angle ? std::remainder(a - b, 2.0 * kPi) : a - b);
}

// The first component that differs by more than the tolerance; NaN differs from all but NaN.
std::optional<std::size_t> first_differing(const NamedState& a, const NamedState& b, double tolerance) {
    for (std::size_t i = 0; i < kComponents.size(); ++i) {
        const double x = a.values[i], y = b.values[i];
        const bool same = x == y || apart(i, x, y) <= tolerance || (std::isnan(x) && std::isnan(y));
        if (!same) return i;
    }
    return std::nullopt;
}

// Bodies stand in the order of their ids in both.
std::optional<Difference> compare_step(const StepStates& a, const StepStates& b, double tolerance) {
    Difference first;
    first.step = a.step;
    first.time = a.time;
    if (a.step != b.step) {
        first.what = "A goes on with step " + std::to_string(a.step) + ", B with step " + std::to_string(b.step);
        return first;
    }
    for (std::size_t i = 0; i < std::max(a.bodies.size(), b.bodies.size()); ++i) {
        const bool in_both = i < a.bodies.size() && i < b.bodies.size() && a.bodies[i].body == b.bodies[i].body;
        if (!in_both) {
            if (first.differing_bodies > 0) break;
            first.body = i < a.bodies.size() ? a.bodies[i].body : b.bodies[i].body;
            first.what =
                std::string("the body is in ") + (i < a.bodies.size() ? "A" : "B") + " only, or in another place";
            return first;
        }
        const std::optional<std::size_t> component = first_differing(a.bodies[i], b.bodies[i], tolerance);
        if (!component) continue;
        if (first.differing_bodies++ > 0) continue;
        first.body = a.bodies[i].body;
        first.component = *component;
        first.a = a.bodies[i].values[*component];
        first.b = b.bodies[i].values[*component];
    }
    if (first.differing_bodies == 0) return std::nullopt;
    return first;
}

void update_largest(std::array<Largest, kKinds.size()>& largest, const StepStates& a, const StepStates& b) {
    for (std::size_t i = 0; i < std::min(a.bodies.size(), b.bodies.size()); ++i)
        for (std::size_t component = 0; component < kComponents.size(); ++component) {
            const double distance = apart(component, a.bodies[i].values[component], b.bodies[i].values[component]);
            Largest& so_far = largest[kKindOf[component]];
            if (distance > so_far.apart) so_far = {distance, a.bodies[i].body, a.step};
        }
}

// The first difference, and from there on how far the runs get apart.
Comparison compare(const DiffArguments& options) {
    const std::unique_ptr<StateSource> source_a = open_states(options.a),
                                       source_b = open_states(options.b, options.changes);
    Comparison comparison;
    StepStates a, b;
    for (;;) {
        const bool more_a = source_a->next(a), more_b = source_b->next(b);
        if (!more_a && !more_b) return comparison;
        if (more_a != more_b) {
            if (comparison.first) return comparison;
            const StepStates& longer = more_a ? a : b;
            comparison.first.emplace();
            comparison.first->step = longer.step;
            comparison.first->time = longer.time;
            comparison.first->what = std::string(more_a ? "B" : "A") + " ends before it";
            return comparison;
        }
        comparison.bodies = std::max(comparison.bodies, a.bodies.size());
        const std::optional<Difference> difference = compare_step(a, b, options.tolerance);
        if (!difference && !comparison.first) ++comparison.steps;
        if (difference && !comparison.first) {
            comparison.first = difference;
            comparison.first->contacts_a = source_a->contacts_of(difference->body);
            comparison.first->contacts_b = source_b->contacts_of(difference->body);
        }
        if (difference && !difference->what.empty()) return comparison;
        update_largest(comparison.largest, a, b);
    }
}

// Two files of hashes, as `run --hashes` writes them.
bool is_hash_file(const std::string& file) {
    std::ifstream stream(file);
    std::string header;
    return std::getline(stream, header) && header.starts_with("step,hash");
}

// Where two hash files first differ; it says as much as hashes can.
ExitCode compare_hashes(const Command& command, const DiffArguments& options) {
    CsvFile<2> file_a(options.a, "step", "hash"), file_b(options.b, "step", "hash");
    std::array<char*, 2> a{}, b{};
    std::uint64_t steps = 0;
    bool more_a = file_a.read(a), more_b = file_b.read(b);
    for (; more_a && more_b && std::string_view(a[0]) == b[0] && std::string_view(a[1]) == b[1]; ++steps) {
        more_a = file_a.read(a);
        more_b = file_b.read(b);
    }
    const bool equal = !more_a && !more_b;
    const std::string step = equal ? "" : more_a ? a[0] : b[0];
    const std::string hash_a = more_a ? a[1] : "none", hash_b = more_b ? b[1] : "none";
    if (command.json) {
        JsonWriter json;
        json.open_object().member("equal", equal).member("equal_steps", steps);
        if (!equal)
            json.key("first")
                .open_object()
                .member("step", file_a.number<std::uint64_t>(step.c_str()))
                .member("hash_a", hash_a)
                .member("hash_b", hash_b)
                .close_object();
        write_output(json.close_object().text() + "\n");
    } else if (equal) {
        write_output("equal hashes: " + std::to_string(steps) + " steps\n");
    } else {
        write_output("the first difference is at step " + step + ": the hashes are " + hash_a + " and " + hash_b +
                     "\n");
    }
    return equal ? ExitCode::ok : ExitCode::failed;
}

// "at most apart: 0.3 m of position ('ball' at step 200), ...".
void append_largest(std::string& text, const Comparison& comparison) {
    bool is_first = true;
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
        const Largest& largest = comparison.largest[kind];
        if (!(largest.apart > 0.0)) continue;
        append_number(text += is_first ? "  at most apart by " : ", ", static_cast<float>(largest.apart));
        text += " " + std::string(kKinds[kind].unit) + " of " + std::string(kKinds[kind].name) + " ('" + largest.body +
                "' at step " + std::to_string(largest.step) + ")";
        is_first = false;
    }
    if (!is_first) text += "\n";
}

void append_value(std::string& text, std::size_t component, double value) {
    if (component < kDoubleComponents)
        append_number(text, value);
    else
        append_number(text, static_cast<float>(value));
}

void append_contacts(std::string& text, const char* of, const std::vector<std::string>& contacts) {
    for (const std::string& contact : contacts) text += std::string("  contact in ") + of + ": " + contact + "\n";
}

std::string as_text(const Comparison& comparison, double tolerance) {
    if (!comparison.first) {
        const std::string how = tolerance > 0.0 ? "equal within the tolerance" : "equal bit for bit";
        return how + ": " + std::to_string(comparison.steps) + " steps of " + std::to_string(comparison.bodies) +
               " bodies\n";
    }
    const Difference& first = *comparison.first;
    std::string text = "the first difference is at step " + std::to_string(first.step) + " (";
    append_number(text, first.time);
    text += " s)";
    if (!first.body.empty()) text += ", body '" + first.body + "'";
    if (!first.what.empty()) return text + ": " + first.what + "\n";
    text += ", " + std::string(kComponents[first.component]);
    append_value(text += "\n  A ", first.component, first.a);
    append_value(text += "\n  B ", first.component, first.b);
    append_number(text += "\n  apart by ", apart(first.component, first.a, first.b));
    text += " " + std::string(kKinds[kKindOf[first.component]].unit);
    if (ulps(first) <= kCountableUlps)
        text += ", " + std::to_string(ulps(first)) + (ulps(first) == 1 ? " ulp" : " ulps");
    text += "; " + std::to_string(first.differing_bodies) + " of " + std::to_string(comparison.bodies) +
            " bodies differ in this step\n";
    append_largest(text, comparison);
    append_contacts(text, "A", first.contacts_a);
    append_contacts(text, "B", first.contacts_b);
    return text;
}

void write_contacts(JsonWriter& json, const char* key, const std::vector<std::string>& contacts) {
    json.key(key).open_array();
    for (const std::string& contact : contacts) json.value(contact);
    json.close_array();
}

std::string as_json(const Comparison& comparison) {
    JsonWriter json;
    json.open_object()
        .member("equal", !comparison.first)
        .member("equal_steps", comparison.steps)
        .member("bodies", comparison.bodies);
    if (comparison.first) {
        const Difference& first = *comparison.first;
        json.key("first")
            .open_object()
            .member("step", first.step)
            .member("time", first.time)
            .member("body", first.body);
        if (!first.what.empty()) {
            json.member("what", first.what);
        } else {
            json.member("component", kComponents[first.component]).member("a", first.a).member("b", first.b);
            json.member("apart", apart(first.component, first.a, first.b)).member("ulps", ulps(first));
            json.member("differing_bodies", first.differing_bodies);
            write_contacts(json, "contacts_a", first.contacts_a);
            write_contacts(json, "contacts_b", first.contacts_b);
        }
        json.close_object();
        json.key("largest").open_array();
        for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
            const Largest& largest = comparison.largest[kind];
            json.open_object().member("of", kKinds[kind].name).member("apart", largest.apart);
            json.member("body", largest.body).member("step", largest.step).close_object();
        }
        json.close_array();
    }
    return json.close_object().text() + "\n";
}

ExitCode run_diff(const Command& command, const DiffArguments& options) {
    const bool is_changed = !options.changes.overrides.empty() || options.changes.seed;
    if (is_changed && !is_scene_file(options.b))
        throw CLI::ValidationError("--set and --seed", "change a scene, and B is none: " + options.b);
    if (is_hash_file(options.a) && is_hash_file(options.b)) {
        if (options.tolerance > 0.0) report_warning("--tolerance has no effect on hashes");
        return compare_hashes(command, options);
    }
    const Comparison comparison = compare(options);
    write_output(command.json ? as_json(comparison) : as_text(comparison, options.tolerance));
    return comparison.first ? ExitCode::failed : ExitCode::ok;
}

}  // namespace

void add_diff(CLI::App& app, Command& command) {
    const auto options = std::make_shared<DiffArguments>();
    CLI::App& diff = add_subcommand(app, command, "diff", "Say where two runs first differ; exit code 7 if they do");
    diff.add_option(
            "A", options->a,
            "A trajectory (.csv), the folder of a run that holds one, a scene to run, or a list of hashes (.csv)")
        ->required();
    diff.add_option("B", options->b, "Another")->required();
    add_change_options(diff, options->changes, "B, if it is a scene");
    diff.add_option("--tolerance", options->tolerance, "Differences up to this (m, rad, m/s, rad/s) do not count")
        ->capture_default_str()
        ->check(number_from_to(0.0, kMostTolerance));
    diff.callback(
        [&command, options] { command.action = [&command, options] { return run_diff(command, *options); }; });
}

}  // namespace tumble::tools
