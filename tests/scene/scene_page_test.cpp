// scenes/README.md, the page of the scene format: it names every key, and the claims of its complete scenes hold.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

std::string page() { return read_file(TUMBLE_SOURCE_DIR "/scenes/README.md", 1u << 20); }

// The names of all properties, and the values of all enumerations, in the schema.
void collect_words(const nlohmann::json& schema, std::set<std::string>& words) {
    if (!schema.is_structured()) return;
    if (schema.is_object() && schema.contains("properties"))
        for (const auto& [name, property] : schema["properties"].items())
            if (property.is_object()) words.insert(name);
    if (schema.is_object() && schema.contains("enum") && schema["enum"].is_array())
        for (const auto& value : schema["enum"]) words.insert(value.get<std::string>());
    for (const auto& [key, element] : schema.items())
        if (key != "default") collect_words(element, words);
}

// The ```jsonc blocks that are a whole file.
std::vector<std::string> whole_scenes(const std::string& text) {
    const std::string fence = "```jsonc\n";
    std::vector<std::string> scenes;
    for (std::size_t begin = text.find(fence); begin != std::string::npos; begin = text.find(fence, begin)) {
        begin += fence.size();
        const std::string block = text.substr(begin, text.find("```", begin) - begin);
        if (block.find("\"format\"") != std::string::npos) scenes.push_back(block);
    }
    return scenes;
}

}  // namespace

TEST_CASE("the page of the scene format names every key and every enumerator") {
    const std::string text = page();
    std::set<std::string> words;
    collect_words(nlohmann::json::parse(scene_schema()), words);
    CHECK(words.size() > 120);
    for (const std::string& word : words) {
        const bool is_named = text.find('`' + word + '`') != std::string::npos;
        const bool is_in_example = text.find('"' + word + "\":") != std::string::npos;
        CHECK_MESSAGE((is_named || is_in_example), word, " is not on the page");
    }
}

TEST_CASE("the scenes on the page of the scene format have no warnings, and their claims hold") {
    const std::vector<std::string> scenes = whole_scenes(page());
    CHECK(!scenes.empty());
    for (const std::string& text : scenes) {
        CAPTURE(text);
        std::vector<Diagnostic> warnings;
        LoadOptions options;
        options.lint = true;
        const Scene scene = parse_scene(text, "scenes/README.md", options, &warnings);
        for (const Diagnostic& warning : warnings) FAIL_CHECK(to_string(warning));
        REQUIRE(!scene.expect.empty());
        SceneRun run(scene);
        ExpectationWatch watch(scene, run.built());
        watch.observe(run.built());
        const int steps = static_cast<int>(scene.world.duration * scene.world.steps_per_second);
        for (int step = 0; step < steps; ++step) {
            run.step();
            watch.observe(run.built());
        }
        for (const ExpectationResult& result : watch.results())
            CHECK_MESSAGE(result.passed, result.claim, ": ", result.finding);
    }
}
