// The grammar of conditions, their values in states with known numbers, and their errors.
#include "tumble/scene_run.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "support/near.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;
using test::near, test::relative;

namespace {

// No gravity: every number of the first state is that of the file. The masses are 4 kg and 1 kg.
constexpr const char* kScene = R"({"format": 1, "world": {"gravity": [0, 0], "steps_per_second": 100}, "bodies": [
    {"name": "a", "position": [3, -2], "angle": 30, "velocity": [3, 4], "angular_velocity": 90,
     "shapes": [{"box": {"size": [2, 2]}}]},
    {"name": "b", "position": [10, 0], "shapes": [{"box": {"size": [1, 1]}}]},
    {"name": "car/wheel", "position": [20, 7], "shapes": [{"circle": {"radius": 1}}]},
    {"name": "crate", "position": [0, 50], "repeat": {"grid": {"columns": 4, "spacing": [3, 0]}},
     "shapes": [{"box": {"size": [1, 1]}}]},
    {"name": "wall", "type": "static", "position": [0, -20], "shapes": [{"box": {"size": [1, 1]}}]}],
  "joints": [{"type": "revolute", "name": "hinge", "bodies": ["wall", "b"], "anchor": [10, 0], "limits": [-90, 90]},
             {"type": "prismatic", "name": "rail", "bodies": ["wall", "crate[0]"], "anchor": [0, 50], "axis": [1, 0]}],
  "timeline": [{"at": 1, "spawn": {"name": "late", "position": [0, 90], "shapes": [{"circle": {"radius": 1}}]}},
               {"every": 0.5, "spawn": {"name": "drop", "position": [0, 99], "shapes": [{"circle": {"radius": 1}}]}}]})";

struct Example {
    Scene scene = parse_scene(kScene, "expressions");
    SceneRun run{scene};

    double value(const std::string& text, const SceneFrame& frame = {},
                 const std::vector<std::string>& names = {}) const {
        return Expression(text, scene, frame, names).value(run.built());
    }
};

struct Refused {
    std::size_t offset = 999;
    std::string message, hint;
};

Refused refused(const std::string& text) {
    const Scene scene = parse_scene(kScene, "expressions");
    try {
        const Expression expression(text, scene);
    } catch (const ExpressionError& error) {
        return {error.offset, error.what(), error.hint};
    }
    return {};
}

}  // namespace

TEST_CASE("operators bind as in mathematics") {
    const Example at;
    CHECK(at.value("1 + 2 * 3") == 7.0);
    CHECK(at.value("(1 + 2) * 3") == 9.0);
    CHECK(at.value("7 - 2 - 1") == 4.0);
    CHECK(at.value("8 / 2 / 2") == 2.0);
    CHECK(at.value("-3 ^ 2") == -9.0);
    CHECK(at.value("2 ^ -2") == 0.25);
    CHECK(at.value("--3") == 3.0);
    CHECK(at.value("2 * -3") == -6.0);
    CHECK(at.value(".5e1") == 5.0);
    CHECK(at.value("1 < 2 and 2 < 1 or 3 == 3") == 1.0);
    CHECK(at.value("1 < 2 and (2 < 1 or 3 != 3)") == 0.0);
    CHECK(at.value("not 1 < 2 or true") == 1.0);
    CHECK(at.value("not (1 < 2 or true)") == 0.0);
    CHECK(at.value("1 < 2 < 3") == 1.0);
    CHECK(at.value("1 < 3 < 3") == 0.0);
    CHECK(at.value("3 >= 3 > 2 > 2.5") == 0.0);
    CHECK(at.value("(1 < 2) == (4 > 3)") == 1.0);
}

TEST_CASE("functions have their exact values, of degrees") {
    const Example at;
    CHECK(at.value("sin(90) + cos(180) + tan(0)") == 0.0);
    CHECK(near(at.value("sin(30)"), 0.5, relative(1e-15)));
    CHECK(near(at.value("atan2(1, 0)"), 90.0, relative(1e-15)));
    CHECK(at.value("hypot(3, 4) + abs(-2) + sqrt(16)") == 11.0);
    CHECK(at.value("floor(-1.5) + ceil(1.5)") == 0.0);
    CHECK(at.value("mod(370, 360)") == 10.0);
    CHECK(at.value("min(3, 1, 2) + max(3, 1, 2)") == 4.0);
    CHECK(at.value("if(1 < 2, 5, 6) + if(1 > 2, 50, 60)") == 65.0);
}

