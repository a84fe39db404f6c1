// `tumble diff` of states and hashes, mostly on hand-written files.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

#include "diff_answer.hpp"
#include "process.hpp"
#include "support/near.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::compare;
using tumble::test::Folder;
using tumble::test::near;
using tumble::test::relative;
using tumble::test::run_tumble;

namespace {

constexpr const char* kHeader = "step,time,body,x,y,angle,vx,vy,omega\n";

}  // namespace

TEST_CASE("diff names the first step, body and component that differ, with the difference and its ulps") {
    const Folder folder;
    const std::string start = std::string(kHeader) + "0,0,ball,1,2,0,0,0,0\n0,0,\"a, b\",0,0,0,0,0,0\n";
    const std::string a = folder.write("a.csv", start + "1,0.5,ball,1,2,0,0.25,0,0\n1,0.5,\"a, b\",1,0,0,0,0,0\n");
    // The double after 1 is 1 + 2^-52; the float after 0.25 is 0.25 + 2^-25.
    const std::string b =
        folder.write("b.csv", start + "1,0.5,ball,1,2,0,0.25,0,0\n1,0.5,\"a, b\",1.0000000000000002,0,0,0,0,0\n");
    const std::string c =
        folder.write("c.csv", start + "1,0.5,ball,1,2,0,0.25000003,0,0\n1,0.5,\"a, b\",2,0,0,0,0,0\n");
    CHECK(run_tumble({"diff", a, a}).code == 0);
    const Answer near = run_tumble({"diff", a, b, "--json"});
    CHECK(near.code == 7);
    const json first = compare(near)["first"];
    CHECK(first["step"] == 1);
    CHECK(first["time"] == 0.5);
    CHECK(first["body"] == "a, b");
    CHECK(first["component"] == "x");
    CHECK(first["ulps"] == 1);
    CHECK(first["apart"] == 0x1p-52);
    CHECK(first["differing_bodies"] == 1);
    const json float_component = compare(run_tumble({"diff", a, c, "--json"}))["first"];
    CHECK(float_component["component"] == "vx");
    CHECK(float_component["ulps"] == 1);
    CHECK(float_component["apart"] == 0x1p-25);
    CHECK(float_component["differing_bodies"] == 2);
    CHECK(run_tumble({"diff", a, b, "--tolerance", "1e-15"}).code == 0);
    CHECK(run_tumble({"diff", a, c, "--tolerance", "0.5"}).code == 7);
}

TEST_CASE("diff finds the largest difference of each kind, and of angles along the shorter arc") {
    const Folder folder;
    const std::string a = folder.write(
        "a.csv", std::string(kHeader) + "0,0,ball,1,2,3.14,0,0,0\n1,0.5,ball,1,2,0,0,0,0\n2,1,ball,1,2,0,0,0,7\n");
    const std::string b = folder.write(
        "b.csv", std::string(kHeader) + "0,0,ball,1,2,-3.14,0,0,0\n1,0.5,ball,1.5,2,0,0,0,0\n2,1,ball,1,4,0,0,0,9\n");
    const json found = compare(run_tumble({"diff", a, b, "--json"}));
    CHECK(found["first"]["step"] == 0);
    CHECK(near(found["first"]["apart"].get<double>(), 2.0 * 3.14159265358979 - 6.28, relative(1e-11)));
    CHECK(found["largest"][0]["of"] == "position");
    CHECK(found["largest"][0]["apart"] == 2.0);
    CHECK(found["largest"][0]["step"] == 2);
    CHECK(found["largest"][3]["apart"] == 2.0);
    CHECK(run_tumble({"diff", a, b, "--tolerance", "0.4"}).out.find("at step 1 (0.5 s)") != std::string::npos);
    CHECK(run_tumble({"diff", a, b, "--tolerance", "2"}).code == 0);
}

