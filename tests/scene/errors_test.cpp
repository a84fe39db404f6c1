// What is rejected, and how the errors read: location, pointer, message, caret, hint.
#include <doctest/doctest.h>

#include "scene/bad_scenes.hpp"
#include "scene/example.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;

namespace {

std::vector<Diagnostic> errors_of(const std::string& text) {
    try {
        parse_scene(text, "scene.json");
    } catch (const SceneError& error) {
        return error.diagnostics;
    }
    return {};
}

// The only error of the text.
Diagnostic error_of(const std::string& text) {
    const std::vector<Diagnostic> errors = errors_of(text);
    REQUIRE_MESSAGE(errors.size() == 1, text << " has " << errors.size() << " errors");
    return errors[0];
}

}  // namespace

TEST_CASE("each bad scene is rejected at its location with its reason") {
    for (const test::BadScene& bad : test::kBadScenes) {
        CAPTURE(bad.text);
        const std::vector<Diagnostic> errors = errors_of(bad.text);
        REQUIRE(!errors.empty());
        CHECK(errors[0].pointer == bad.pointer);
        CHECK_MESSAGE(errors[0].message.find(bad.message) != std::string::npos, errors[0].message);
        CHECK(errors[0].line == 1);
    }
}

TEST_CASE("an error reads as file, line, column, pointer, message, source line, caret and hint") {
    const Diagnostic error = error_of("{\n  \"format\": 1,\n  \"world\": {\"substep\": 8}\n}");
    CHECK(to_string(error) ==
          "scene.json:3:13: /world/substep: unknown key \"substep\" [world]\n"
          "    \"world\": {\"substep\": 8}\n"
          "              ^\n"
          "  hint: did you mean 'substeps'?");
}

TEST_CASE("the column counts bytes and the caret counts characters") {
    const Diagnostic error = error_of("{\"format\": 1, \"custom\": \"\xC3\xA9\xC3\xA9\", \"world\": 1}");
    CHECK(error.column == 42);  // after 14 + 10 + 6 + 2 + 9 bytes
    const std::string text = to_string(error);
    const std::size_t caret = text.rfind('^') - text.rfind('\n');
    CHECK(caret == 42);  // after a margin of two and two characters fewer than bytes
}

TEST_CASE("syntax errors state the location, and some of them a hint") {
    struct Case {
        std::string text;
        int line, column;
        std::string message, hint;
    };
    for (const Case& c : {
             Case{"", 0, 0, "the file is empty", "smallest scene"},
             Case{" \n", 1, 1, "the file is empty", "smallest scene"},
             Case{"{\n  \"format\": 1,\n  \"bodies\": [", 3, 14, "unexpected end of input", ""},
             Case{"{\"format\": 1,}", 1, 14, "unexpected '}'", "comma"},
             Case{"<svg xmlns='http://www.w3.org/2000/svg'/>", 1, 1, "invalid literal", "tumble import"},
             Case{"{\"format\": NaN}", 1, 12, "invalid literal", "NaN"},
             Case{"{\"format\": 1, \"world\": {\"gravity\": [0, -Infinity]}}", 1, 41, "invalid number", "Infinity"},
             Case{"{'format': 1}", 1, 2, "invalid literal", "double quotes"},
             Case{"{\"format\": 1e999}", 1, 12, "the number is too large for a double, got 1e999", ""},
             Case{"{\"format\": 1} x", 1, 15, "invalid literal", ""},
             Case{"{\"format\": \"\xFF\"}", 1, 13, "ill-formed UTF-8", ""},
             Case{"{\"format\" 1}", 1, 11, "expected ':'", ""},
             Case{"{format: 1}", 1, 3, "expected string literal", "keys take double quotes"},
             Case{"{f: 1}", 1, 3, "expected string literal", "keys take double quotes"},
             Case{"{\"format\": 010}", 1, 14, "unexpected number literal", "a number has no zeros before it: 10"},
             Case{"{\"format\": [-05]}", 1, 15, "unexpected number literal", "a number has no zeros before it: 5"},
             Case{"# mine\n{\"format\": 1}", 1, 1, "invalid literal", "a comment begins with //"},
             Case{"{\"format\": 1 # mine\n}", 1, 14, "invalid literal", "a comment begins with //"},
             Case{"{\"color\": #d33}", 1, 11, "invalid literal", "a colour takes double quotes"},
             Case{"{\"format\": +1}", 1, 12, "invalid literal", "no + before it"},
             Case{"{\"format\": .5}", 1, 12, "invalid literal", "begins with a digit"},
             Case{"{\"format\": 0x1}", 1, 13, "invalid literal", "in decimal"},
             Case{"{\"format\": 1, \"bodies\": [{}", 1, 28, "unexpected end", "the last '[' is not closed"},
             Case{"\xff\xfe{", 1, 1, "invalid literal", "save the file as UTF-8, not UTF-16"},
             Case{"{\"format\": \"gr\xfcn\"}", 1, 15, "ill-formed UTF-8", "save the file as UTF-8"},
             Case{"{\"format\": 1 \"bodies\": []}", 1, 21, "unexpected string literal", "a comma is missing"},
             Case{"{\"format\": 1, \"bodies\": [{} {}]}", 1, 29, "unexpected '{'", "a comma is missing"},
         }) {
        CAPTURE(c.text);
        const Diagnostic error = error_of(c.text);
        CHECK(error.line == c.line);
        CHECK(error.column == c.column);
        CHECK_MESSAGE(error.message.find(c.message) != std::string::npos, error.message);
        CHECK_MESSAGE(error.hint.find(c.hint) != std::string::npos, error.hint);
    }
}

