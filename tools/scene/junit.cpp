#include "tools/scene/junit.hpp"

#include <algorithm>
#include <string_view>

#include "tools/output/json_writer.hpp"
#include "tumble/drawing.hpp"

namespace tumble::tools {

namespace {

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + escape_markup(value) + "\"";
}

std::string number_text(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

// The numbers of cases of a suite or of all suites, and their time.
struct Counts {
    std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
    double seconds = 0.0;

    std::string attributes() const {
        return attribute("tests", std::to_string(tests)) + attribute("failures", std::to_string(failures)) +
               attribute("errors", std::to_string(errors)) + attribute("skipped", std::to_string(skipped)) +
               attribute("time", number_text(seconds));
    }
};

// The scene itself is a case too if it could not be checked, was not, or has no claims.
bool has_own_case(const SceneCheck& check) { return !check.error.empty() || check.expectations.empty(); }

Counts count(const SceneCheck& check) {
    Counts counts;
    counts.tests = check.expectations.size() + (has_own_case(check) ? 1 : 0);
    counts.failures =
        static_cast<std::size_t>(std::ranges::count(check.expectations, false, &ExpectationResult::passed)) +
        (check.failure.empty() ? 0 : 1);
    counts.errors = check.error.empty() ? 0 : 1;
    counts.skipped = check.was_skipped ? 1 : 0;
    counts.seconds = check.seconds;
    return counts;
}

Counts total(const std::vector<SceneCheck>& checks) {
    Counts sum;
    for (const SceneCheck& check : checks) {
        const Counts counts = count(check);
        sum.tests += counts.tests;
        sum.failures += counts.failures;
        sum.errors += counts.errors;
        sum.skipped += counts.skipped;
        sum.seconds += counts.seconds;
    }
    return sum;
}

std::string own_case(const SceneCheck& check, const std::string& class_name) {
    std::string text = "    <testcase" + class_name + attribute("name", "runs");
    text += attribute("time", number_text(check.seconds));
    if (!check.error.empty()) return text + "><error" + attribute("message", check.error) + "/></testcase>\n";
    if (!check.failure.empty()) return text + "><failure" + attribute("message", check.failure) + "/></testcase>\n";
    return text + (check.was_skipped ? "><skipped/></testcase>\n" : "/>\n");
}

std::string junit_suite(const SceneCheck& check) {
    std::string text = "  <testsuite" + attribute("name", check.file) + count(check).attributes() + ">\n";
    const std::string class_name = attribute("classname", check.file);
    if (has_own_case(check)) text += own_case(check, class_name);
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        // The pointer distinguishes claims of the same text: viewers merge cases with equal names.
        text += "    <testcase" + class_name + attribute("name", pointer_of_claim(i) + ": " + result.claim);
        // Viewers add up the times of the cases: one of them has that of the whole scene.
        text += attribute("time", number_text(i == 0 && !has_own_case(check) ? check.seconds : 0.0));
        if (result.passed) {
            text += "/>\n";
            continue;
        }
        text += "><failure" + attribute("message", moment_text(result) + ": " + result.finding) + "/>";
        if (!check.shots.empty() && !check.shots[i].empty())
            text += "<system-out>picture: " + escape_markup(check.shots[i].string()) + "</system-out>";
        text += "</testcase>\n";
    }
    return text + "  </testsuite>\n";
}

}  // namespace

std::string to_junit(const std::vector<SceneCheck>& checks) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"tumble\"" + total(checks).attributes() + ">\n";
    for (const SceneCheck& check : checks) text += junit_suite(check);
    return text + "</testsuites>\n";
}

}  // namespace tumble::tools
