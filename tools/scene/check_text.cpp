#include "tools/scene/check_text.hpp"
#include "tools/output/number_text.hpp"

#include <algorithm>
#include <cstdio>

namespace tumble::tools {

namespace {

std::string verdict_line(const SceneCheck& check) {
    if (check.was_skipped) return check.file + ": skipped after a failure\n";
    if (!check.failure.empty()) return check.file + ": failed: " + check.failure + "\n";
    if (!check.was_simulated) return check.file + ": could not be checked\n";
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, " (%.2f s)\n", check.seconds);
    if (check.expectations.empty()) return check.file + ": simulated, has no claims" + seconds;
    const auto passed = std::ranges::count(check.expectations, true, &ExpectationResult::passed);
    const std::size_t count = check.expectations.size();
    return check.file + ": " + std::to_string(passed) + " of " + counted(count, "claim") +
           (count == 1 ? " holds" : " hold") + seconds;
}

}  // namespace

std::string to_text(const SceneCheck& check) {
    std::string text = verdict_line(check);
    if (!check.error.empty()) text += "  " + check.error + (check.error.ends_with('\n') ? "" : "\n");
    for (const UpdatedHash& hash : check.updated)
        text += "  " + check.file + ": " + hash.pointer + " updated from " + hash.before + " to " + hash.after + "\n";
    for (const WrittenPicture& picture : check.pictures)
        text += "  " + check.file + ": " + picture.pointer + " was missing; written to " + picture.file.string() + "\n";
    for (std::size_t i = 0; i < check.expectations.size(); ++i) {
        const ExpectationResult& result = check.expectations[i];
        if (result.passed) continue;
        text += "  " + check.file + ": " + pointer_of_claim(i) + " failed: expected that " + result.claim + "\n    " +
                moment_text(result) + ": " + result.finding + "\n";
        if (!check.shots.empty() && !check.shots[i].empty()) text += "    picture: " + check.shots[i].string() + "\n";
    }
    return text;
}

}  // namespace tumble::tools