TEST_CASE("diff compares two lists of hashes, and a scene with a changed value") {
    const Folder folder;
    const std::string a = folder.write("a.csv", "step,hash\n0,00000000000000aa\n1,00000000000000bb\n"),
                      longer = folder.write("c.csv", "step,hash\n0,00000000000000aa\n1,00000000000000bb\n2,1\n");
    const std::string b = folder.write("b.csv", "step,hash\n0,00000000000000aa\n1,00000000000000bc\n");
    CHECK(run_tumble({"diff", a, a}).code == 0);
    const Answer differs = run_tumble({"diff", a, b});
    CHECK(differs.code == 7);
    CHECK(differs.out == "the first difference is at step 1: the hashes are 00000000000000bb and 00000000000000bc\n");
    CHECK(compare(run_tumble({"diff", a, longer, "--json"}))["first"]["hash_a"] == "none");
    const std::string scene = folder.write(
        "s.json",
        R"({"format": 1, "world": {"duration": 0.1}, "bodies": [{"name": "ball", "shapes": [{"circle": {"radius": 1}}]}]})");
    CHECK(run_tumble({"diff", scene, scene}).code == 0);
    CHECK(compare(run_tumble({"diff", scene, scene, "--set", "/world/gravity/1=-9", "--json"}))["first"]["component"] ==
          "y");
    CHECK(run_tumble({"diff", scene, a, "--set", "/world/gravity/1=-9"}).code == 2);
    const std::string scattered = folder.write(
        "t.json",
        R"({"format": 1, "world": {"duration": 0.1}, "bodies": [{"name": "ball", "repeat": {"scatter": {"count": 3, "size": [4, 4]}}}]})");
    CHECK(run_tumble({"diff", scattered, scattered, "--seed", "1"}).code == 0);  // the default
    CHECK(run_tumble({"diff", scattered, scattered, "--seed", "2"}).code == 7);
    CHECK(run_tumble({"diff", scattered, a, "--seed", "2"}).code == 2);
    CHECK(run_tumble({"diff", a, a, "--tolerance", "1"}).err.find("--tolerance has no effect") != std::string::npos);
}

TEST_CASE("diff and compare accept paths out of the folder in both scenes with --allow-outside") {
    const Folder folder;
    std::filesystem::create_directory(folder / "levels");
    folder.write("ball.json", R"({"format": 1, "bodies": [{"name": "ball", "shapes": [{"circle": {"radius": 1}}]}]})");
    const std::string level = folder.write(
        "levels/level.json", R"({"format": 1, "world": {"duration": 0.1}, "include": [{"file": "../ball.json"}]})");
    CHECK(run_tumble({"diff", level, level}).code == 3);
    CHECK(run_tumble({"diff", level, level, "--allow-outside"}).code == 0);
    CHECK(run_tumble({"compare", level, level, "--allow-outside", "--csv", (folder / "apart.csv").string()}).code == 0);
}

TEST_CASE("a run that ends early or has other bodies differs") {
    const Folder folder;
    const std::string line = "0,0,ball,1,2,0,0,0,0\n";
    const std::string a = folder.write("a.csv", kHeader + line + "1,0.5,ball,1,2,0,0,0,0\n");
    const std::string shorter = folder.write("b.csv", kHeader + line);
    const std::string renamed =
        folder.write("c.csv", std::string(kHeader) + "0,0,box,1,2,0,0,0,0\n1,0.5,box,1,2,0,0,0,0\n");
    const Answer ended = run_tumble({"diff", a, shorter});
    CHECK(ended.code == 7);
    CHECK(ended.out.find("step 1 (0.5 s): B ends before this step") != std::string::npos);
    const Answer other = run_tumble({"diff", a, renamed});
    CHECK(other.code == 7);
    CHECK(other.out ==
          "added, only B has: 'box'\nremoved, only A has: 'ball'\n"
          "equal bit for bit: 2 steps of 0 bodies that both have\n");
}

