// `run --masks --depth-order --boxes`: labels of frames, with exact numbers for a scene of a few bodies.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "process.hpp"
#include "support/near.hpp"

using nlohmann::json;
using tumble::test::absolute;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::near;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

// 20 pixels a metre, the origin in the middle of 320 x 180 pixels. The box covers half of the plate, the twins are
// copies, and the far ball is out of view.
const char* const kLabelled = R"({"format": 1, "name": "labelled",
    "world": {"gravity": [0, 0], "duration": 1, "steps_per_second": 10},
    "camera": {"center": [0, 0], "height": 9},
    "bodies": [
        {"name": "plate", "type": "static", "shapes": [{"box": {"size": [4, 2]}}]},
        {"name": "box", "position": [1, 0], "velocity": [0, 0], "shapes": [{"box": {"size": [2, 2]}}]},
        {"name": "twin", "position": [-6, 3], "repeat": {"grid": {"columns": 2, "rows": 1, "spacing": [2, 0]}},
         "shapes": [{"circle": {"radius": 0.5}}]},
        {"name": "far", "position": [100, 0], "shapes": [{"circle": {"radius": 1}}]},
        {"name": "edge", "position": [8, -3], "shapes": [{"box": {"size": [2, 1]}}]}],
    "joints": [{"type": "distance", "name": "rod", "bodies": ["twin[0]", "twin[1]"],
                "anchors": [[0, 0], [0, 0]], "collide_connected": false},
               {"type": "filter", "bodies": ["plate", "box"]}],
    "timeline": [{"at": 0.5, "despawn": "edge"}]})";

json annotation_of(const json& coco, int frame, int label) {
    for (const json& annotation : coco["annotations"])
        if (annotation["image_id"] == frame && annotation["label"] == label) return annotation;
    return {};
}

}  // namespace

TEST_CASE("labels of a run: boxes, visibility, key points, the order of drawing and the matrix of each frame") {
    const Folder folder;
    const std::string scene = folder.write("labelled.json", kLabelled), out = (folder / "out").string();
    const Answer answer = run_tumble({"run", scene, "-o", out, "--size", "320x180", "--fps", "2", "--no-frames",
                                      "--masks", "--boxes", "--depth-order", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(answer.err.empty());
    const json labels = json::parse(read_text(folder / "out/labels.json"));
    const json coco = json::parse(read_text(folder / "out/boxes.json"));

    REQUIRE(labels["frames"].size() == 3);
    CHECK(labels["width"] == 320);
    CHECK(labels["bodies"][2] == json({{"label", 3}, {"name", "twin[0]"}, {"category_id", 3}}));
    const json& first = labels["frames"][0];
    CHECK(first["mask"] == "masks/mask_000000.png");
    CHECK_FALSE(first.contains("image"));
    CHECK(first["world_to_pixels"] == json({{20.0, 0.0, 160.0}, {0.0, -20.0, 90.0}}));
    CHECK(first["order"] == json({{1, 0}, {2, 0}, {6, 0}, {3, 0}, {4, 0}}));  // static, boxes, circles; far is away
    CHECK(first["covered"] == json({{2, 1, 40 * 40}}));
    CHECK(labels["frames"][1]["step"] == 5);

    const json plate = annotation_of(coco, 0, 1), box = annotation_of(coco, 0, 2), edge = annotation_of(coco, 0, 6);
    CHECK(plate["bbox"] == json({120, 70, 40, 40}));  // of the half that the box does not cover
    CHECK(plate["area"] == 40 * 40);
    CHECK(plate["visibility"] == 0.5);
    CHECK(plate["segmentation"] == json({{120.0, 110.0, 200.0, 110.0, 200.0, 70.0, 120.0, 70.0}}));
    CHECK(box["visibility"] == 1.0);
    CHECK(edge["bbox"] == json({300, 140, 20, 20}));
    CHECK(near(edge["full_bbox"][2].get<double>(), 40.0, absolute(1e-3)));
    CHECK(annotation_of(coco, 0, 5).is_null());
    CHECK(annotation_of(coco, 2, 6).is_null());  // it is gone after 0.5 s

    const json left = annotation_of(coco, 0, 3), right = annotation_of(coco, 0, 4);
    CHECK(coco["categories"][2]["name"] == "twin");
    CHECK(coco["categories"][2]["keypoints"] == json({"rod:a", "rod:b"}));
    CHECK(left["category_id"] == 3);
    CHECK(left["keypoints"] == json({40.0, 30.0, 2, 0.0, 0.0, 0}));
    CHECK(right["keypoints"] == json({0.0, 0.0, 0, 80.0, 30.0, 2}));
    CHECK(left["num_keypoints"] == 1);
    CHECK(coco["categories"][0]["keypoints"].empty());

    const json files = json::parse(answer.out)["files"];
    CHECK(files[0]["kind"] == "masks");
    CHECK(files[0]["count"] == 3);
    CHECK(json::parse(answer.out)["view"]["from_frame"][0]["pixels_per_metre"] == 20.0);
    CHECK_FALSE(std::filesystem::exists(folder / "out/frames"));
}

TEST_CASE("a run without labels removes those of the run before, and labels are no part of checkpoints") {
    const Folder folder;
    const std::string scene = folder.write("labelled.json", kLabelled), out = (folder / "out").string();
    REQUIRE(run_tumble({"run", scene, "-o", out, "--size", "64x64", "--fps", "2", "--masks", "--boxes"}).code == 0);
    CHECK(std::filesystem::exists(folder / "out/frames/frame_000002.png"));
    CHECK(std::filesystem::exists(folder / "out/masks/mask_000002.png"));
    CHECK(json::parse(read_text(folder / "out/labels.json"))["frames"][2]["image"] == "frames/frame_000002.png");
    REQUIRE(run_tumble({"run", scene, "-o", out, "--no-frames", "--force"}).code == 0);
    CHECK_FALSE(std::filesystem::exists(folder / "out/masks/mask_000002.png"));
    CHECK_FALSE(std::filesystem::exists(folder / "out/labels.json"));
    CHECK_FALSE(std::filesystem::exists(folder / "out/boxes.json"));
    CHECK(run_tumble({"run", scene, "-o", out, "--force", "--masks", "--checkpoint", "1"}).code == 2);
    const std::string table = (folder / "out/labels.json").string();
    CHECK(run_tumble({"run", scene, "-o", out, "--force", "--no-frames", "--boxes", "--hashes", table}).code == 2);
    const std::string mask = (folder / "out/masks/hashes.csv").string();
    CHECK(run_tumble({"run", scene, "-o", out, "--force", "--no-frames", "--masks", "--hashes", mask}).code == 2);
}

TEST_CASE("the same run gives the same labels, byte for byte") {
    const Folder folder;
    const std::string scene = std::string(TUMBLE_SOURCE_DIR) + "/scenes/bridge.json";
    for (const char* const out : {"a", "b"})
        REQUIRE(run_tumble({"run", scene, "-o", (folder / out).string(), "--duration", "0.5", "--fps", "10",
                            "--no-frames", "--masks", "--boxes", "--depth-order"})
                    .code == 0);
    for (const char* const file : {"labels.json", "boxes.json", "masks/mask_000005.png"}) {
        const std::string text = read_text(folder / (std::string("a/") + file));
        CHECK(text.size() > 100);
        CHECK(text == read_text(folder / (std::string("b/") + file)));
    }
}