TEST_CASE("exp, sign and clamp have their values") {
    const Example at;
    CHECK(at.value("exp(0)") == 1.0);
    CHECK(at.value("exp(1000)") == std::numeric_limits<double>::infinity());
    CHECK(at.value("exp(-1000)") == 0.0);
    for (int i = -700; i <= 700; i += 7) {
        const double x = i + 0.3;
        CHECK(near(at.value("exp(" + std::to_string(i) + " + 0.3)"), std::exp(x), relative(5e-16)));
    }
    CHECK(at.value("sign(-2) + 10 * sign(0) + 100 * sign(3)") == 99.0);
    CHECK(at.value("clamp(5, -1, 1) + 10 * clamp(-5, -1, 1) + 100 * clamp(0.5, -1, 1)") == 41.0);
    CHECK(std::isnan(at.value("sign(gone)", {}, {{"gone"}})));
    CHECK(std::isnan(at.value("clamp(1, gone, 2)", {}, {{"gone"}})));
}

TEST_CASE("a program gives numbers of its own") {
    const Example at;
    const std::vector<std::string> names{"x", "reward so far", "a"};
    const std::vector<double> values{2.5, 7.0, 100.0};
    const Expression sum("x + 'reward so far' + a + a.x", at.scene, {}, names);  // a.x is that of the body: 3
    CHECK(sum.value(at.run.built(), values) == 112.5);
    CHECK(std::isnan(sum.value(at.run.built())));
    CHECK_THROWS_AS(Expression("x", at.scene), ExpressionError);
    for (const std::string word : {"time", "or", "true", "not"}) {
        const std::vector<std::string> hidden{word};
        CHECK_THROWS_AS(Expression("1", at.scene, {}, hidden), ExpressionError);
    }
    try {
        const Expression misspelt("rewrad", at.scene, {}, std::vector<std::string>{"reward"});
    } catch (const ExpressionError& error) {
        CHECK(error.hint == "did you mean 'reward'?");
    }
}

TEST_CASE("the value in another world is that of a world loaded from a snapshot") {
    Example at;
    const Expression x("a.x + hinge.angle", at.scene);
    World copy = World::load(at.run.world().save());
    const double before = x.value(at.run.built());
    copy.set_transform(at.run.built().bodies[0].id, {{8.0, -2.0}, {}});
    CHECK(x.value(copy, at.run.built(), {}) == before + 5.0);
    CHECK(x.value(at.run.built()) == before);
}

TEST_CASE("bodies, joints and the world have the values of the state") {
    const Example at;
    CHECK(at.value("a.x + a.y") == 1.0);
    CHECK(near(at.value("a.angle"), 30.0, relative(1e-6)));
    CHECK(at.value("a.vx") == 3.0);
    CHECK(at.value("a.vy") == 4.0);
    CHECK(at.value("a.speed") == 5.0);
    CHECK(near(at.value("a.spin"), 90.0, relative(1e-6)));
    CHECK(at.value("a.mass") == 4.0);
    CHECK(at.value("a.awake and a.exists and not late.exists") == 1.0);
    CHECK(at.value("'car/wheel'.x") == 20.0);
    CHECK(at.value("crate[2].x") == 6.0);
    CHECK(at.value("time + step + work") == 0.0);
    CHECK(at.value("momentum_x") == 12.0);
    CHECK(at.value("momentum_y") == 16.0);
    const double turn = 3.14159265358979 / 2.0, inertia = 4.0 * (4.0 + 4.0) / 12.0;
    CHECK(near(at.value("kinetic"), 50.0 + 0.5 * inertia * turn * turn, relative(1e-6)));
    CHECK(at.value("energy - kinetic - potential") == 0.0);
    CHECK(at.value("bodies") == 9.0 - 1.0);
    CHECK(at.value("hinge.exists") == 1.0);
    CHECK(std::abs(at.value("hinge.angle")) < 1e-6);
    CHECK(at.value("rail.translation") == 0.0);
    CHECK(near(at.value("distance(crate[0], crate[1])"), 2.0, relative(1e-6)));
    CHECK(at.value("touching(a, b)") == 0.0);
    CHECK(at.value("inside(a, 2, -3, 4, 0)") == 1.0);
    CHECK(at.value("inside(a, 2, -1, 4, 0)") == 0.0);
}