TEST_CASE("a scene with one body inserted differs from itself by that body") {
    const Folder folder;
    const std::string before = R"({"format": 1, "world": {"duration": 0.5}, "bodies": [
        {"name": "floor", "type": "static", "shapes": [{"box": {"size": [10, 1]}}]},)",
                      after = R"({"name": "crate", "position": [0, 1], "repeat": {"grid": {"rows": 3}}, "shapes": [
        {"box": {"size": [1, 1]}}]}, {"position": [3, 2], "shapes": [{"circle": {"radius": 0.5}}]}]})";
    const std::string inserted = R"({"name": "new", "position": [-40, 9], "shapes": [{"circle": {"radius": 0.5}}]},)",
                      nameless = R"({"position": [-40, 9], "shapes": [{"circle": {"radius": 0.5}}]},)";
    const std::string a = folder.write("a.json", before + after), b = folder.write("b.json", before + inserted + after),
                      c = folder.write("c.json", before + nameless + after);

    const Answer added = run_tumble({"diff", a, b});
    CHECK(added.code == 7);
    CHECK(added.out == "added, only B has: 'new'\nequal bit for bit: 31 steps of 5 bodies that both have\n");
    CHECK(run_tumble({"diff", b, a}).out ==
          "removed, only A has: 'new'\nequal bit for bit: 31 steps of 5 bodies that both have\n");
    const json document = compare(run_tumble({"diff", a, b, "--json"}));
    CHECK(document["equal"] == false);
    CHECK(document["added"] == json{"new"});
    CHECK(document["removed"].empty());
    CHECK(document["renamed"].empty());
    CHECK(!document.contains("first"));

    // The body without a name was the fifth and is now the sixth; 'body[1]' is the inserted one.
    CHECK(run_tumble({"diff", a, c}).out ==
          "added, only B has: 'body[1]'\nequal bit for bit: 31 steps of 5 bodies that both have\n");
    const auto trajectory = [&](const std::string& scene, const std::string& name) {
        std::string run = (folder / name).string();
        REQUIRE(run_tumble({"run", scene, "--no-frames", "-o", run, "--trajectory", run + "/trajectory.csv"}).code ==
                0);
        return run;
    };
    CHECK(run_tumble({"diff", trajectory(a, "run_a"), trajectory(c, "run_c")}).out == run_tumble({"diff", a, c}).out);
    CHECK(run_tumble({"diff", (folder / "run_a").string(), c}).out == run_tumble({"diff", a, c}).out);

    // The common bodies part too, and diff says by how much.
    const json moved = compare(run_tumble({"diff", a, b, "--set", "/bodies/crate/position/1=1.5", "--json"}));
    CHECK(moved["added"] == json{"new"});
    CHECK(moved["first"]["body"] == "crate[0]");
    CHECK(moved["first"]["apart"] == 0.5);
    CHECK(moved["first"]["differing_bodies"] == 3);
}

