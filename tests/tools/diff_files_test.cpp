// `tumble diff` of events, summaries and frames.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "diff_answer.hpp"
#include "process.hpp"
#include "tumble/file.hpp"
#include "tumble/render.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::compare;
using tumble::test::Folder;
using tumble::test::run_tumble;

TEST_CASE("diff compares events by step, kind and names, whatever their order in a step") {
    const Folder folder;
    const std::string header = "step,time,event,a,b,x,y,nx,ny,speed\n";
    const std::string hit = "2,1,contact_begin,ball,floor,1,0,0,1,", end = "2,1,contact_end,ball,wall,,,,,\n",
                      sleep = "5,2.5,fell_asleep,ball,,,,,,\n";
    const std::string a = folder.write("a.csv", header + hit + "3.5\n" + end + sleep);
    const auto diff = [&](const std::string& text) {
        return run_tumble({"diff", a, folder.write("b.csv", header + text), "--json"});
    };
    const Answer turned = diff(end + hit + "3.5\n" + sleep);
    CHECK(turned.code == 0);
    CHECK(compare(turned)["common"] == 3);

    const Answer faster = diff(hit + "3.75\n" + end + sleep);
    CHECK(faster.code == 7);
    CHECK(compare(faster)["first"]["component"] == "speed");
    CHECK(compare(faster)["first"]["in_b"] == "3.75");
    CHECK(run_tumble({"diff", a, (folder / "b.csv").string(), "--tolerance", "0.25"}).code == 0);
    CHECK(run_tumble({"diff", a, (folder / "b.csv").string(), "--tolerance", "0.24"}).code == 7);

    // The sleep comes a step later: one event of each that the other does not have.
    const json later = compare(diff(hit + "3.5\n" + end + "6,3,fell_asleep,ball,,,,,,\n"));
    CHECK(later["common"] == 2);
    CHECK(later["only_a"] == 1);
    CHECK(later["only_b"] == 1);
    CHECK(later["first"]["step"] == 5);
    CHECK(later["first"]["what"] == "only A has it");
    CHECK(run_tumble({"diff", a, (folder / "b.csv").string()})
              .out.starts_with("the first difference is at step 5 (2.5 s): fell_asleep of 'ball': only A has it\n"));
    CHECK(run_tumble({"diff", a, folder.write("bad.csv", header + "x\n")}).code == 3);
    const Answer kinds = run_tumble({"diff", a, folder.write("h.csv", "step,hash\n0,1\n")});
    CHECK(kinds.code == 2);
    CHECK(kinds.err.find("only two of a kind") != std::string::npos);
}

TEST_CASE("events of equal kind and names in one step have no order") {
    const Folder folder;
    const std::string header = "step,time,event,a,b,x,y,nx,ny,speed\n", hit = "2,1,contact_begin,ball,floor,";
    const auto diff = [&](const std::string& a, const std::string& b, const std::string& tolerance) {
        return run_tumble({"diff", folder.write("a.csv", header + a), folder.write("b.csv", header + b), "--tolerance",
                           tolerance, "--json"});
    };
    const std::string left = hit + "1,0,0,1,3\n", middle = hit + "2,0,0,1,3\n", right = hit + "3,0,0,1,3\n";
    CHECK(diff(left + middle + right, right + left + middle, "0").code == 0);
    CHECK(compare(diff(left + left + right, right + left, "0"))["only_a"] == 1);
    // Sorted by their numbers, the first of A is not near the first of B.
    const std::string near_left = hit + "1,5,0,1,3\n" + hit + "1.25,9,0,1,3\n",
                      near_right = hit + "1.5,5,0,1,3\n" + hit + "1,9,0,1,3\n";
    CHECK(diff(near_left, near_right, "0.5").code == 0);
    const json differs = compare(diff(near_left, near_right, "0.25"));
    CHECK(differs["common"] == 2);
    CHECK(differs["only_a"] == 0);
    // With a search for each event among all, this takes minutes.
    std::string up, down;
    for (int i = 0; i < 100000; ++i) {
        up += hit + std::to_string(i) + ",0,0,1,3\n";
        down += hit + std::to_string(99999 - i) + ",0,0,1,3\n";
    }
    const json many = compare(diff(up, down, "0"));
    CHECK(many["equal"] == true);
    CHECK(many["common"] == 100000);
}

