// The expressions that hints propose: each is an expression itself.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include "scene/expressions/vocabulary.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

constexpr const char* kHintScene = R"({"format": 1, "bodies": [
    {"name": "a", "shapes": [{"circle": {"radius": 1}}]}, {"name": "b", "shapes": [{"circle": {"radius": 1}}]},
    {"name": "ball", "shapes": [{"circle": {"radius": 1}}]}, {"name": "floor", "type": "static"},
    {"name": "my crate", "shapes": [{"circle": {"radius": 1}}]},
    {"name": "crate", "repeat": {"grid": {"columns": 3, "spacing": [3, 0]}}, "shapes": [{"box": {"size": [1, 1]}}]},
    {"name": "it's", "repeat": {"grid": {"columns": 3, "spacing": [3, 0]}}, "shapes": [{"box": {"size": [1, 1]}}]}],
  "joints": [{"type": "revolute", "name": "hinge", "bodies": ["floor", "crate[0]"], "anchors": [[0, 0], [0, 0]],
              "repeat": {"columns": 3, "spacing": [3, 0]}},
             {"type": "distance", "name": "rod", "bodies": ["a", "b"], "anchors": [[0, 0], [1, 0]]}],
  "timeline": [{"every": 0.5, "spawn": {"name": "drop", "shapes": [{"circle": {"radius": 1}}]}}]})";

const Scene& hint_scene() {
    static const Scene read = parse_scene(kHintScene, "hints");
    return read;
}

// The hint of an expression that is refused as a condition; "accepted" for one that is not.
std::string hint_of(const std::string& text) {
    try {
        const Expression expression(text, hint_scene());
        if (expression.kind() == Expression::Kind::condition) return "accepted";
    } catch (const ExpressionError& error) {
        return error.hint;
    }
    Scene with_claim = hint_scene();
    with_claim.expect.emplace_back().that = text;
    try {
        build_world(with_claim);
    } catch (const SceneError& error) {
        return error.diagnostics.front().hint;
    }
    return "accepted";
}

bool parses(const std::string& text) {
    const std::vector<std::string> given{"degrees", "x", "y", "low", "high", "left", "bottom", "right", "top"};
    try {
        const Expression expression(text, hint_scene(), {}, given);
        return true;
    } catch (const ExpressionError&) {
        return false;
    }
}

// The phrases of hints that propose expressions, which are their groups.
const std::map<std::string, std::regex>& phrases() {
    static const std::map<std::string, std::regex> all{
        {"compare", std::regex("compare it: (.*)")},
        {"number", std::regex("(.*) is a number")},
        {"root", std::regex("(.*) is the square root")},
        {"common", std::regex(R"(name one, (.*), or all of them: (all\(.*\)), (any\(.*\)), ((?:max|count)\(.*\)))")},
        {"one argument", std::regex("(.*) with one argument is that of all copies")},
        {"no copies",
         std::regex(R"(a body or joint without a "repeat" has no copies: write (.*) without the function)")},
        {"property", std::regex("ask for a property: (.*)")},
        {"touching", std::regex(R"(write (touching\(.*\)))")}};
    return all;
}

struct Proposal {
    std::string phrase;
    std::vector<std::string> expressions;
};

Proposal proposal_of(const std::string& hint) {
    for (const auto& [name, phrase] : phrases()) {
        std::smatch match;
        if (!std::regex_match(hint, match, phrase)) continue;
        return {name, {std::next(match.begin()), match.end()}};
    }
    return {};
}

// A hint about a part within a function about copies proposes a part with their common name: crate.x in max(crate).
bool is_proposed_well(const Proposal& proposal) {
    return std::ranges::all_of(proposal.expressions, [&](const std::string& text) {
        return parses(text) || parses("max(" + text + ")") || parses("sum(" + text + ")") ||
               parses("any(" + text + ")");
    });
}

// Expressions of which many mix up numbers and conditions, or copies and single bodies.
class Mixer {
public:
    explicit Mixer(std::uint32_t seed) : random_(seed) {}

    std::string expression(int depth) {
        if (depth == 0)
            return one_of({"1", "true", "a.x", "a.awake", "crate.y", "crate.awake", "'it''s'.x", "hinge.angle",
                           "hinge.exists", "rod.length", "'my crate'.speed", "crate[1].x", "time", "crate", "hinge",
                           "drop.y", "touching(a, crate)", "distance(crate, b)"});
        // One draw a statement: the operands of + have no order.
        const std::string a = expression(depth - 1);
        const std::string b = expression(depth - 1);
        const std::string c = expression(depth - 1);
        const std::string first = one_of({"a", "crate", "'it''s'"});
        const std::string second = one_of({"b", "crate"});
        switch (random_() % 9) {
            case 0: return "(" + a + ")";
            case 1: return one_of({"-", "not "}) + a;
            case 2: return a + one_of({"^2", "^-1", "^0.5"});
            case 3: return "if(" + a + ", " + b + ", " + c + ")";
            case 4: return one_of({"max(", "min(", "hypot("}) + a + ", " + b + ")";
            case 5: return one_of({"max(", "all(", "any(", "sum(", "count(", "sqrt("}) + a + ")";
            case 6: return first + one_of({" hits ", " touches "}) + second;
            default: return a + one_of({" + ", " * ", " < ", " == ", " and ", " or "}) + b;
        }
    }

private:
    std::string one_of(const std::vector<std::string>& texts) { return texts[random_() % texts.size()]; }
    std::mt19937 random_;
};

}  // namespace

