// Reads the object files of this build and fails on calls that includes do not show: a function that is declared in
// one file and defined in another, higher one.
//
// `nm` lists the symbols of each object. A symbol that one object leaves undefined and another defines is a call (or a
// use of a variable) from the first source to the second. Inline functions and templates are weak symbols, which have
// no one object, and are left out; calls that the compiler has inlined do not show either.
//
// The sources of a folder are compiled to one object, so that calls within a folder do not show, and a circle is one of
// folders. With TUMBLE_JOIN_SOURCES=OFF each source has its own.
#include <cxxabi.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "house/walls.hpp"

namespace fs = std::filesystem;

namespace {

using tumble::test::first_folder;
using tumble::test::is_below;
using tumble::test::kMaySee;
using tumble::test::kProject;
using tumble::test::may_include;

// For each source, named as in the tables ("scene/json/text.cpp"), or folder of joined sources ("scene/json/*"), those
// that it calls, each with one symbol.
using Calls = std::map<std::string, std::map<std::string, std::string>>;

struct Objects {
    std::set<std::string> sources;
    Calls calls;
};

std::string output_of(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    REQUIRE(pipe != nullptr);
    std::string text;
    char part[65536];
    while (const std::size_t size = std::fread(part, 1, sizeof part, pipe.get())) text.append(part, size);
    return text;
}

std::string demangled(const std::string& symbol) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> name(
        abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
    return status == 0 ? name.get() : symbol;
}

// "scene/json/*" of "Unity/unity_scene-json_cxx.cxx", and other sources as they are.
std::string joined_sources(const std::string& source) {
    static const std::string kBegin = "Unity/unity_", kEnd = "_cxx.cxx";
    if (!source.starts_with(kBegin)) return source;
    std::string folder = source.substr(kBegin.size(), source.size() - kBegin.size() - kEnd.size());
    std::ranges::replace(folder, '-', '/');
    return folder + "/*";
}

// The source of "<build>/src/CMakeFiles/tumble.dir/math/trigonometry.cpp.o". Empty if it does not exist: the object is
// left over from a source that was renamed, or is a batch of sources of several folders.
std::string source_of(const std::string& object, const fs::path& top) {
    const std::size_t start = object.find(".dir/") + 5;
    const std::string source = joined_sources(object.substr(start, object.size() - start - 2));
    const fs::path file = source.ends_with("/*") ? fs::path(source).parent_path() : fs::path(source);
    if (!fs::exists(kProject / top / file)) return {};
    return top == "src" ? source : (top / source).generic_string();
}

// The sources that the object holds: its own, or those that the file of joined sources includes.
std::set<std::string> sources_in(const std::string& object, const std::string& source) {
    if (!source.ends_with("/*")) return {source};
    std::set<std::string> sources;
    std::ifstream file(object.substr(0, object.size() - 2));
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("#include \"")) continue;
        const fs::path included = line.substr(10, line.size() - 11);
        sources.insert((fs::path(source).parent_path() / included.filename()).generic_string());
    }
    return sources;
}

std::string folder_of(const std::string& source) { return fs::path(source).parent_path().generic_string(); }

Objects read_objects() {
    struct Use {
        std::string source, symbol;
    };
    Objects objects;
    std::vector<Use> uses;
    std::map<std::string, std::string> definitions;  // source by symbol
    std::set<std::string> read, joined;
    for (const char* top : {"src", "tools"}) {
        const std::string folder = (fs::path(TUMBLE_BINARY_DIR) / top / "CMakeFiles").string();
        std::istringstream lines(output_of("find '" + folder + "' -name '*.c[px][px].o' -exec " TUMBLE_NM " -A {} +"));
        for (std::string line; std::getline(lines, line);) {  // OBJECT:[ADDRESS] TYPE SYMBOL
            const std::size_t colon = line.find(".o:") + 2, space = line.rfind(' ');
            const std::string object = line.substr(0, colon), symbol = line.substr(space + 1);
            const std::string source = source_of(object, top);
            if (source.empty()) continue;
            if (read.insert(object).second) objects.sources.merge(sources_in(object, source));
            if (source.ends_with("/*")) joined.insert(source);
            const char type = line[space - 1];
            if (type == 'U') uses.push_back({source, symbol});
            if (std::string_view("TDRB").find(type) != std::string_view::npos) definitions[symbol] = source;
        }
    }
    // Sources with options of their own are compiled alone, beside the joined ones of their folder.
    const auto with_folder = [&](const std::string& source) {
        const std::string folder = folder_of(source) + "/*";
        return joined.contains(folder) ? folder : source;
    };
    for (const Use& use : uses) {
        const auto definition = definitions.find(use.symbol);
        if (definition == definitions.end()) continue;
        const std::string source = with_folder(use.source), target = with_folder(definition->second);
        if (source != target) objects.calls[source].emplace(target, use.symbol);
    }
    return objects;
}

