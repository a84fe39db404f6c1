// The README.md of a folder is its table of contents: it names, as code, every source, script and folder beside it.
#include <doctest/doctest.h>

#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "house/files.hpp"

namespace fs = std::filesystem;

namespace {

using namespace tumble::test;

constexpr int kLargestWithoutPage = 10;  // sources

// What a page shows as code: `between backquotes`.
std::string code_in_page(const std::string& page) {
    std::string code;
    std::istringstream lines(page);
    bool is_listing = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) is_listing = !is_listing;
        if (is_listing) continue;
        for (std::size_t open = line.find('`'); open != std::string::npos;) {
            const std::size_t close = line.find('`', open + 1);
            if (close == std::string::npos) break;
            code += line.substr(open + 1, close - open - 1) + "\n";
            open = line.find('`', close + 1);
        }
    }
    return code;
}

bool is_part_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

bool has_word(const std::string& text, const std::string& word) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_part_of_word(text[at - 1])) && (end == text.size() || !is_part_of_word(text[end])))
            return true;
    }
    return false;
}

bool contains_sources(const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (is_source(entry.path())) return true;
    return false;
}

// What the page of a folder must name: sources without their ending, as a header and its source are one entry.
std::set<std::string> entries_of(const fs::path& folder) {
    std::set<std::string> entries;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (is_source(entry.path())) entries.insert(entry.path().stem().string());
        if (entry.path().extension() == ".sh" || (entry.is_directory() && contains_sources(entry.path())))
            entries.insert(entry.path().filename().string());
    }
    return entries;
}

}  // namespace

TEST_CASE("a folder of more than ten sources has a page") {
    std::map<fs::path, int> counts;
    for (const fs::path& file : files_below({"src", "tools", "include"}, {".cpp", ".hpp"}))
        ++counts[file.parent_path()];
    for (const auto& counted : counts)
        CHECK_MESSAGE((counted.second <= kLargestWithoutPage || fs::exists(counted.first / "README.md")),
                      name_in_project(counted.first));
}

TEST_CASE("a page names the sources, scripts and folders beside it") {
    int pages = 0;
    for (const fs::path& file : files_below({"src", "tools", "include", "tests"}, {".md"})) {
        if (file.filename() != "README.md") continue;
        ++pages;
        const std::string code = code_in_page(text_in(file));
        for (const std::string& entry : entries_of(file.parent_path()))
            CHECK_MESSAGE(has_word(code, entry), name_in_project(file) << " does not name " << entry);
    }
    CHECK(pages > 40);
}

TEST_CASE("only whole words within code name a file") {
    const std::string code = code_in_page("a `run.cpp`, `f` of shape\n```\n`listing`\n```\nand `../cut`\n");
    CHECK(has_word(code, "run"));
    CHECK(has_word(code, "cut"));
    CHECK_FALSE(has_word(code, "ru"));
    CHECK_FALSE(has_word(code, "shape"));
    CHECK_FALSE(has_word(code, "listing"));
}