TEST_CASE("positions, angles and velocities are those of the frame") {
    const Example at;
    const SceneFrame frame{{1.0, -2.0}, 90.0};
    CHECK(at.value("a.x", frame) == 0.0);
    CHECK(at.value("a.y", frame) == -2.0);
    CHECK(at.value("a.vx", frame) == 4.0);
    CHECK(at.value("a.vy", frame) == -3.0);
    CHECK(near(at.value("a.angle", frame), -60.0, relative(1e-6)));
    CHECK(at.value("a.speed", frame) == 5.0);
    CHECK(at.value("inside(a, -1, -3, 1, -1)", frame) == 1.0);
}

TEST_CASE("functions about copies go through those that exist") {
    const Example at;
    CHECK(at.value("max(crate.x)") == 9.0);
    CHECK(at.value("min(crate.x)") == 0.0);
    CHECK(at.value("sum(crate.mass)") == 4.0);
    CHECK(at.value("count(crate.x > 1)") == 3.0);
    CHECK(at.value("all(crate.y == 50)") == 1.0);
    CHECK(at.value("any(crate.x > 9)") == 0.0);
    CHECK(at.value("all(min(crate.x, 5) <= 5)") == 1.0);
    CHECK(at.value("distance(a, crate) > 40") == 1.0);
    CHECK(at.value("count(distance(crate, b) < 49.5)") == 3.0);
}

TEST_CASE("functions about copies go through the copies of a joint that exist") {
    // The anchors are 1 m apart on the wall, and the balls 1.125 m: the gap of hinge i is i / 8 m.
    const Scene scene = parse_scene(R"({"format": 1, "world": {"gravity": [0, 0]}, "bodies": [
        {"name": "wall", "type": "static"},
        {"name": "ball", "repeat": {"grid": {"columns": 4, "spacing": [1.125, 0]}},
         "shapes": [{"circle": {"radius": 0.25}}]}],
      "joints": [{"type": "revolute", "name": "hinge", "bodies": ["wall", "ball[0]"], "anchors": [[0, 0], [0, 0]],
                  "repeat": {"columns": 4, "spacing": [1, 0]}}],
      "timeline": [{"at": 0, "release": "hinge[3]"}]})",
                                    "hinges");
    SceneRun run(scene);
    const SceneWorld whole = build_world(scene);
    const auto value = [&](const char* text) { return Expression(text, scene).value(whole); };
    CHECK(value("hinge[2].gap") == 0.25);
    CHECK(value("max(hinge.gap)") == 0.375);
    CHECK(value("sum(hinge.gap)") == 0.75);
    CHECK(value("count(hinge.gap > 0.1)") == 3.0);
    CHECK(value("all(hinge.gap < 0.25)") == 0.0);
    CHECK(value("any(hinge.gap > 0.25 and hinge.exists)") == 1.0);
    const Expression all("all(hinge.gap < 0.25)", scene);
    CHECK(all.shortfall(whole) == 0.125);
    CHECK(all.finding(whole) == "all(hinge.gap < 0.25) is false, of 'hinge[2]' hinge.gap is 0.25");
    const auto finding = [&](const SceneWorld& built) {
        return Expression("max(sqrt(-1 - hinge.gap)) > 0", scene).finding(built);
    };
    CHECK(finding(whole) == "max(sqrt(-1 - hinge.gap)) is unknown");  // the joints exist, the root does not
    run.step();
    CHECK(Expression("count(hinge.exists)", scene).value(run.built()) == 3.0);
    while (!run.world().joints().empty()) run.world().destroy_joint(run.world().joints().front());
    CHECK(finding(run.built()) == "'hinge' does not exist");
    const auto hint_of = [&](const char* text) {
        try {
            const Expression refused(text, scene);
        } catch (const ExpressionError& error) {
            return std::string(error.what()) + "; " + error.hint;
        }
        return std::string();
    };
    CHECK(hint_of("hinge.gap < 1") ==
          "'hinge' stands for several copies; name one, hinge[0].gap, or all of them: all(hinge.gap > 0), "
          "any(hinge.gap > 0), max(hinge.gap)");
    CHECK(hint_of("hinge.exists") ==
          "'hinge' stands for several copies; name one, hinge[0].exists, or all of them: all(hinge.exists), "
          "any(hinge.exists), count(hinge.exists)");
    CHECK(hint_of("max(hinge.gap, 1) < 1") ==
          "'hinge' stands for several copies; max(hinge.gap) with one argument is that of all copies");
    CHECK(hint_of("all(hinge.gap < 1 and ball.x > 1)") ==
          "a function about copies takes the copies of one body or joint: 'hinge' and 'ball' are two; ");
    CHECK(hint_of("all(hinge)") == "the joint 'hinge' alone is no value; ask for a property: hinge.force");
}