TEST_CASE("a byte-order mark and both kinds of comment are allowed, and no column counts the mark") {
    CHECK(errors_of("\xEF\xBB\xBF{\"format\": 1} // end").empty());
    CHECK(errors_of("/* a\n \"b\": { */ {\"format\": 1 // 2\n}").empty());
    const Diagnostic error = error_of("\xEF\xBB\xBF{\"format\": 2}");
    CHECK(error.column == 12);
    CHECK(error.source_line == "{\"format\": 2}");
}

TEST_CASE("comments and strings full of brackets do not change the location of an error") {
    const Diagnostic error = error_of(
        "{\"format\": 1, // \"world\": {\n"
        " \"custom\": {\"a\": \"}]\\\"{\", \"world\": [1, {}]}, /* } */\n"
        " \"\\u0077orld\": {\"seed\": -1}}");
    CHECK(error.pointer == "/world/seed");
    CHECK(error.line == 3);
    CHECK(error.column == 25);
}

TEST_CASE("all errors are reported in the order of the text, and at most 20") {
    const std::vector<Diagnostic> three =
        errors_of("{\"format\": 1,\n\"bodies\": [{\"angle\": \"x\"}],\n\"world\": {\"seed\": -1,\n\"gravity\": 0}}");
    REQUIRE(three.size() == 3);
    CHECK(three[0].line == 2);
    CHECK(three[1].line == 3);
    CHECK(three[2].line == 4);

    std::string many = "{\"format\": 1, \"bodies\": [{}";
    for (int i = 0; i < 100; ++i) many += ", {\"angle\": null}";
    const std::vector<Diagnostic> twenty = errors_of(many + "]}");
    REQUIRE(twenty.size() == 20);
    CHECK(twenty.back().hint.find("more errors") != std::string::npos);
}

TEST_CASE("deep nesting is an error, not a crash") {
    for (const std::string& open : {std::string(10000, '['), [] {
                                        std::string objects;
                                        for (int i = 0; i < 10000; ++i) objects += "{\"a\":";
                                        return objects;
                                    }()}) {
        const Diagnostic error = error_of("{\"format\": 1, \"custom\": " + open);
        CHECK(error.message == "the file is nested deeper than 64 levels");
    }
}

TEST_CASE("a file that is too long or has too many keys is an error") {
    std::string keys = "{\"format\": 1, \"custom\": {\"k\": 0";
    for (int i = 0; i < 5000; ++i) keys += ", \"k" + std::to_string(i) + "\": 0";
    CHECK(error_of(keys + "}}").message == "the object has more than 4096 keys");
    CHECK(error_of("{\"format\": 1}" + std::string(33u << 20, ' ')).message == "the file is longer than 32 MiB");
}

TEST_CASE("lists that are too long are refused before anything is made of them") {
    const auto repeated = [](const std::string& element, std::size_t count) {
        std::string list = element;
        for (std::size_t i = 1; i < count; ++i) list += ',' + element;
        return '[' + list + ']';
    };
    CHECK(error_of("{\"format\": 1, \"bodies\": " + repeated("{}", 1000001) + "}").message ==
          "must be an array of at most 1000000, got an array of 1000001");
    CHECK(error_of(test::with_shape("{\"polygon\": {\"vertices\": " + repeated("[0,1]", 65536) + "}}")).message ==
          "must be an array of at most 65535, got an array of 65536");
}