TEST_CASE("diff compares seeds as integers of 64 bits, and refuses changes of what is no scene") {
    const Folder folder;
    const auto summary = [&](const std::string& name, const std::string& seed) {
        return folder.write(name, R"({"state_hash": "0", "wall_s": {}, "complete": true, "seed": )" + seed + "}");
    };
    // 2^63 and 2^63 + 1 are the same double.
    const std::string a = summary("a.json", "9223372036854775808"), b = summary("b.json", "9223372036854775809");
    CHECK(run_tumble({"diff", a, a}).code == 0);
    CHECK(run_tumble({"diff", a, b}).code == 7);
    CHECK(run_tumble({"diff", b, a, "--tolerance", "1"}).code == 0);
    CHECK(run_tumble({"diff", a, a, "--set", "/seed=1"}).code == 2);
    const std::string picture = (folder / "a.png").string();
    tumble::write_png({2, 2, std::vector<std::uint8_t>(16, 255)}, picture);
    CHECK(run_tumble({"diff", picture, picture}).code == 0);
    CHECK(run_tumble({"diff", picture, picture, "--seed", "2"}).code == 2);
}

TEST_CASE("diff compares two summaries without their times") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const auto summary_of = [&](const std::string& name, const std::string& duration) {
        const std::string out = (folder / name).string();
        REQUIRE(run_tumble({"run", scene, "--no-frames", "-o", out, "--duration", duration}).code == 0);
        return out + "/summary.json";
    };
    const std::string a = summary_of("a", "0.5"), again = summary_of("again", "0.5"), longer = summary_of("c", "1");
    const Answer same = run_tumble({"diff", a, again});
    CHECK_MESSAGE(same.code == 0, same.out);
    CHECK(same.out.find("time, not compared: /wall_s/total is ") != std::string::npos);
    const Answer other = run_tumble({"diff", a, longer, "--json"});
    CHECK(other.code == 7);
    bool has_steps = false;
    const json found = compare(other);
    for (const json& value : found["different"]) {
        CHECK(value["pointer"].get<std::string>().find("wall_s") == std::string::npos);
        if (value["pointer"] == "/steps") has_steps = value["a"] == "30" && value["b"] == "60";
    }
    CHECK(has_steps);
    // One more table differs by itself, and a summary may be long.
    const std::string out = (folder / "tables").string();
    const std::string table = out + "/contacts.csv";
    REQUIRE(run_tumble({"run", scene, "--no-frames", "-o", out, "--duration", "0.5", "--contacts", table}).code == 0);
    const json tables = compare(run_tumble({"diff", a, out + "/summary.json", "--json"}));
    for (const json& value : tables["different"])
        CHECK(value["pointer"].get<std::string>().starts_with("/files/contacts/"));
    json padded = json::parse(tumble::test::read_text(a));
    padded["padding"] = std::string(std::size_t{3} << 20, 'x');
    CHECK(run_tumble({"diff", a, folder.write("padded.json", padded.dump())}).code == 7);
    CHECK(found["timings"].size() >= 4);
    CHECK(run_tumble({"diff", a, folder.write("not.json", "{")}).code == 2);
}