TEST_CASE("what is about a body that does not exist is unknown, and an unknown condition does not hold") {
    Example at;
    CHECK(std::isnan(at.value("late.x")));
    CHECK(std::isnan(at.value("late.x < 5")));
    CHECK(std::isnan(at.value("not late.x < 5")));
    CHECK(at.value("late.x < 5 or true") == 1.0);
    CHECK(at.value("late.x < 5 and false") == 0.0);
    CHECK(std::isnan(at.value("late.x < 5 and true")));
    CHECK(std::isnan(at.value("max(drop.y)")));
    CHECK(std::isnan(at.value("all(drop.y > 0)")));
    CHECK(at.value("any(drop.y > 0)") == 0.0);
    CHECK(at.value("count(drop.y > 0)") == 0.0);
    const Expression condition("late.y > 80", at.scene);
    CHECK_FALSE(condition.holds(at.run.built()));
    CHECK(condition.shortfall(at.run.built()) == std::numeric_limits<double>::infinity());
    CHECK(condition.finding(at.run.built()) == "'late' does not exist");
    while (at.run.world().step_count() < 101) at.run.step();
    CHECK(condition.holds(at.run.built()));
    CHECK(at.value("late.y") == 90.0);
    CHECK(at.value("count(drop.y > 0)") == 3.0);
    CHECK(at.value("min(drop.y)") == 99.0);
    CHECK(at.value("drop[1].exists and not drop[3].exists") == 1.0);
}

TEST_CASE("a shortfall is how far a condition is from holding") {
    const Example at;
    const auto shortfall = [&](const char* text) { return Expression(text, at.scene).shortfall(at.run.built()); };
    CHECK(shortfall("a.x > 5") == 2.0);
    CHECK(shortfall("a.x < 5") == -2.0);
    CHECK(shortfall("a.x > 5 and b.x > 20") == 10.0);
    CHECK(shortfall("a.x > 5 or b.x > 20") == 2.0);
    CHECK(shortfall("not (a.x < 5 or b.x < 20)") == 10.0);
    CHECK(shortfall("a.x == 4") == 1.0);
    CHECK(shortfall("a.x < 3") > 0.0);
    CHECK(shortfall("a.x <= 3") == 0.0);
    CHECK(shortfall("all(crate.x < 5)") == 4.0);
    CHECK(shortfall("any(crate.x > 10)") == 1.0);
}

TEST_CASE("a finding lists the values of an expression") {
    const Example at;
    const auto finding = [&](const char* text) { return Expression(text, at.scene).finding(at.run.built()); };
    CHECK(finding("a.x < b.x - 1 and a.x > 0") == "a.x is 3, b.x is 10");
    CHECK(finding("touching(a, b) or energy < 0 and time > 1") ==
          "touching(a, b) is false, energy is " + std::string("53.3") + ", time is 0");
    CHECK(finding("all(crate.x < 5)") == "all(crate.x < 5) is false, of 'crate[2]' crate.x is 6");
}