TEST_CASE("a long line is shown around the caret only") {
    const Diagnostic error = error_of("{\"format\": 1, \"custom\": \"" + std::string(1000, 'x') + "\", \"nam\": \"\"}");
    CHECK(to_string(error).size() < 400);
    CHECK(to_string(error).find("\"nam\"") != std::string::npos);
}

TEST_CASE("control characters of a file are not printed to the terminal") {
    const Diagnostic error = error_of("{\"format\": 1, \x1b[2J");
    CHECK(to_string(error).find('\x1b') == std::string::npos);
    CHECK(to_string(error).find("?[2J") != std::string::npos);
}

TEST_CASE("hints suggest what was meant") {
    CHECK(error_of(test::with_shape(R"({"cirle": {"radius": 1}})")).hint == "did you mean 'circle'?");
    CHECK(error_of(R"({"format": 1, "materials": {"ice": {"restituton": 1}}})").hint == "did you mean 'restitution'?");
    CHECK(error_of(R"({"format": 1, "bodies": [{"type": "dynmaic"}]})").hint == "did you mean 'dynamic'?");
    CHECK(error_of(test::with_shape(R"({"circle": {"radius": 1}, "friction": 1})")).hint ==
          "\"friction\" belongs to a material, and the material to a shape");
    CHECK(error_of(R"({"format": 1, "gravity": [0, 0]})").hint == "\"gravity\" belongs to the world");
    CHECK(error_of(test::with_joint(R"("type": "revolute", "bodies": ["a", "B"], "anchor": [0, 0])")).hint ==
          "did you mean 'b'?");
    CHECK(
        error_of(
            R"({"format": 1, "bodies": [{"name": "crate", "repeat": {"ring": {"count": 3}}}], "camera": {"follow": "crate"}})")
            .hint == "the copies are called crate[0] to crate[2]");
}

TEST_CASE("hints contain the names of copies and of what the timeline spawns") {
    const auto hint_of = [](const std::string& more) {
        return error_of(
                   R"({"format": 1, "bodies": [{"name": "plank", "repeat": {"grid": {"columns": 4, "spacing": [2, 1]}}}], "joints": [{"type": "revolute",
            "name": "hinge", "bodies": ["plank[0]", "plank[1]"], "anchor": [1, 0], "repeat": {"columns": 3}})" +
                   more + "]}")
            .hint;
    };
    const auto hint_of_release = [&](const std::string& name) {
        return hint_of(R"(], "timeline": [{"at": 1, "release": ")" + name + "\"}");
    };
    CHECK(hint_of_release("hinge") == "the copies are called hinge[0] to hinge[2]");
    CHECK(hint_of_release("hinge[3]") == "the copies are called hinge[0] to hinge[2]");
    CHECK(hint_of_release("hing") == "did you mean 'hinge'? the copies are called hinge[0] to hinge[2]");
    const auto hint_of_despawn = [&](const std::string& name) {
        return hint_of(R"(], "timeline": [{"every": 1, "spawn": {"name": "drop"}}, {"at": 1, "despawn": ")" + name +
                       "\"}");
    };
    CHECK(hint_of_despawn("plonk[1]") == "did you mean 'plank'? the copies are called plank[0] to plank[3]");
    CHECK(hint_of_despawn("drop") == "the copies are called drop[0], drop[1] and so on");
    CHECK(
        hint_of(
            R"(, {"type": "weld", "bodies": ["plank[0]", "late"], "anchor": [0, 0]}], "timeline": [{"at": 1, "spawn": {"name": "late"}})") ==
        "the timeline spawns it: it does not exist at the start");
}

