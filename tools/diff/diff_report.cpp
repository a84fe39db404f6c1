#include "tools/diff/diff_report.hpp"

#include <algorithm>

#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"

namespace tumble::tools {

namespace {

constexpr std::uint64_t kMostUlps = 1000000;  // larger counts are left out of the text
constexpr std::size_t kMostNames = 10;        // in a line of the text; JSON lists all

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

void write_first(JsonWriter& json, const StateDifference& first) {
    json.key("first").open_object().member("step", first.step).member("time", first.time).member("body", first.body);
    if (first.body_b != first.body) json.member("body_b", first.body_b);
    if (!first.what.empty()) {
        json.member("what", first.what);
    } else {
        json.member("component", kComponents[first.component]).member("a", first.a).member("b", first.b);
        json.member("apart", difference_of(first.component, first.a, first.b)).member("ulps", ulps_of(first));
        json.member("differing_bodies", first.differing_bodies);
        json.member("contacts_a", first.contacts_a).member("contacts_b", first.contacts_b);
    }
    json.close_object();
}

void append_names(std::string& text, const char* what, const std::vector<std::string>& names) {
    if (names.empty()) return;
    text += what;
    for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i)
        text += (i == 0 ? " '" : ", '") + names[i] + "'";
    if (names.size() > kMostNames) text += " and " + std::to_string(names.size() - kMostNames) + " more";
    text += "\n";
}

// The bodies that are not the same in both runs, a line for each kind.
std::string bodies_text(const Comparison& comparison) {
    std::string text;
    append_names(text, "added, only B has:", comparison.added);
    append_names(text, "removed, only A has:", comparison.removed);
    std::vector<std::string> renamed;
    for (const RenamedBody& body : comparison.renamed) renamed.push_back(body.a + "' to '" + body.b);
    append_names(text, "renamed:", renamed);
    return text;
}

std::string equal_text(const Comparison& comparison, double tolerance) {
    const std::string how = tolerance > 0.0 ? "equal within the tolerance" : "equal bit for bit";
    return how + ": " + counted(comparison.steps, "step") + " of " + counted(comparison.bodies, "body") +
           (comparison.is_equal() ? "\n" : " that both have\n");
}

}  // namespace

std::string to_text(const Comparison& comparison, double tolerance) {
    std::string text = bodies_text(comparison);
    if (!comparison.first) return text + equal_text(comparison, tolerance);
    const StateDifference& first = *comparison.first;
    text += "the first difference is at step " + std::to_string(first.step) + " (";
    append_number(text, first.time);
    text += " s)";
    if (!first.body.empty()) text += ", body '" + first.body + "'";
    if (first.body_b != first.body) text += " ('" + first.body_b + "' in B)";
    if (!first.what.empty()) {
        text += ": " + first.what + "\n";
        append_largest(text, comparison);
        return text;
    }
    text += ", " + std::string(kComponents[first.component]);
    append_value(text += "\n  A ", first.component, first.a);
    append_value(text += "\n  B ", first.component, first.b);
    append_number(text += "\n  apart by ", difference_of(first.component, first.a, first.b));
    text += " " + std::string(kKinds[kKindOf[first.component]].unit);
    if (const std::uint64_t ulps = ulps_of(first); ulps <= kMostUlps) text += ", " + counted(ulps, "ulp");
    text += "; " + std::to_string(first.differing_bodies) + " of " + std::to_string(comparison.bodies) +
            " common bodies differ in this step\n";
    append_largest(text, comparison);
    append_contacts(text, "A", first.contacts_a);
    append_contacts(text, "B", first.contacts_b);
    return text;
}

std::string to_json(const Comparison& comparison) {
    JsonWriter json;
    json.open_object()
        .member("equal", comparison.is_equal())
        .member("equal_steps", comparison.steps)
        .member("bodies", comparison.bodies);
    json.member("added", comparison.added);
    json.member("removed", comparison.removed);
    json.key("renamed").open_array();
    for (const RenamedBody& body : comparison.renamed)
        json.open_object().member("a", body.a).member("b", body.b).close_object();
    json.close_array();
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
