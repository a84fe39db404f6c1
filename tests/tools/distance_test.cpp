// `tumble distance`.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>
#include <string>

#include "process.hpp"
#include "support/near.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::kDouble;
using tumble::test::near;
using tumble::test::Process;
using tumble::test::run_tumble;
using tumble::test::tumble_command;

TEST_CASE("the distance of two circles is that of their centres less their radii") {
    // Centres (0, 0) and (3, 4), 5 apart; radii 1 and 0.5.
    const Answer answer = run_tumble({"distance", R"({"circle": {"radius": 1}})",
                                      R"({"circle": {"radius": 0.5}, "pose": {"position": [3, 4]}})", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json result = json::parse(answer.out);
    CHECK(result["status"] == "separated");
    CHECK(near(result["distance"].get<double>(), 3.5, kDouble));
    CHECK(result["lower"].get<double>() <= 3.5);
    CHECK(result["upper"].get<double>() >= 3.5);
    CHECK(near(result["point_a"][0].get<double>(), 0.6, kDouble));
    CHECK(near(result["point_a"][1].get<double>(), 0.8, kDouble));
    CHECK(near(result["point_b"][0].get<double>(), 2.7, kDouble));
    CHECK(near(result["normal"][1].get<double>(), 0.8, kDouble));
    CHECK(result["b_pose"]["position"] == json({3, 4}));
    CHECK(result["b_pose"]["rotation"] == json({1, 0}));
    CHECK(result["certificate"]["pairs"] == json({{0, 0}}));
    CHECK(result.contains("iterations"));
}

TEST_CASE("the pose of a query line is inside of the shape or beside it, but not both") {
    const auto answer = [](const std::string& line) {
        return Process(tumble_command({"distance", "--stdin"}), ".", line).wait();
    };
    const std::string disc = R"({"circle": {"radius": 1}})",
                      posed = R"({"circle": {"radius": 1}, "pose": {"position": [3, 0]}})";
    CHECK(json::parse(answer(R"({"a": )" + disc + R"(, "b": )" + posed + "}").out)["distance"] == 1.0);
    CHECK(answer(R"({"a": )" + disc + R"(, "b": )" + posed + "}").out ==
          answer(R"({"a": )" + disc + R"(, "b": )" + disc + R"(, "b_pose": {"position": [3, 0]}})").out);
    CHECK(
        answer(R"({"a": )" + disc + R"(, "b": )" + posed + R"(, "b_pose": {"position": [3, 0]}})").out.find("twice") !=
        std::string::npos);
    CHECK(run_tumble({"distance", R"({"circle": {"radius": 1}, "position": [3, 0]})", disc})
              .err.find("belongs to the pose") != std::string::npos);
    CHECK(run_tumble({"distance", R"({"circle": {"radius": 1}, "x": })", disc}).err.find("json.exception") ==
          std::string::npos);
}

TEST_CASE("a pose has an angle or a rotation, and quarter turns are exact") {
    const std::string box = R"({"box": {"size": [2, 1]}})";
    const auto distance_to = [&](const std::string& pose) {
        const Answer answer =
            run_tumble({"distance", box, R"({"box": {"size": [2, 1]}, "pose": )" + pose + "}", "--json"});
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        return json::parse(answer.out)["distance"].get<double>();
    };
    CHECK(distance_to(R"({"position": [4, 0]})") == 2.0);
    CHECK(distance_to(R"({"position": [4, 0], "angle": 90})") == 2.5);
    CHECK(distance_to(R"({"position": [4, 0], "rotation": [0, 1]})") == 2.5);
    CHECK(distance_to(R"({"position": [1.5, 0]})") == -0.5);
}

TEST_CASE("clockwise, self-crossing and repeated points give their hull") {
    const auto distance_of = [](const std::string& vertices) {
        const Answer answer = run_tumble({"distance", R"({"polygon": {"vertices": )" + vertices + "}}",
                                          R"({"circle": {"radius": 1}, "pose": {"position": [4, 0.5]}})", "--json"});
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        return json::parse(answer.out)["distance"].get<double>();
    };
    CHECK(distance_of("[[0, 0], [1, 0], [1, 1], [0, 1]]") == 2.0);
    CHECK(distance_of("[[0, 1], [1, 1], [1, 0], [0, 0]]") == 2.0);
    CHECK(distance_of("[[0, 0], [1, 1], [1, 0], [0, 1]]") == 2.0);
    CHECK(distance_of("[[0, 0], [0, 0], [1, 0], [0.5, 0], [1, 1], [1, 1], [0, 1], [0.5, 0.5]]") == 2.0);
}

TEST_CASE("a sliver is answered for the points as given, not for a welded hull") {
    // 10 m x 4e-6 m. Its lowest point lies within the weld distance of the chord above it, and is kept.
    const std::string sliver = R"({"polygon": {"vertices": [[-5, 0], [0, -2e-6], [5, 0], [0, 2e-6]]}})",
                      point = R"({"circle": {"radius": 0, "center": [0, -1]}})";
    const double exact = 1.0 - static_cast<double>(2e-6f);
    const Answer alone = run_tumble({"distance", sliver, point, "--json"}),
                 line = Process(tumble_command({"distance", "--stdin"}), ".",
                                R"({"a": )" + sliver + R"(, "b": )" + point + "}\n")
                            .wait();
    for (const Answer& answer : {alone, line}) {
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        const json result = json::parse(answer.out);
        CHECK(result["lower"].get<double>() <= exact);
        CHECK(result["upper"].get<double>() >= exact);
        CHECK(result["upper"].get<double>() - result["lower"].get<double>() < 1e-13);
    }
}

TEST_CASE("a polygon without area is the segment or the point that its vertices span") {
    const auto answer_for = [](const std::string& shape) {
        const Answer answer =
            run_tumble({"distance", shape, R"({"circle": {"radius": 1}, "pose": {"position": [4, 0.5]}})", "--json"});
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        return answer.out;
    };
    CHECK(answer_for(R"({"polygon": {"vertices": [[0, 0], [2, 2], [1, 1], [0, 0]]}})") ==
          answer_for(R"({"segment": {"from": [0, 0], "to": [2, 2]}})"));
    CHECK(answer_for(R"({"polygon": {"vertices": [[1, 1], [1, 1], [1, 1]], "radius": 0.5}})") ==
          answer_for(R"({"circle": {"center": [1, 1], "radius": 0.5}})"));
}

TEST_CASE("an invalid query ends with exit code 3, and the message names the location") {
    const std::string circle = R"({"circle": {"radius": 1}})";
    for (const std::string& wrong :
         {std::string("{"), std::string("[]"), std::string(R"({"circle": {}})"),
          std::string(R"({"circle": {"radius": -1}})"),
          std::string(R"({"circle": {"radius": 1}, "pose": {"position": [0]}})"),
          std::string(R"({"circle": {"radius": NaN}})"), std::string(R"({"circle": {"radius": 1e999}})"),
          std::string(R"({"circle": {"radius": 1}, "pose": {"position": [Infinity, 0]}})"),
          std::string(R"({"polygon": {"vertices": []}})"),
          std::string(R"({"circle": {"radius": 1}, "pose": {"angel": 3}})"),
          std::string(R"({"circle": {"radius": 1}, "pose": {"angle": 3, "rotation": [1, 0]}})"),
          std::string(R"({"circle": {"radius": 1}, "pose": {"rotation": [1, 1]}})"),
          std::string(R"({"circle": {"radius": 1}, "pose": {"position": [1e300, 0]}})"),
          std::string(R"({"chain": {"points": [[0, 0], [1, 0], [2, 0]]}})")}) {
        CAPTURE(wrong);
        const Answer answer = run_tumble({"distance", circle, wrong});
        CHECK(answer.code == 3);
        CHECK(answer.err.find('B') != std::string::npos);
    }
}

TEST_CASE("lines of queries give lines of answers, and a bad line does not end the run") {
    const std::string input =
        "{\"a\": {\"circle\": {\"radius\": 1}}, \"b\": {\"circle\": {\"radius\": 0}}, \"b_pose\": {\"position\": [3, "
        "0]}}\n"
        "{\"a\": {\"circle\": {\"radius\": 1}}}\n"
        "\n"
        "nonsense\n"
        "{\"a\": {\"circle\": {\"radius\": 1}}, \"b\": {\"circle\": {\"radius\": 1}}, \"a_pose\": {\"position\": [0, "
        "9]}}\n";
    const Answer answer = Process(tumble_command({"distance", "--stdin"}), ".", input).wait();
    CHECK(answer.code == 3);
    std::vector<json> lines;
    std::istringstream text(answer.out);
    for (std::string line; std::getline(text, line);) lines.push_back(json::parse(line));
    REQUIRE(lines.size() == 4);
    CHECK(lines[0]["distance"] == 2);
    CHECK(lines[1]["line"] == 2);
    CHECK(lines[1].contains("error"));
    CHECK(lines[2]["line"] == 4);
    CHECK(lines[3]["distance"] == 7);
}

TEST_CASE("a query is answered before the next one is read") {
    const std::string script = R"(
coproc T { "$0" distance --stdin; }
for x in 3 4; do
    echo '{"a": {"circle": {"radius": 1}}, "b": {"circle": {"radius": 1}}, "b_pose": {"position": ['$x', 0]}}' >&"${T[1]}"
    read -r -t 20 -u "${T[0]}" answer || exit 1
    echo "$answer"
done)";
    const Answer answer = tumble::test::run({"bash", "-c", script, TUMBLE_BINARY});
    CHECK(answer.code == 0);
    CHECK(json::parse(answer.out.substr(0, answer.out.find('\n')))["distance"] == 1);
    CHECK(json::parse(answer.out.substr(answer.out.find('\n')))["distance"] == 2);
}

TEST_CASE("the extension of a trace selects picture or JSON, and an existing file is refused") {
    const tumble::test::Folder folder;
    const std::string box = R"({"box": {"size": [2, 1]}})",
                      turned = R"({"box": {"size": [2, 1]}, "pose": {"position": [4, 1], "angle": 30}})";
    const auto trace = [&](const std::string& file) {
        return run_tumble({"distance", box, turned, "--json", "--trace", (folder / file).string()});
    };
    REQUIRE(trace("t.json").code == 0);
    CHECK(trace("t.json").code == 4);
    const json document = json::parse(tumble::test::read_text(folder / "t.json"));
    REQUIRE(document["steps"].size() >= 1);
    CHECK(document["steps"].size() + 1 == document["result"]["iterations"]);  // the first support starts the first step
    const json& last = document["steps"].back();
    // Bounds on the distance of the cores, without radii.
    CHECK(last["lower"].get<double>() <= document["result"]["distance"].get<double>() * (1.0 + 1e-14));
    CHECK(last["upper"].get<double>() >= document["result"]["distance"].get<double>() * (1.0 - 1e-14));
    CHECK(document["result"]["distance"] == json::parse(trace("u.json").out)["distance"]);
    REQUIRE(trace("t.svg").code == 0);
    CHECK(tumble::test::read_text(folder / "t.svg").starts_with("<svg"));
    REQUIRE(trace("t.png").code == 0);
    CHECK(tumble::test::read_text(folder / "t.png")
              .starts_with("\x89"
                           "PNG"));
    CHECK(trace("t.png").code == 4);
    CHECK(trace("t.gif").code == 2);
    const auto pipe = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"distance", box, turned, "--trace", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_tumble(arguments);
    };
    const Answer piped = pipe({"--trace-format", "svg"});
    CHECK(piped.out == tumble::test::read_text(folder / "t.svg"));
    CHECK(piped.err.find("iterations") != std::string::npos);  // the answer
    CHECK(json::parse(pipe({"--trace-format", "json"}).out) == document);
    CHECK(pipe({"--trace-format", "png"}).out == tumble::test::read_text(folder / "t.png"));
    CHECK(pipe({}).code == 2);
    CHECK(pipe({"--trace-format", "gif"}).code == 2);
    CHECK(trace("t").code == 2);
}