const Objects& objects() {
    static const Objects read = read_objects();
    return read;
}

// Tarjan's algorithm: the sets of sources in which each calls each other, directly or through others.
class Circles {
public:
    explicit Circles(const Calls& calls) : calls_(calls) {
        for (const auto& [source, unused] : calls_)
            if (!numbers_.contains(source)) visit(source);
    }

    const std::vector<std::set<std::string>>& found() const { return found_; }

private:
    // Returns the lowest number that the source leads to among the sources that are still on the stack.
    std::size_t visit(const std::string& source) {
        const std::size_t number = numbers_[source] = numbers_.size();
        std::size_t lowest = number;
        stack_.push_back(source);
        if (const auto called = calls_.find(source); called != calls_.end())
            for (const auto& [target, unused] : called->second) {
                if (!numbers_.contains(target))
                    lowest = std::min(lowest, visit(target));
                else if (std::ranges::find(stack_, target) != stack_.end())
                    lowest = std::min(lowest, numbers_[target]);
            }
        if (lowest == number) close(source);
        return lowest;
    }

    void close(const std::string& first) {
        const auto begin = std::ranges::find(stack_, first);
        if (stack_.end() - begin > 1) found_.emplace_back(begin, stack_.end());
        stack_.erase(begin, stack_.end());
    }

    const Calls& calls_;
    std::map<std::string, std::size_t> numbers_;  // in the order of the visits
    std::vector<std::string> stack_;
    std::vector<std::set<std::string>> found_;
};

std::vector<std::set<std::string>> find_circles(const Calls& calls) {
    const Circles circles(calls);
    return circles.found();
}

std::string text_of(const std::set<std::string>& circle) {
    std::string text = "a circle of calls:\n";
    for (const std::string& source : circle)
        for (const auto& [target, symbol] : objects().calls.at(source))
            if (circle.contains(target)) text += "  " + source + " -> " + target + ": " + demangled(symbol) + "\n";
    return text;
}

// True if the folder may include the target, or a folder that may.
bool reaches(const std::string& folder, const std::string& target) {
    if (may_include(folder, target)) return true;
    return std::ranges::any_of(kMaySee, [&](const auto& entry) {
        return entry.first != folder && may_include(folder, entry.first) && reaches(entry.first, target);
    });
}

// Within a room the table of includes decides; from room to room, by public headers, the order of the rooms too.
bool may_call(const std::string& folder, const std::string& target) {
    return reaches(folder, target) || is_below(first_folder(target), first_folder(folder));
}

// A source that is compiled only with Box2D v3, or only without.
bool is_variant(const std::string& source) { return folder_of(source) == "reference/box2d_v3/library"; }

}  // namespace

TEST_CASE("every source has an object file that the tests of calls have read") {
    std::ptrdiff_t sources = 0;
    for (const char* top : {"src", "tools"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kProject / top)) {
            if (entry.path().extension() != ".cpp") continue;
            const fs::path source = fs::relative(entry.path(), top == std::string("src") ? kProject / top : kProject);
            if (first_folder(source.generic_string()) == "python") continue;  // built by its own setup.py
            if (is_variant(source.generic_string())) continue;
            ++sources;
            CHECK_MESSAGE(objects().sources.contains(source.generic_string()), source.generic_string());
        }
    CHECK(sources > 200);
    CHECK(std::ranges::count_if(objects().sources, std::not_fn(is_variant)) == sources);
    CHECK(objects().calls.size() > 75);
}

TEST_CASE("sources do not call each other in a circle") {
    for (const std::set<std::string>& circle : find_circles(objects().calls)) FAIL_CHECK(text_of(circle));
}

TEST_CASE("folders call only folders that they may include, or rooms below") {
    for (const auto& [source, called] : objects().calls)
        for (const auto& [target, symbol] : called)
            if (!may_call(folder_of(source), folder_of(target)))
                FAIL_CHECK(source << " calls " << target << ": " << demangled(symbol));
}

TEST_CASE("Tarjan's algorithm finds two circles and leaves a chain alone") {
    const Calls calls = {{"a", {{"b", ""}}}, {"b", {{"c", ""}}}, {"c", {{"a", ""}, {"d", ""}}},
                         {"d", {{"e", ""}}}, {"e", {{"f", ""}}}, {"f", {{"e", ""}}}};
    const std::vector<std::set<std::string>> expected = {{"e", "f"}, {"a", "b", "c"}};
    CHECK(find_circles(calls) == expected);
}