TEST_CASE("hints answer what newcomers write") {
    const auto hint_of = [](const std::string& text) {
        for (const Diagnostic& error : errors_of(text))  // a key may be missing too
            if (!error.hint.empty()) return error.hint;
        return std::string();
    };
    const std::string before = R"({"format": 1, "bodies": [{"name": "ball", )", after = "}]}";
    CHECK(hint_of(before + R"("static": true)" + after) == R"("type": "static")");
    CHECK(hint_of(before + R"("mass": 5)" + after) ==
          R"("mass": {"mass": 5, "inertia": 1}, or a "density" of the material)");
    CHECK(hint_of(before + R"("repeat": 5)" + after).starts_with(R"(of a body: "repeat": {"grid": {"columns": 5}})"));
    CHECK(hint_of(test::with_shape(R"({"circle": 0.5})")) == R"("circle": {"radius": 0.5})");
    CHECK(hint_of(test::with_shape(R"({"box": 2})")) == R"("box": {"size": [width, height]})");
    CHECK(hint_of(test::with_shape(R"({"box": [2, 1]})")) == R"("box": {"size": [width, height]})");
    CHECK(
        hint_of(test::with_shape(R"({"polygon": [[0, 0], [1, 0], [0, 1]]})")).starts_with(R"("polygon": {"vertices")"));
    CHECK(hint_of(R"({"bodies": []})") == R"("format": 1)");
    CHECK(hint_of(R"({"format": 1, "scene": "a.json", "runs": 3})") == "this is a plan, which `tumble sweep` runs");
    CHECK(hint_of(R"({"format": 1, "body": [], "joint": []})").find("`tumble import`") != std::string::npos);
    CHECK(hint_of(R"({"format": 1, "claims": []})") == R"(claims are listed under "expect")");
    CHECK(hint_of(R"({"format": 1, "world": {"dt": 0.01}})") == R"("steps_per_second": 60)");
    CHECK(hint_of(test::with_joint(R"("revolute": {"bodies": ["a", "b"]})")) == R"("type": "revolute")");

    const std::string joint = R"("type": "distance", "bodies": ["a", "b"], "anchors": [[0, 0], [0, 0]], )";
    CHECK(hint_of(test::with_joint(joint + R"("stiffness": 100)")) ==
          R"("spring": {"hertz": 4, "damping_ratio": 0.5})");
    CHECK(hint_of(test::with_joint(joint + R"("spring": {"hertz": 1, "stiffness": 100})")).starts_with("\"hertz\""));
    CHECK(hint_of(test::with_joint(joint + R"("spring": 3)")) == R"("spring": {"hertz": 3})");
    CHECK(hint_of(test::with_joint(joint + R"("repeat": 5)")).ends_with(R"(of a joint: "repeat": {"columns": 5})"));
    const auto hint_of_body = [&](const std::string& name) {
        return hint_of(test::with_joint(R"("type": "weld", "bodies": [")" + name + R"(", "b"], "anchor": [0, 0])"));
    };
    CHECK(hint_of_body("world") ==
          R"(a joint needs two bodies; one that never moves is {"name": "world", "type": "static"})");
    CHECK(hint_of_body("ground").ends_with(R"({"name": "ground", "type": "static"})"));
    CHECK(!hint_of_body("sky").starts_with("a joint needs"));

    const auto hint_of_claim = [&](const std::string& key) {
        return hint_of(before + R"("angle": 0}], "expect": [{"body": "ball", )" + key + after);
    };
    CHECK(hint_of_claim(R"("y": 3)") == R"("height": [lower, upper])");
    CHECK(hint_of_claim(R"("x": 3)").starts_with("\"inside\""));
    CHECK(hint_of_claim(R"("height": [0, 1], "time": 3)") == R"("at": seconds)");
    CHECK(hint_of(before + R"("angle": 0}], "timeline": [{"time": 3, "body": "ball", "impulse": [1, 0])" + after) ==
          R"("at": seconds)");
}

