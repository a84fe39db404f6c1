// The page of a gallery: a table of all scenes, then their pictures with their claims.
#include <algorithm>
#include <array>
#include <cstdio>

#include "tools/gallery/gallery.hpp"
#include "tools/output/html.hpp"
#include "tools/output/number_text.hpp"

namespace tumble::tools {

namespace {

std::string rounded(const char* format, double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

std::string claims_text(const SceneCheck& check) {
    if (!check.was_simulated) return "";
    if (check.expectations.empty()) return "no claims";
    const auto passed = std::ranges::count(check.expectations, true, &ExpectationResult::passed);
    return std::to_string(passed) + " of " + std::to_string(check.expectations.size());
}

std::string verdict_text(const SceneCheck& check) {
    if (check.code == ExitCode::ok) return "holds";
    return check.was_simulated ? "fails" : "error";
}

std::vector<HtmlCell> row_of(const GalleryEntry& entry) {
    const SceneCheck& check = entry.check;
    const bool is_good = check.code == ExitCode::ok;
    const double rate = check.seconds > 0.0 ? static_cast<double>(check.steps) / check.seconds : 0.0;
    return {{.text = entry.title},
            {.text = verdict_text(check), .is_alarm = !is_good, .is_good = is_good},
            {.text = claims_text(check)},
            {.text = std::to_string(check.steps), .is_number = true},
            {.text = rounded("%.2f", check.seconds), .is_number = true},
            {.text = rounded("%.0f", rate), .is_number = true},
            {.text = check.file}};
}

std::string caption_of(const GalleryEntry& entry) {
    std::string text = entry.title + ", " + rounded("%.6g", entry.time) + " s: " + claims_text(entry.check);
    const std::size_t claims = entry.check.expectations.size();
    if (claims > 0) text += claims == 1 ? " claim holds" : " claims hold";
    if (!entry.description.empty()) text += ". " + entry.description;
    return text;
}

// What is wrong with a scene, as `check` reports it.
void add_problems(HtmlPage& page, const GalleryEntry& entry) {
    const SceneCheck& check = entry.check;
    for (const std::string* const text : {&check.error, &check.failure, &entry.picture_error})
        if (!text->empty()) page.preformatted(check.file + ": " + *text);
    for (const ExpectationResult& result : check.expectations)
        if (!result.passed)
            page.preformatted(check.file + ": failed: expected that " + result.claim + "\n  " + moment_text(result) +
                              ": " + result.finding);
}

}  // namespace

std::string gallery_page(const std::vector<GalleryEntry>& entries) {
    HtmlPage page("Gallery of " + counted(entries.size(), "scene"));
    page.begin_figures();
    for (const GalleryEntry& entry : entries)
        if (!entry.loop.empty())
            page.linked_picture((kLoopFolder / entry.loop).string(), entry.picture->width, caption_of(entry));
        else if (entry.picture)
            page.picture(*entry.picture, caption_of(entry));
    page.end_figures();
    page.heading("Claims and timings");
    for (const GalleryEntry& entry : entries) add_problems(page, entry);
    const std::vector<std::string> header{"scene", "verdict", "claims", "steps", "time, s", "steps per s", "file"};
    std::vector<std::vector<HtmlCell>> rows;
    for (const GalleryEntry& entry : entries) rows.push_back(row_of(entry));
    page.table(header, rows);
    return page.str();
}

}  // namespace tumble::tools
