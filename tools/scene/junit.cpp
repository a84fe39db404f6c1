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

std::string junit_suite(const SceneCheck& check) {
    const bool broken = !check.error.empty();
    const auto failures = std::ranges::count(check.expectations, false, &ExpectationResult::passed);
    const std::size_t tests = check.expectations.size() + (broken ? 1 : 0);
    std::string text = "  <testsuite" + attribute("name", check.file) + attribute("tests", std::to_string(tests)) +
                       attribute("failures", std::to_string(failures)) + attribute("errors", broken ? "1" : "0") +
                       attribute("time", number_text(check.seconds)) + ">\n";
    const std::string class_name = attribute("classname", check.file);
    if (broken)
        text += "    <testcase" + class_name + attribute("name", "runs") + "><error" +
                attribute("message", check.error) + "/></testcase>\n";
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        // The pointer distinguishes claims of the same text: viewers merge cases with equal names.
        text += "    <testcase" + class_name + attribute("name", pointer_of_claim(i) + ": " + result.claim);
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
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"tumble\">\n";
    for (const SceneCheck& check : checks) text += junit_suite(check);
    return text + "</testsuites>\n";
}

}  // namespace tumble::tools