TEST_CASE("diff compares frames pixel by pixel and draws where they differ") {
    const Folder folder;
    const auto write = [&](const std::string& name, std::uint8_t green, int width = 4) {
        tumble::Image image{width, 2, std::vector<std::uint8_t>(static_cast<std::size_t>(8 * width), 120)};
        for (std::size_t byte = 3; byte < image.rgba.size(); byte += 4) image.rgba[byte] = 255;
        image.rgba[4 * 5 + 1] = green;  // of the pixel [1, 1] of a picture four wide
        std::filesystem::create_directories((folder / name).parent_path());
        tumble::write_png(image, folder / name);
    };
    for (const std::string name : {"frame_000000.png", "frame_000001.png"}) {
        write("a/frames/" + name, 120);
        write("b/frames/" + name, name.find('1') == std::string::npos ? 120 : 100);
    }
    const std::string a = (folder / "a").string(), b = (folder / "b").string(), map = (folder / "map.png").string();
    CHECK(run_tumble({"diff", a, a}).out == "equal: 2 frames\n");
    const Answer differs = run_tumble({"diff", a, b + "/frames", "--heat-map", map, "--json"});
    CHECK(differs.code == 7);
    const json found = compare(differs);
    CHECK(found["frames"] == 2);
    CHECK(found["differing_frames"] == 1);
    CHECK(found["first"]["frame"] == "frame_000001.png");
    CHECK(found["worst"] ==
          json::parse(R"({"frame": "frame_000001.png", "pixels": 1, "largest": 20, "x": 1, "y": 1})"));
    CHECK(run_tumble({"diff", a, b, "--tolerance", "20"}).code == 0);
    CHECK(run_tumble({"diff", a, b, "--tolerance", "19"}).code == 7);

    const tumble::Image heat = tumble::read_png(map);
    REQUIRE(heat.width == 4);
    const std::vector<std::uint8_t> pixel(heat.rgba.begin() + 20, heat.rgba.begin() + 24);
    CHECK(pixel == std::vector<std::uint8_t>{255, 235, 0, 255});  // 255 - 20
    CHECK(heat.rgba[0] == 30);                                    // (120 + 120 + 120) / 3, a quarter of it
    CHECK(run_tumble({"diff", a, b, "--heat-map", map}).code == 4);
    CHECK(run_tumble({"diff", a, b, "--heat-map", map, "--force"}).out.ends_with("heat map: " + map + "\n"));

    // No map of an earlier comparison is left if the frames are equal or cannot be read, and no frame is lost.
    CHECK(run_tumble({"diff", a, a, "--heat-map", map, "--force"}).code == 0);
    CHECK_FALSE(std::filesystem::exists(map));
    folder.write("map.png", "old");
    const std::string frame = a + "/frames/frame_000000.png", broken = folder.write("broken.png", "PNG");
    CHECK(run_tumble({"diff", frame, broken, "--heat-map", map, "--force"}).code == 3);
    CHECK_FALSE(std::filesystem::exists(map));
    CHECK(run_tumble({"diff", frame, frame, "--heat-map", frame, "--force"}).code == 2);
    CHECK(run_tumble({"diff", a, b, "--heat-map", frame, "--force"}).code == 2);
    CHECK(std::filesystem::exists(frame));

    write("a/frames/frame_000002.png", 120);
    write("b/frames/frame_000000.png", 120, 5);
    const json sizes = compare(run_tumble({"diff", a, b, "--json"}));
    CHECK(sizes["only_a"] == json{"frame_000002.png"});
    CHECK(sizes["first"]["what"] == "4x2 pixels in A, 5x2 pixels in B");
    CHECK(sizes["worst"]["frame"] == "frame_000001.png");
    CHECK(run_tumble({"diff", a + "/frames/frame_000000.png", folder.write("bad.png", "PNG")}).code == 3);
}

TEST_CASE("diff refuses a picture that is cut, or that claims more bytes than its file has") {
    const Folder folder;
    const tumble::Image image{4, 2, std::vector<std::uint8_t>(32, 120)};
    const std::string whole = (folder / "whole.png").string();
    tumble::write_png(image, whole);
    const std::string bytes = tumble::read_file(whole, 1 << 16);
    CHECK(run_tumble({"diff", whole, whole}).code == 0);
    const auto refuses = [&](const std::string& changed) {
        const Answer answer = run_tumble({"diff", whole, folder.write("changed.png", changed)});
        return answer.code == 3 && (answer.err.find("changed.png: is not a PNG file") != std::string::npos ||
                                    answer.err.find("changed.png: the PNG file is not complete") != std::string::npos);
    };
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        CAPTURE(length);
        CHECK(refuses(bytes.substr(0, length)));
    }
    std::string claims = bytes;
    claims[bytes.find("IDAT") - 4] = 0x20;  // 512 MiB
    CHECK(refuses(claims));
}