TEST_CASE("hints write a value of another kind as this format does") {
    const auto hint_of = [](const std::string& text) {
        for (const Diagnostic& error : errors_of(text))
            if (!error.hint.empty()) return error.hint;
        return std::string();
    };
    const std::string body = R"({"format": 1, "bodies": [{"name": "ball", )";
    CHECK(hint_of(body + R"("mass": "5kg"}]})").starts_with(R"("mass": {"mass": 1, "inertia": 1})"));
    CHECK(hint_of(body + R"("position": ["3m", 0]}]})") == "a number without quotes and without a unit");
    CHECK(hint_of(body + R"("position": ["left", 0]}]})").empty());
    CHECK(hint_of(body + R"("position": {"uniform": [[0, 0], [1, 1]]}}]})") ==
          R"(each number is drawn by itself: [{"uniform": [0, 1]}, {"uniform": [0, 1]}])");
    CHECK(hint_of(body + R"("bullet": "true"}]})") == "without quotes");
    CHECK(hint_of(body + R"("bullet": "yes"}]})").empty());
    CHECK(hint_of(body + R"("type": "fixed"}]})") == "this format calls it 'static'");
    CHECK(hint_of(body + R"("repeat": {"count": 5}}]})") == R"("grid": {"columns": 5})");
    CHECK(hint_of(body + R"("repeat": {"grid": [3, 2]}}]})") == R"("grid": {"columns": 3, "rows": 2})");
    CHECK(hint_of(body + R"("circle": {"radius": 1}}]})") == R"("shapes": [{"circle": {"radius": 1}}])");
    CHECK(hint_of(body + R"("shapes": {"circle": {"radius": 1}}}]})") == "in brackets, as a list: [{...}]");
    CHECK(hint_of(test::with_shape(R"({"rect": {"size": [1, 1]}})")) == R"({"box": {"size": [2, 1]}})");
    CHECK(hint_of(test::with_shape(R"({"circle": {"diameter": 1}})")) == R"("radius", half of the diameter)");
    CHECK(
        hint_of(test::with_shape(R"({"polygon": {"points": [[0, 0], [1, 0], [0, 1]]}})")).starts_with("\"vertices\""));
    const auto hint_of_material = [&](const std::string& keys) {
        return hint_of(R"({"format": 1, "materials": {"m": {)" + keys + "}}}");
    };
    CHECK(hint_of_material(R"("color": [255, 16, 0])") == R"("#ff1000")");
    CHECK(hint_of_material(R"("color": [0.5, 0, 0])") == R"(for example "#d33")");
    CHECK(hint_of_material(R"("color": [4294967296, 0, 0])") == R"(for example "#d33")");
    CHECK(hint_of_material(R"("bounce": 1)") == R"("restitution", 0 to 1)");
    CHECK(hint_of(R"({"format": 1, "world": {"time": 3}})") == R"("duration": seconds)");
    CHECK(hint_of(R"({"format": 1, "objects": []})") == R"(bodies are listed under "bodies")");
    CHECK(hint_of(R"({"format": 1, "camera": {"zoom": 2}})").starts_with("\"height\""));
    CHECK(hint_of(R"({"format": 1, "include": ["car.json"]})") == R"({"file": "part.json"})");
    CHECK(hint_of(R"({"format": 1, "expect": ["energy < 1"]})") == R"({"that": "ball.x > 1"})");
    CHECK(hint_of(R"({"format": 1, "expect": [{"state_hash": 1}]})").starts_with("16 digits in quotes"));
    CHECK(hint_of(R"({"format": 1, "expect": [{"frame": "golden.png"}]})").ends_with("\"picture\": \"golden.png\""));
    CHECK(hint_of(R"({"format": 1, "timeline": [{"at": 1, "remove": "a"}]})").starts_with("\"despawn\""));
    CHECK(hint_of(R"~({"format": 1, "timeline": [{"when": "contact(a, b)", "stop": true}]})~") ==
          "write touching(a, b)");
    CHECK(hint_of(R"({"format": 1, "timeline": [{"when": {"contact": 1}, "stop": true}]})")
              .starts_with("an expression in quotes"));
    CHECK(error_of(R"({"format": 1, "expect": [{"picture": "golden.jpg"}]})").message ==
          "must be the name of a .png file, got \"golden.jpg\"");
    const auto picture = [&](std::size_t bytes) {  // whose name has so many bytes
        const std::string name = std::string(bytes - 4, 'a') + ".png";
        return parse_scene(R"({"format": 1, "expect": [{"picture": ")" + name + R"(", "at": 0}]})", "long.json");
    };
    CHECK_NOTHROW(picture(256));
    CHECK_THROWS_WITH(picture(257), doctest::Contains("must be a name of 1 to 256 bytes"));
    const std::string joint = R"("bodies": ["a", "b"], "anchor": [0, 0], )";
    CHECK(hint_of(test::with_joint(joint + R"("type": "revolute", "limits": {"min": -10, "max": 10})")) == "[-10, 10]");
    CHECK(hint_of(test::with_joint(joint + R"("type": "revolute", "motor": true)")).starts_with("\"motor\": {"));
    CHECK(hint_of(test::with_joint(joint + R"("type": "mouse", "target": [0, 1])"))
              .starts_with("of a mouse joint, \"anchor\" is the first"));
    CHECK(hint_of(test::with_joint(joint + R"("type": "rope")")) ==
          R"(this format calls it 'distance', with "limits": [0, length])");
}

TEST_CASE("hints translate the habits of other engines") {
    const auto hint_of = [](const std::string& text) { return error_of(text).hint; };
    const std::string before = R"({"format": 1, "bodies": [{)", after = "}]}";
    CHECK(hint_of(before + R"("x": 3)" + after) == "\"position\": [x, y]");
    CHECK(hint_of(before + R"("rotation": 3)" + after).starts_with("\"angle\""));
    CHECK(hint_of(before + R"("position": {"x": 1, "y": 2.5})" + after) == "[1, 2.5]");
    CHECK(hint_of(test::with_shape(R"({"type": "circle", "circle": {"radius": 1}})"))
              .find(R"({"circle": {"radius": 1}})") != std::string::npos);
    CHECK(hint_of(test::with_shape(R"({"box": {"width": 2, "size": [1, 1]}})")) == "\"size\": [width, height]");
    CHECK(hint_of(test::with_shape(R"({"circle": {"radius": 1}, "material": "rubber"})"))
              .starts_with(R"("materials": {"rubber": )"));
    CHECK(hint_of(test::with_joint(R"("type": "revolute", "bodyA": "a", "bodies": ["a", "b"], "anchor": [0, 0])"))
              .starts_with("\"bodies\""));
    CHECK(hint_of(test::with_joint(R"("type": "hinge", "bodies": ["a", "b"], "anchor": [0, 0])")) ==
          "this format calls it 'revolute'");
    CHECK(hint_of(R"({"format": 1, "world": {"gravity": -10}})") == "a number for x and one for y: [0, -10]");
    CHECK(hint_of(R"({"format": 1, "materials": {"m": {"color": "red"}}})") == "red is \"#f00\"");
    CHECK(hint_of(R"({"format": 1, "materials": {"m": {"color": "puce"}}})") == "for example \"#d33\"");
    CHECK(hint_of(R"({"format": 1, "expect": [{"count": 3, "region": [[0, 0], [1, 1]]}]})") == "[3, 3] for exactly 3");
    CHECK(hint_of(
              R"({"format": 1, "bodies": [{"name": "a"}], "expect": [{"body": "a", "height": [0, 1], "from": 1}]})") ==
          R"(add "when": "always" or "sometime")");
    CHECK(hint_of(R"({"format": 1, "timeline": [{"at": 1, "joint": "j", "motor_speed": 3}]})") ==
          "no joint has a \"name\"");
    CHECK(hint_of(R"({"format": 1, "timeline": [{"when": "time > 1", "then": {"stop": true}, "stop": true}]})") ==
          R"~(the action stands beside: {"when": "touching(a, b)", "stop": true})~");
    CHECK(hint_of(R"({"format": 1, "expect": [{"that": "time < 1", "when": "never"}]})") ==
          R"(negate the condition: "that": "not a.x > 1", "when": "always")");
    CHECK(hint_of(test::with_joint(R"("type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "motor_speed": 3)"))
              .starts_with(R"("motor": {"speed": 90)"));
    CHECK(hint_of(test::with_joint(R"("type": "gear", "bodies": ["a", "b"], "ratio": 2)")) ==
          R"("joints": ["a", "b"] names the two joints that mesh)");
}

TEST_CASE("an unreadable file is a FileError with path and reason") {
    CHECK_THROWS_WITH_AS(load_scene("no/such/scene.json"), "no/such/scene.json: No such file or directory", FileError);
    CHECK_THROWS_WITH_AS(load_scene("/"), "/: Is a directory; name a file in it", FileError);
}

TEST_CASE("hulls that drop vertices are warnings") {
    std::vector<Diagnostic> warnings;
    parse_scene(test::with_shape(R"({"polygon": {"vertices": [[0, 0], [2, 0], [2, 2], [1, 0.5], [0, 2], [1, 0]]}})"),
                "scene.json", &warnings);
    REQUIRE(warnings.size() == 2);
    CHECK(warnings[0].message == "vertices inside the convex hull, which are ignored: 1");
    CHECK(to_string(warnings[1]).find(": warning: 1 of the vertices are duplicates or lie on an edge") !=
          std::string::npos);
    CHECK(warnings[0].pointer == "/bodies/0/shapes/0/polygon/vertices");
}
