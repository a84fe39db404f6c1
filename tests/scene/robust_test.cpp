// Whatever the bytes are, reading ends with a scene or with a SceneError.
#include <doctest/doctest.h>

#include <random>

#include "scene/bad_scenes.hpp"
#include "scene/example.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;

namespace {

// True if the text was accepted; every error must have a location and a text.
bool survives(const std::string& text) {
    try {
        const Scene scene = parse_scene(text, "random.json");
        to_json(scene);
        return true;
    } catch (const SceneError& error) {
        CHECK(!error.diagnostics.empty());
        CHECK(error.diagnostics.size() <= 20);
        for (const Diagnostic& diagnostic : error.diagnostics) {
            CHECK(diagnostic.file == "random.json");
            CHECK((diagnostic.line > 0 && diagnostic.column > 0) == !text.empty());
            CHECK(!diagnostic.message.empty());
            CHECK((diagnostic.pointer.empty() || diagnostic.pointer[0] == '/'));
        }
        return false;
    }
}

}  // namespace

TEST_CASE("a cut-off scene is an error at every length") {
    const std::string text = test::kExample;
    const std::size_t end = text.rfind('}');
    for (std::size_t length = 0; length <= end; ++length) CHECK(!survives(text.substr(0, length)));
    CHECK(survives(text.substr(0, end + 1)));
}

TEST_CASE("scenes with random bytes changed, removed or doubled are read or refused") {
    std::mt19937_64 random(11);
    const std::string interesting = "{}[]\",:/*-0123456789.eE+\\ \n\x80\xFFtruenl";
    int accepted = 0;
    constexpr int kSamples = 4000;
    for (int sample = 0; sample < kSamples; ++sample) {
        std::string text = test::kExample;
        const std::uint64_t changes = random() % 3;
        for (std::uint64_t change = 0; change <= changes; ++change) {
            const std::size_t at = random() % text.size();
            switch (random() % 3) {
                case 0: text[at] = interesting[random() % interesting.size()]; break;
                case 1: text.erase(at, 1 + random() % 8); break;
                default: text.insert(at, text.substr(at, 1 + random() % 30));
            }
        }
        if (survives(text)) ++accepted;
    }
    // Both outcomes occur: changes in digits, texts and comments are harmless, most others are not.
    CHECK(accepted > kSamples / 50);
    CHECK(accepted < kSamples / 2);
}

TEST_CASE("every value of the example may be of any type") {
    const std::string values[] = {"null", "true", "-1", "1e9", "\"x\"", "[]", "{}", "[1, 2, 3]", "{\"a\": 1}"};
    const std::string text = test::kExample;
    int accepted = 0, refused = 0;
    for (std::size_t colon = text.find(": "); colon != std::string::npos; colon = text.find(": ", colon + 1)) {
        const std::size_t end = text.find_first_of(",}]\n", colon);
        for (const std::string& value : values)
            ++(survives(text.substr(0, colon + 2) + value + text.substr(end)) ? accepted : refused);
    }
    CHECK(accepted > 20);
    CHECK(refused > 400);
}

TEST_CASE("the errors of over a hundred bad files have a location, whatever the layout") {
    for (const test::BadScene& bad : test::kBadScenes) CHECK(!survives("// comment\n\t" + bad.text + "\r\n"));
    CHECK(test::kBadScenes.size() > 125);
}