TEST_CASE("each expression that a hint proposes parses") {
    struct Proposed {
        std::string text;
        std::vector<std::string> proposed;
    };
    const std::vector<Proposed> examples{
        {"a.x", {"a.x > 0"}},
        {"(a.x + 1) * (2 - a.y)", {"(a.x + 1) * (2 - a.y) > 0"}},
        {"(a.x + 1) * (2 - a.y) and true", {"(a.x + 1) * (2 - a.y) > 0"}},
        {"1 + (a.x < 1 or (a.y < 2))", {"if(a.x < 1 or (a.y < 2), 1, 0)"}},
        {"1 < 2 < (a.awake or (a.exists))", {"if(a.awake or (a.exists), 1, 0)"}},
        {"-(a.x) and true", {"-(a.x) > 0"}},
        {"(not (a.awake)) + 1", {"if(not (a.awake), 1, 0)"}},
        {"(a.x + (1)) ^ 0.5", {"sqrt(a.x + (1))"}},
        {"(a.x) ^ 2 and true", {"(a.x) ^ 2 > 0"}},
        {"max(if(hinge.exists, 1, 0), 2) > 1", {"max(if(hinge.exists, 1, 0))"}},
        {"max(2, (if(crate.awake, 1, 0) + crate.x) * 2) > 1", {"max((if(crate.awake, 1, 0) + crate.x) * 2)"}},
        {"min(distance('it''s', a), 2) > 1", {"min(distance('it''s', a))"}},
        {"'it''s'.x > 1", {"'it''s[0]'.x", "all('it''s'.x > 0)", "any('it''s'.x > 0)", "max('it''s'.x)"}},
        {"crate.awake", {"crate[0].awake", "all(crate.awake)", "any(crate.awake)", "count(crate.awake)"}},
        {"sum((a.x + 1) * (2))", {"((a.x + 1) * (2))"}},
        {"not all(a.x > 1 or a.y > 1)", {"(a.x > 1 or a.y > 1)"}},
        {"2 * sum(a.x + a.y) > 1", {"(a.x + a.y)"}},
        {"sum(-a.x) ^ 2 > 1", {"(-a.x)"}},
        {"sum(a.x ^ 2) ^ 2 > 1", {"(a.x ^ 2)"}},
        {"all(not a.awake) == true", {"(not a.awake)"}},
        {"2 * sum(a.x) > 1", {"a.x"}},
        {"a.awake == a.x", {"(a.x > 0)"}},
        {"a.awake != a.x + 1", {"(a.x + 1 > 0)"}},
        {"count((a.x > 1) or (a.y > 1)) > 0", {"if((a.x > 1) or (a.y > 1), 1, 0)"}},
        {"a > 1", {"a.x"}},
        {"crate > 1", {"crate[0].x"}},
        {"hinge > 1", {"hinge[0].force"}},
        {"max(hinge) > 1", {"hinge.force"}},
        {"rod > 1", {"rod.force"}},
        {"'it''s' hits crate", {"touching('it''s', crate)"}}};
    for (const Proposed& example : examples) {
        CAPTURE(example.text);
        const std::string hint = hint_of(example.text);
        CAPTURE(hint);
        const Proposal found = proposal_of(hint);
        CHECK(found.expressions == example.proposed);
        CHECK(is_proposed_well(found));
    }
}

TEST_CASE("each expression that hints for mixed expressions propose parses") {
    std::map<std::string, int> counts;
    Mixer mixer(7);
    for (int i = 0; i < 20'000; ++i) {
        const std::string text = mixer.expression(1 + i % 3);
        const std::string hint = hint_of(text);
        const Proposal proposal = proposal_of(hint);
        if (proposal.expressions.empty()) continue;
        ++counts[proposal.phrase];
        CAPTURE(text);
        CAPTURE(hint);
        REQUIRE(is_proposed_well(proposal));
    }
    for (const auto& phrase : phrases()) {
        CAPTURE(phrase.first);
        CHECK(counts[phrase.first] > 100);
    }
}

TEST_CASE("the form of each function parses") {
    for (const scene::FunctionWord& word : scene::function_words()) {
        std::string form = std::regex_replace(std::string(word.form), std::regex("condition"), "true");
        if (!std::string(word.takes).starts_with('b'))
            form = std::regex_replace(form, std::regex(R"(\b([ab])\b)"), "$1.x");
        CAPTURE(form);
        CHECK(parses(form));
    }
}

// Words of other engines have hints such as "when": "touching(a, b)".
TEST_CASE("the conditions that hints of keys propose parse") {
    const std::regex condition(R"re(("that": |"when": |expression in quotes: )"([^"]+[(<>][^"]+)")re");
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(TUMBLE_SOURCE_DIR "/src/scene")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string source = read_file(entry.path());
        for (auto match = std::sregex_iterator(source.begin(), source.end(), condition);
             match != std::sregex_iterator(); ++match, ++count) {
            const std::string text = (*match)[2];
            CAPTURE(entry.path().string());
            CAPTURE(text);
            CHECK(parses(text));
        }
    }
    CHECK(count >= 7);
}