TEST_CASE("a body without a name is paired by shapes and pose, and is renamed if the other run has a name for it") {
    const Folder folder;
    const auto scene = [&](const std::string& file, const std::string& name, const std::string& radius) {
        return folder.write(file, R"({"format": 1, "world": {"duration": 0.1}, "bodies": [
            {"name": "other", "position": [5, 0], "shapes": [{"circle": {"radius": 1}}]},
            {)" + name + R"("shapes": [{"circle": {"radius": )" +
                                      radius + "}}]}]}");
    };
    const std::string ball = scene("ball.json", R"("name": "ball", )", "1"), none = scene("none.json", "", "1"),
                      box = scene("box.json", R"("name": "box", )", "1"), larger = scene("larger.json", "", "2");
    const Answer renamed = run_tumble({"diff", none, ball});
    CHECK(renamed.code == 7);
    CHECK(renamed.out == "renamed: 'body[1]' to 'ball'\nequal bit for bit: 7 steps of 2 bodies that both have\n");
    CHECK(run_tumble({"diff", ball, none}).out ==
          "renamed: 'ball' to 'body[1]'\nequal bit for bit: 7 steps of 2 bodies that both have\n");
    CHECK(compare(run_tumble({"diff", none, ball, "--json"}))["renamed"] ==
          json::parse(R"([{"a": "body[1]", "b": "ball"}])"));
    const json parted = compare(run_tumble({"diff", none, ball, "--set", "/bodies/ball/gravity_scale=0", "--json"}));
    CHECK(parted["first"]["body"] == "body[1]");
    CHECK(parted["first"]["body_b"] == "ball");
    // Both scenes declare a name, so that each body is one of its own.
    const Answer declared = run_tumble({"diff", ball, box});
    CHECK(declared.code == 7);
    CHECK(declared.out ==
          "added, only B has: 'box'\nremoved, only A has: 'ball'\n"
          "equal bit for bit: 7 steps of 1 body that both have\n");
    const json replaced = compare(run_tumble({"diff", ball, larger, "--json"}));  // in the same place
    CHECK(replaced["renamed"].empty());
    CHECK(replaced["added"] == json{"body[1]"});
    CHECK(replaced["removed"] == json{"ball"});
}

TEST_CASE("a body that appears later in one run, or is gone earlier, differs in that step") {
    const Folder folder;
    const std::string ball = "ball,1,2,0,0,0,0\n", drop = "drop,5,5,0,0,0,0\n";
    const std::string a = folder.write(
        "a.csv", kHeader + ("0,0," + ball) + "1,0.5," + ball + "1,0.5," + drop + "2,1," + ball + "2,1," + drop);
    const std::string late =
        folder.write("late.csv", kHeader + ("0,0," + ball) + "1,0.5," + ball + "2,1," + drop + "2,1," + ball);
    const json first = compare(run_tumble({"diff", a, late, "--json"}));
    CHECK(first["added"].empty());
    CHECK(first["first"]["step"] == 1);
    CHECK(first["first"]["body"] == "drop");
    CHECK(first["first"]["what"] == "in this step only A has the body");
    CHECK(first["equal_steps"] == 1);
    const std::string gone =
        folder.write("gone.csv", kHeader + ("0,0," + ball) + "1,0.5," + ball + "1,0.5," + drop + "2,1," + ball);
    const Answer left = run_tumble({"diff", gone, a});
    CHECK(left.out.find("at step 2 (1 s), body 'drop': in this step only B has the body") != std::string::npos);
    // Rows in another order are no difference.
    const std::string turned = folder.write(
        "turned.csv", kHeader + ("0,0," + ball) + "1,0.5," + drop + "1,0.5," + ball + "2,1," + drop + "2,1," + ball);
    CHECK(run_tumble({"diff", a, turned}).code == 0);
}

TEST_CASE("a long list of names is cut in the text and whole in JSON") {
    const Folder folder;
    const std::string row = "0,0,ball,1,2,0,0,0,0\n";
    std::string many = kHeader + row;
    for (int i = 0; i < 12; ++i) many += "0,0,new" + std::to_string(i) + "," + std::to_string(i) + ",0,0,0,0,0\n";
    const std::string a = folder.write("a.csv", kHeader + row), b = folder.write("b.csv", many);
    CHECK(run_tumble({"diff", a, b}).out.find("'new9' and 2 more\n") != std::string::npos);
    CHECK(compare(run_tumble({"diff", a, b, "--json"}))["added"].size() == 12);
}

TEST_CASE("a scene agrees with its own trajectory, and diff lists the contacts of a difference") {
    const Folder folder;
    const std::string scene = folder.write("ball.json", R"({"format": 1, "world": {"duration": 0.5}, "bodies": [
        {"name": "ground", "type": "static", "shapes": [{"box": {"size": [10, 1]}}]},
        {"name": "ball", "position": [0, 0.99], "shapes": [{"circle": {"radius": 0.5}}]}]})");
    const std::string run = (folder / "run").string();
    REQUIRE(run_tumble({"run", scene, "--no-frames", "-o", run, "--trajectory", run + "/trajectory.csv"}).code == 0);
    CHECK(run_tumble({"diff", run, scene}).code == 0);
    REQUIRE(run_tumble({"run", scene, "--no-frames", "--force", "-o", run, "--trajectory", run + "/moved.csv", "--set",
                        "/bodies/1/position=[0, 0.98]"})
                .code == 0);
    const json first = compare(run_tumble({"diff", scene, run + "/moved.csv", "--json"}))["first"];
    CHECK(first["step"] == 0);
    CHECK(first["body"] == "ball");
    const std::string wider = folder.write("wider.json", R"({"format": 1, "world": {"duration": 0.5}, "bodies": [
        {"name": "ground", "type": "static", "shapes": [{"box": {"size": [10, 1.01]}}]},
        {"name": "ball", "position": [0, 0.99], "shapes": [{"circle": {"radius": 0.5}}]}]})");
    const json touching = compare(run_tumble({"diff", scene, wider, "--json"}))["first"];
    CHECK(touching["step"] == 1);
    REQUIRE(touching["contacts_a"].size() == 1);
    CHECK(touching["contacts_a"][0].get<std::string>().find("ball") != std::string::npos);
}

TEST_CASE("an invalid trajectory is refused with file and line") {
    const Folder folder;
    const std::string good = folder.write("a.csv", std::string(kHeader) + "0,0,ball,1,2,0,0,0,0\n");
    const auto refuse = [&](const std::string& text) {
        const Answer answer = run_tumble({"diff", good, folder.write("bad.csv", text)});
        CHECK(answer.code == 3);
        return answer.err;
    };
    CHECK(refuse("step,time\n0,0\n").find("bad.csv:1: missing column") != std::string::npos);
    CHECK(refuse(std::string(kHeader) + "0,0,ball,1,2,0\n").find("bad.csv:2: too few columns") != std::string::npos);
    CHECK(refuse(std::string(kHeader) + "0,0,ball,1,two,0,0,0,0\n").find("bad.csv:2: expected a number, got 'two'") !=
          std::string::npos);
    CHECK(refuse("").size() > 10);
    CHECK(run_tumble({"diff", good, (folder / "none.csv").string()}).code == 4);
    CHECK(run_tumble({"diff", good}).code == 2);
}