TEST_CASE("an error has its place in the text, a reason and a hint") {
    CHECK(refused("bb.x > 1").offset == 0);
    CHECK(refused("1 + ad.x").offset == 4);
    CHECK(refused("1 + ad.x").message == "there is no body or joint 'ad'");
    CHECK(refused("hinje.angle > 1").hint == "did you mean 'hinge'?");
    CHECK(refused("a.velocity > 1").offset == 2);
    CHECK(refused("a.spinn > 1").hint == "did you mean 'spin'?");
    CHECK(refused("rail.angle > 1").message == "the joint 'rail' has no angle");
    CHECK(refused("a > 1").hint == "ask for a property: a.x");
    CHECK(refused("car.x > 1").hint == "a name with other signs than letters, digits and _ is quoted: 'car/wheel'");
    CHECK(refused("crate.x > 1").message == "'crate' stands for several copies");
    CHECK(refused("crate.x > 1").hint ==
          "name one, crate[0].x, or all of them: all(crate.x > 0), any(crate.x > 0), max(crate.x)");
    CHECK(refused("a.x && b.x").hint == "write 'and'");
    CHECK(refused("a.x = 1").hint == "a comparison is written ==");
    CHECK(refused("a.x and true").hint == "compare it: a.x > 0");
    CHECK(refused("1 + true").message == "'+' needs a number; 'true' is a condition");
    CHECK(refused("root(2)").message == "there is no function 'root'");
    CHECK(refused("sqrt(2, 3)").message == "too many arguments");
    CHECK(refused("distance(a)").offset == 10);
    CHECK(refused("distance(a, 1)").offset == 12);
    CHECK(refused("all(a.x > 1)").message == "'all' needs the common name of copies");
    CHECK(refused("max(a.x)").hint ==
          "a body or joint without a \"repeat\" has no copies: write a.x without the function");
    CHECK(refused("count(a.x > 1) > 0").hint ==
          "a body or joint without a \"repeat\" has no copies: write if(a.x > 1, 1, 0) without the function");
    CHECK(refused("t > 1").hint == "did you mean 'time'?");
    CHECK(refused("all(any(crate.x > 1))").offset == 4);
    CHECK(refused("max(crate.x, 1)").message == "'crate' stands for several copies");
    CHECK(refused("max(crate.x, 1)").hint == "max(crate.x) with one argument is that of all copies");
    CHECK(refused("max(1, distance(crate, a))").hint ==
          "max(distance(crate, a)) with one argument is that of all copies");
    CHECK(refused("2 ^ 0.5").hint == "sqrt(2) is the square root");
    CHECK(refused("1 +").message == "expected a value, got the end");
    CHECK(refused("(1 + 2").message == "expected ')', got the end");
    CHECK(refused("1 2").offset == 2);
    CHECK(refused("").offset == 0);
    CHECK(refused("a.x > 'b").offset == 6);
    CHECK(refused("1e999").message == "the number is outside the range of a double");
    CHECK(refused("tiem > 3").hint == "did you mean 'time'?");
    CHECK(refused("a.velocity.x > 1").hint == "this grammar has vx, vy or speed");
    CHECK(refused("a.position[0] > 1").hint == "this grammar has x or y");
    CHECK(refused("a hits 'car/wheel'").hint == "write touching(a, 'car/wheel')");
    CHECK(refused("crate touches wall").hint == "write touching(crate, wall)");
    CHECK(refused("a hits nothing").hint == "ask for a property: a.x");
}

TEST_CASE("hostile expressions are refused within limits") {
    CHECK(refused(std::string(900, '(') + "1").message == "the expression is nested deeper than 50 levels");
    CHECK(refused(std::string(900, '-') + "1").message == "the expression is nested deeper than 50 levels");
    CHECK(refused(std::string(2001, ' ')).message == "an expression has at most 2000 bytes");
    const Example at;
    std::string sum = "0";
    for (int i = 0; i < 900; ++i) sum += "+1";
    CHECK(at.value(sum) == 900.0);
}
