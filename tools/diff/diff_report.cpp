#include "tools/diff/diff_report.hpp"

#include "tools/output/json_writer.hpp"

namespace tumble::tools {

namespace {

constexpr std::uint64_t kMostUlps = 1000000;  // larger counts are left out of the text

// "  largest difference: 0.3 m in position ('ball' at step 200), ...".
void append_largest(std::string& text, const Comparison& comparison) {
    bool is_first = true;
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
        const LargestDifference& largest = comparison.largest[kind];
        if (!(largest.value > 0.0)) continue;
        append_number(text += is_first ? "  largest difference: " : ", ", static_cast<float>(largest.value));
        text += " " + std::string(kKinds[kind].unit) + " in " + std::string(kKinds[kind].name) + " ('" + largest.body +
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

void append_contacts(std::string& text, const char* run, const std::vector<std::string>& contacts) {
    for (const std::string& contact : contacts) text += std::string("  contact in ") + run + ": " + contact + "\n";
}

void write_contacts(JsonWriter& json, const char* key, const std::vector<std::string>& contacts) {
    json.key(key).open_array();
    for (const std::string& contact : contacts) json.value(contact);
    json.close_array();
}

void write_first(JsonWriter& json, const StateDifference& first) {
    json.key("first").open_object().member("step", first.step).member("time", first.time).member("body", first.body);
    if (!first.what.empty()) {
        json.member("what", first.what);
    } else {
        json.member("component", kComponents[first.component]).member("a", first.a).member("b", first.b);
        json.member("apart", difference_of(first.component, first.a, first.b)).member("ulps", ulps_of(first));
        json.member("differing_bodies", first.differing_bodies);
        write_contacts(json, "contacts_a", first.contacts_a);
        write_contacts(json, "contacts_b", first.contacts_b);
    }
    json.close_object();
}

}  // namespace

std::string to_text(const Comparison& comparison, double tolerance) {
    if (!comparison.first) {
        const std::string how = tolerance > 0.0 ? "equal within the tolerance" : "equal bit for bit";
        return how + ": " + std::to_string(comparison.steps) + " steps of " + std::to_string(comparison.bodies) +
               " bodies\n";
    }
    const StateDifference& first = *comparison.first;
    std::string text = "the first difference is at step " + std::to_string(first.step) + " (";
    append_number(text, first.time);
    text += " s)";
    if (!first.body.empty()) text += ", body '" + first.body + "'";
    if (!first.what.empty()) return text + ": " + first.what + "\n";
    text += ", " + std::string(kComponents[first.component]);
    append_value(text += "\n  A ", first.component, first.a);
    append_value(text += "\n  B ", first.component, first.b);
    append_number(text += "\n  apart by ", difference_of(first.component, first.a, first.b));
    text += " " + std::string(kKinds[kKindOf[first.component]].unit);
    if (const std::uint64_t ulps = ulps_of(first); ulps <= kMostUlps)
        text += ", " + std::to_string(ulps) + (ulps == 1 ? " ulp" : " ulps");
    text += "; " + std::to_string(first.differing_bodies) + " of " + std::to_string(comparison.bodies) +
            " bodies differ in this step\n";
    append_largest(text, comparison);
    append_contacts(text, "A", first.contacts_a);
    append_contacts(text, "B", first.contacts_b);
    return text;
}

std::string to_json(const Comparison& comparison) {
    JsonWriter json;
    json.open_object()
        .member("equal", !comparison.first)
        .member("equal_steps", comparison.steps)
        .member("bodies", comparison.bodies);
    if (comparison.first) {
        write_first(json, *comparison.first);
        json.key("largest").open_array();
        for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
            const LargestDifference& largest = comparison.largest[kind];
            json.open_object().member("of", kKinds[kind].name).member("apart", largest.value);
            json.member("body", largest.body).member("step", largest.step).close_object();
        }
        json.close_array();
    }
    return json.close_object().text() + "\n";
}

}  // namespace tumble::tools
